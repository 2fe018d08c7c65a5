// ./tutorial doctor: what this build draws with and computes with, one line each.
#include <Eigen/Core>
#include <thread>

#include "common/app/command_line.hpp"
#include "common/app/files.hpp"
#include "common/app/program.hpp"
#include "common/plot/save.hpp"

int main() {
    return app::run([] {
        const plot::Studio studio;
        std::string text;
        const auto line = [&](std::string name, const std::string& value) {
            name.resize(18, ' ');
            text += name + " " + value + "\n";
        };
        line("version", app::version());
        line("compiler", __VERSION__);
        line("renderer", studio.renderer());
        line("SIMD", std::string{Eigen::SimdInstructionSetsInUse()} + ": " +
                         std::to_string(Eigen::internal::packet_traits<double>::size) + " doubles at a time");
        line("threads", std::to_string(std::thread::hardware_concurrency()));
        app::write_stdout(text);
    });
}
