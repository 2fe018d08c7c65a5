#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/app/command_line.hpp"
#include "common/app/files.hpp"
#include "common/plot/figure.hpp"
#include "common/report/results.hpp"
#include "common/report/text.hpp"
#include "common/report/timer.hpp"

namespace report {

/// What one run of a chapter's program collects. A figure's function gets it, computes, and hands over what
/// it measured and drew.
class Run {
  public:
    virtual ~Run() = default;
    virtual bool quick() const = 0;  ///< fewer points, for a first look and for tests
    virtual bool checking()
        const = 0;  ///< only the text is being compared: what times are measured does not matter
    virtual int threads() const = 0;
    virtual unsigned long seed() const = 0;
    /// Adds a row to results.csv; the scene is the name of the figure or scene being run.
    virtual void result(const std::string& method, long n, const std::string& quantity, double value,
                        const std::string& unit = "1") = 0;
    virtual void save(const plot::Figure& figure) = 0;  ///< draws figure.png and figure.csv
    /// A block of the README. Throws std::invalid_argument if the run has already filled it with another
    /// text.
    virtual void fill(const std::string& name, const std::string& text) = 0;
    /// Like report::time, with fewer samples if quick; a single call where only the text is being checked.
    virtual Timing time(const std::function<void()>& work) = 0;
    virtual void write(const std::string& file_name,
                       const std::string& text) = 0;  ///< into --out, atomically
    virtual void print(const std::string& text) = 0;  ///< on standard output
};

/// Where a program of figures belongs.
struct Place {
    std::string folder;            ///< below renders/, build/quick/ and build/scenes/
    std::string command;           ///< that runs it: "./tutorial run 01"
    std::string title;             ///< of its progress: "chapter 1"
    std::filesystem::path readme;  ///< whose marked blocks it fills, from the root

    /// That of a chapter's folder, "01_kernel_interpolation". Throws std::invalid_argument for another form.
    static Place of_chapter(const std::string& folder);
};

/// A chapter's program: its figures and scenes by name, its options, and the command line that all chapters
/// share (--quick --out --only --list --threads --seed --scene --help --version --update-text --check-text).
/// results.csv is written after each figure, in the book's order; a figure that is not made anew keeps its
/// rows. After a scene its rows are written and printed on standard output.
class Chapter {
  public:
    /// `folder` names the chapter ("01_kernel_interpolation"), `title` is shown by --help,
    /// `revision` identifies the source (a generated constant of the build), `root` is where renders/, build/
    /// and chapters/ lie.
    Chapter(std::string folder, std::string title, std::string revision,
            std::filesystem::path root = app::project_root());
    /// The same for figures that belong to no chapter.
    Chapter(Place place, std::string title, std::string revision,
            std::filesystem::path root = app::project_root());
    ~Chapter();
    Chapter(Chapter&&) noexcept;
    Chapter& operator=(Chapter&&) noexcept;

    /// The chapter's own options are declared on this before main() is called.
    app::CommandLine& options();
    /// A figure of the book: made by a plain run, in this order; `name` serves --only and is the scene of its
    /// rows.
    Chapter& figure(std::string name, std::string description, std::function<void(Run&)> make);
    /// A scene of the reader's own: made only by --scene NAME, with the chapter's options.
    Chapter& scene(std::string name, std::string description, std::function<void(Run&)> make);

    /// Runs the program; returns its exit status. To be called once.
    int main(int argc, const char* const* argv);

  private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace report
