#pragma once
#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>

#include "common/app/files.hpp"
#include "common/report/chapter.hpp"
#include "tests/common/app/child.hpp"

/// A chapter under test, its program run in a child process.
namespace book {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Something that takes an option: a figure, or a scene.
struct Wide {
    std::string name;
    double value;
    std::function<void(report::Run&)> then;
    double width = 1;

    void declare(app::CommandLine& line) {
        line.number("width", width, app::positive, "dx", "smoothing length");
        if (name == "tube") line.flag("long", is_long, "a long one");
    }
    void run(report::Run& run) const;
    bool is_long = false;
};

inline void make(report::Run& run, const std::string& name, double value, double width) {
    plot::Figure figure{name};
    figure.panel().curve({0, 1}, {0, width});
    figure.panel().labels("x", "y");
    run.record("sph", run.quick() ? 10 : 100, {{"value", value * width}});
    run.result("sph", 1, "seed", static_cast<double>(run.seed()));
    run.fill(name, report::number(value * width, 2));
    run.save(figure);
}
inline void Wide::run(report::Run& run) const {
    make(run, name, value, width);
    then(run);
}

/// A root folder with a chapter of two figures, the second one with an option and with times, and one scene,
/// whose program runs in a child process.
class Book {
  public:
    std::string readme =
        "kernels: <!-- fill kernels -->1.0<!-- end -->, errors: <!-- fill errors -->2.0<!-- end -->\n";
    std::function<void(report::Run&)> after_kernels = [](report::Run&) {};
    std::function<void(report::Run&)> after_errors = [](report::Run&) {};

    child::Outcome run(Words words) {
        app::write_file(text(), readme);
        return child::run([&] {
            const child::Arguments arguments{words};
            report::Chapter chapter{"01_test", "Chapter 1. A test.", "abc123", root()};
            chapter.figure("kernels", "the kernels", [this](report::Run& run) {
                make(run, "kernels", 1, 1);
                after_kernels(run);
            });
            chapter.timed_figure("errors", "their errors", Wide{"errors", 2, after_errors});
            chapter.scene("tube", "a tube of your own", Wide{"tube", 3, [](report::Run& run) {
                                                                 run.write("profile.csv", "x,rho\n");
                                                                 run.print("printed\n");
                                                             }});
            return chapter.main(arguments.count(), arguments.values());
        });
    }
    fs::path root() const { return folder_.path(); }
    fs::path text() const { return root() / "chapters" / "01_test" / "README.md"; }
    std::string file(const std::string& path) const { return app::read_file(root() / path); }
    bool has(const std::string& path) const { return fs::exists(root() / path); }

  private:
    child::Folder folder_;
};

inline std::string row(const std::string& scene, int n, const std::string& quantity,
                       const std::string& value) {
    return scene + ",sph," + std::to_string(n) + "," + quantity + "," + value + ",1\n";
}
inline const std::string header = "scene,method,n,quantity,value,unit\n";

}  // namespace book
