#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/app/command_line.hpp"
#include "common/app/files.hpp"
#include "common/plot/animation.hpp"
#include "common/plot/figure.hpp"
#include "common/report/results.hpp"
#include "common/report/text.hpp"
#include "common/report/timer.hpp"

namespace report {

/// One measured number of a run: "l1_rho", 0.0046.
struct Quantity {
    std::string name;
    double value = 0;
    std::string unit = "1";
};
using Quantities = std::vector<Quantity>;

/// Which runs have the numbers that a claim speaks of.
enum class Needs { full_run, any_run };

/// What one run of a chapter's program collects. A figure's function gets it, computes, and hands over what
/// it measured and drew.
class Run {
  public:
    virtual ~Run() = default;
    /// Fewer points, for a first look and for tests.
    virtual bool quick() const = 0;
    /// Only the text is being compared: what times are measured does not matter.
    virtual bool checking() const = 0;
    virtual int threads() const = 0;
    virtual unsigned long seed() const = 0;
    /// Adds a row to results.csv; the scene is the name of the figure or scene being run. Only a timed figure
    /// may have rows in s or ns.
    virtual void result(const std::string& method, long n, const std::string& quantity, double value,
                        const std::string& unit = "1") = 0;
    /// Draws figure.png and figure.csv.
    virtual void save(const plot::Figure& figure) = 0;
    /// Draws animation.webp and animation.csv.
    virtual void save(const plot::Animation& animation) = 0;
    /// A block of the README. Throws std::invalid_argument if the run has already filled it with another
    /// text.
    virtual void fill(const std::string& name, const std::string& text) = 0;
    /// What the sentence between <!-- claim NAME --> and <!-- end --> in the chapter's text says, asserted
    /// with the numbers of this run. A quick run evaluates it only if its sizes suffice. A run that looks at
    /// the text (--check-text, --update-text) fails where a claim does not hold, has no sentence, or a
    /// sentence nobody asserts; any other only warns. Throws std::invalid_argument for a name that the run
    /// has asserted already.
    virtual void claim(const std::string& name, const std::function<bool()>& holds,
                       Needs needs = Needs::full_run) = 0;
    /// Like report::time, with fewer samples if quick; a single call where only the text is being checked.
    virtual Timing time(const std::function<void()>& work) = 0;
    /// Into --out, atomically.
    virtual void write(const std::string& file_name, const std::string& text) = 0;
    /// A line "# name=value" of the CSV files that the scene writes from now on, unless an option of that
    /// name has one: what a method has of its own, where no option was given.
    virtual void parameter(const std::string& name, const std::string& value) = 0;
    /// On standard output.
    virtual void print(const std::string& text) = 0;
    /// On standard error: what casts doubt on a result.
    virtual void warn(const std::string& text) = 0;
    /// Long work calls it with the share of it that is done: a bar with an estimate of the time left.
    virtual std::function<void(double share)> progress() = 0;

    /// The first if quick, else the second.
    std::vector<std::size_t> sizes(const std::vector<std::size_t>& few,
                                   const std::vector<std::size_t>& all) const {
        return quick() ? few : all;
    }
    /// The rows of one run of a method.
    void record(const std::string& method, std::size_t n, const Quantities& measured) {
        for (const Quantity& one : measured)
            result(method, static_cast<long>(n), one.name, one.value, one.unit);
    }
};

/// A figure of the book or a scene of the reader's own: what it does, and which options it takes.
struct Task {
    std::function<void(app::CommandLine&)> declare;  ///< its options; none if empty
    std::function<void(Run&)> make;

    /// Of a function make(Run&), or of an object with run(Run&), and declare(CommandLine&) where it takes
    /// options: their values are its members.
    template <class Work>
    Task(Work work) {  // NOLINT(google-explicit-constructor)
        if constexpr (std::is_invocable_v<Work&, Run&>) {
            make = std::move(work);
        } else {
            const auto owned = std::make_shared<Work>(std::move(work));
            if constexpr (requires(app::CommandLine & line) { owned->declare(line); })
                declare = [owned](app::CommandLine& line) { owned->declare(line); };
            make = [owned](Run& run) { owned->run(run); };
        }
    }
};

/// Where a program of figures belongs.
struct Place {
    std::string folder;            ///< below renders/, build/quick/ and build/scenes/
    std::string command;           ///< that runs it: "./tutorial run 01"
    std::string title;             ///< of its progress: "chapter 1"
    std::filesystem::path readme;  ///< whose marked blocks it fills, from the root
    std::string number{};          ///< of the chapter, "01", before its claims in the book's README.md

    /// That of a chapter's folder, "01_kernel_interpolation". Throws std::invalid_argument for another form.
    static Place of_chapter(const std::string& folder);
};

/// A chapter's program: its figures and scenes by name, and the command line that all chapters share
/// (--quick --out --only --list --threads --seed --scene --timed --help --version --update-text
/// --check-text). An option that the chosen figure or scene does not take is refused, with the names of those
/// that do. results.csv is written after each figure, in the book's order; a figure that is not made anew
/// keeps its rows. After a scene its rows are written and printed on standard output.
class Chapter {
  public:
    /// `folder` names the chapter ("01_kernel_interpolation"), `title` is shown by --help,
    /// `revision` identifies the source (a generated constant of the build), `root` is where renders/, build/
    /// and chapters/ lie.
    Chapter(const std::string& folder, const std::string& title, std::string revision,
            std::filesystem::path root = app::project_root());
    /// The same for figures that belong to no chapter.
    Chapter(Place place, const std::string& title, std::string revision,
            std::filesystem::path root = app::project_root());
    ~Chapter();
    Chapter(Chapter&&) noexcept;
    Chapter& operator=(Chapter&&) noexcept;

    /// A figure of the book: made by a plain run, in this order; `name` serves --only and is the scene of its
    /// rows. `--only NAME` allows the options that it takes.
    Chapter& figure(std::string name, std::string description, Task task);
    /// A figure that shows times: made on one thread, and by `tutorial figures` while nothing else runs.
    Chapter& timed_figure(std::string name, std::string description, Task task);
    /// A scene of the reader's own: made only by --scene NAME, with the options that it takes.
    Chapter& scene(std::string name, std::string description, Task task);

    /// Runs the program; returns its exit status. To be called once.
    int main(int argc, const char* const* argv);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace report
