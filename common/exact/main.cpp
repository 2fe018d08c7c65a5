// The program `exact`: exact and reference solutions as CSV on standard output. The list of them is in
// program/solutions.cpp.
#include <vector>

#include "common/app/command_line.hpp"
#include "common/app/files.hpp"
#include "common/app/program.hpp"
#include "common/exact/program/solution.hpp"

int main(int argc, char** argv) {
    return app::run([&] {
        app::CommandLine line{"exact", "Exact and reference solutions as CSV on standard output."};
        line.footer("exact COMMAND --help lists the options of a solution.");
        const auto solutions = exact::program::solutions();
        std::vector<app::CommandLine*> commands;
        for (const auto& solution : solutions) {
            commands.push_back(&line.command(solution->name(), solution->description()));
            solution->declare(*commands.back());
        }
        if (!line.parse(argc, argv)) return;
        for (std::size_t k = 0; k < solutions.size(); ++k) {
            if (solutions[k]->name() != line.chosen_command()) continue;
            app::write_stdout(solutions[k]->csv(*commands[k]));
        }
    });
}
