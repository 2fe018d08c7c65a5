#include "common/report/chapter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <thread>

#include "common/app/clock.hpp"
#include "common/app/error.hpp"
#include "common/app/program.hpp"
#include "common/app/progress.hpp"
#include "common/report/chapter_run.hpp"
#include "common/report/chapter_text.hpp"
#include "common/report/entry.hpp"

namespace report {
namespace {

/// Options that do not change what a figure shows: they must not change its bytes either.
std::vector<std::string> not_of_the_figure(std::vector<std::string> more = {}) {
    more.insert(more.end(),
                {"out", "only", "scene", "list", "threads", "timed", "update-text", "check-text"});
    return more;
}

/// The word behind --name, or "".
std::string word_after(const std::string& name, int argc, const char* const* argv) {
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        if (word == name && k + 1 < argc) return argv[k + 1];
        if (word.starts_with(name + "=")) return word.substr(name.size() + 1);
    }
    return "";
}

long default_threads() {
    return std::clamp<long>(std::thread::hardware_concurrency(), 1, 256);
}

}  // namespace

struct Chapter::Implementation {
    Place place;
    std::string revision;
    std::filesystem::path root;
    app::CommandLine options;
    std::vector<Entry> figures, scenes;

    bool quick = false, list = false, update_text = false, check_text = false;
    std::string out, only, scene, timed = "all";
    long threads = default_threads(), seed = 1;

    Settings settings;
    std::optional<plot::Studio> studio;
    Told told;

    Implementation(Place where, const std::string& title, std::string source_revision,
                   std::filesystem::path root_folder)
        : place{std::move(where)},
          revision{std::move(source_revision)},
          root{std::move(root_folder)},
          options{place.folder, title} {}

    void declare_options(int argc, const char* const* argv);
    void refuse_contradictions() const;
    void refuse_foreign_options() const;
    Settings chosen_settings() const;
    std::vector<Entry> chosen_figures() const;
    void run();
    void run_scene();
    void run_figures();
    void write_results(const Results& fresh, const Results& older,
                       const std::vector<std::string>& made) const;
    Results older_results() const;
};

void Chapter::Implementation::declare_options(int argc, const char* const* argv) {
    options.flag("quick", quick, "fewer points: a first look within seconds")
        .text("out", out, "DIR",
              fmt::format("folder of figures and results; default renders/{0}, build/quick/{0} with --quick, "
                          "build/scenes/{0}/SCENE with --scene",
                          place.folder))
        .choice("only", only, names_of(figures), "make this figure only");
    // Without scenes there is nothing to choose from.
    if (!scenes.empty())
        options.choice("scene", scene, names_of(scenes), "run a scene of your own instead of the figures");
    options.flag("list", list, "list figures and scenes, and exit")
        .integer("threads", threads, 1, 256, "number of threads")
        .integer("seed", seed, 0, std::numeric_limits<long>::max(), "seed of the random numbers")
        .choice("timed", timed, {"all", "only", "none"},
                "which figures: all, those that show times, or the others")
        .flag("update-text", update_text, "after a full run, rewrite the numbers in the chapter's README.md")
        .flag("check-text", check_text,
              "compute all, draw nothing, compare the numbers in the chapter's README.md")
        .footer(fmt::format("\n{}{}{}{}", listed("Figures (--only NAME)", figures),
                            listed("Scenes (--scene NAME)", scenes), options_of(figures, "--only"),
                            options_of(scenes, "--scene")));
    // What is chosen takes its options; the others' are known, to be refused by name.
    const std::string chosen_figure = word_after("--only", argc, argv);
    const std::string chosen_scene = word_after("--scene", argc, argv);
    for (const Entry& entry : figures) {
        if (entry.name == chosen_figure && entry.task.declare) entry.task.declare(options);
    }
    for (const Entry& entry : scenes) {  // both together are refused later
        if (entry.name == chosen_scene && chosen_figure.empty() && entry.task.declare)
            entry.task.declare(options);
    }
    options.foreign();
    for (const auto* entries : {&figures, &scenes}) {
        for (const Entry& entry : *entries) {
            if (entry.task.declare) entry.task.declare(options);
        }
    }
}

/// Names who takes an option that the run does not.
void Chapter::Implementation::refuse_foreign_options() const {
    const auto given = options.refused();
    if (given.empty()) return;
    std::string takers;
    for (const auto& [entries, choice] : {std::pair{&figures, "--only "}, {&scenes, "--scene "}}) {
        for (const Entry& entry : *entries) {
            if (entry.takes(given.front().substr(2)))
                takers += (takers.empty() ? "" : ", ") + (choice + entry.name);
        }
    }
    const std::string who = !only.empty()    ? "the figure " + only
                            : !scene.empty() ? "the scene " + scene
                                             : "a run of all figures";
    throw app::UsageError{given.front() + ": " + who + " does not take it; allowed with " + takers};
}

void Chapter::Implementation::refuse_contradictions() const {
    const auto refuse = [](bool wrong, const std::string& reason) {
        if (wrong) throw app::UsageError{reason};
    };
    refuse(!only.empty() && !scene.empty(), "--only: not allowed together with --scene");
    refuse(update_text && check_text, "--update-text: not allowed together with --check-text");
    refuse(timed != "all" && (!only.empty() || !scene.empty()),
           "--timed: not allowed together with --only or --scene");
    for (const auto& [given, name] :
         {std::pair{update_text, "--update-text"}, {check_text, "--check-text"}}) {
        const std::string reason = std::string{name} + ": needs a full run, not allowed together with ";
        refuse(given && quick, reason + "--quick");
        refuse(given && timed != "all", reason + "--timed");
        refuse(given && !only.empty(), reason + "--only");
        refuse(given && !scene.empty(), reason + "--scene");
        const std::string changed = options.changed(not_of_the_figure());
        refuse(given && !changed.empty(), reason + changed + ": the text tells the defaults' numbers");
    }
}

Settings Chapter::Implementation::chosen_settings() const {
    Settings chosen{quick, check_text, static_cast<int>(threads), static_cast<unsigned long>(seed), out, {}};
    if (out.empty() && !scene.empty()) {
        chosen.out = root / "build" / "scenes" / place.folder / scene;
    } else if (out.empty()) {
        chosen.out = quick ? root / "build" / "quick" / place.folder : root / "renders" / place.folder;
    }
    const std::string changed = options.changed(not_of_the_figure());
    chosen.metadata.parameters = changed.empty() ? "default" : changed;
    chosen.metadata.revision = revision;
    return chosen;
}

/// The results of an earlier run, which a run of one figure or scene must not drop.
Results Chapter::Implementation::older_results() const {
    const auto path = settings.out / "results.csv";
    if (!std::filesystem::exists(path)) return {};
    // Reading a pipe would wait for ever; a folder would be noticed only after the first figure.
    if (!std::filesystem::is_regular_file(path)) throw app::IoError{path.string() + " is not a regular file"};
    try {
        return Results::parse(app::read_file(path));
    } catch (const std::invalid_argument& error) {
        if (only.empty() && scene.empty()) return {};  // a full run replaces the file in any case
        throw app::IoError{"cannot read " + path.string() + ": " + error.what()};
    }
}

/// Writes the fresh rows, and the older ones of figures and scenes that there still are and that have not
/// been made anew, in the book's order.
void Chapter::Implementation::write_results(const Results& fresh, const Results& older,
                                            const std::vector<std::string>& made) const {
    Results all;
    for (const auto& row : older.rows()) {
        const bool anew = std::find(made.begin(), made.end(), row.scene) != made.end();
        if (!anew && (find(figures, row.scene) || find(scenes, row.scene)))
            all.add(row.scene, row.method, row.n, row.quantity, row.value, row.unit);
    }
    all.append(fresh);
    all.sort_by_scene(names_of(figures));
    all.write(settings.out / "results.csv");
}

void Chapter::Implementation::run() {
    refuse_contradictions();
    refuse_foreign_options();
    if (list) return app::write_stdout(listed("figures", figures) + listed("scenes", scenes));
    settings = chosen_settings();
    // Nothing is worse than to learn after a long computation that its results cannot be written.
    if (!check_text) app::require_writable_folder(settings.out);
    if (scene.empty()) return run_figures();
    run_scene();
}

void Chapter::Implementation::run_scene() {
    const Entry& entry = *find(scenes, scene);
    settings.metadata.command = place.command + " --scene " + scene;
    if (settings.metadata.parameters != "default")
        settings.metadata.command += " " + settings.metadata.parameters;
    const auto parameters = options.values(not_of_the_figure());
    for (const auto& [name, value] : parameters)
        settings.metadata.csv_head += "# " + name + "=" + value + "\n";
    const Results older = older_results();
    app::Progress progress{place.title, 1};
    FigureRun figure_run{scene, true, settings, studio, told, progress};
    entry.task.make(figure_run);
    if (figure_run.results().rows().empty()) return;
    Results all = figure_run.results();
    all.parameters = parameters;
    all.merge_older(older);
    all.write(settings.out / "results.csv");
    app::write_stdout(figure_run.results().csv());
}

std::vector<Entry> Chapter::Implementation::chosen_figures() const {
    if (!only.empty()) return {*find(figures, only)};
    std::vector<Entry> chosen;
    std::copy_if(figures.begin(), figures.end(), std::back_inserter(chosen),
                 [&](const Entry& entry) { return timed == "all" || entry.timed == (timed == "only"); });
    return chosen;
}

void Chapter::Implementation::run_figures() {
    const std::vector<Entry> made = chosen_figures();
    const Results older = check_text ? Results{} : older_results();
    Results fresh;
    std::vector<std::string> finished;
    const double begin = app::process_cpu_seconds();
    app::Progress progress{place.title, static_cast<int>(made.size())};
    for (const auto& entry : made) {
        progress.begin(entry.name);
        settings.threads = entry.timed ? 1 : static_cast<int>(threads);
        settings.metadata.command = place.command + " --only " + entry.name;
        if (settings.metadata.parameters != "default")
            settings.metadata.command += " " + settings.metadata.parameters;
        FigureRun figure_run{entry.name, entry.timed, settings, studio, told, progress};
        entry.task.make(figure_run);
        fresh.append(figure_run.results());
        finished.push_back(entry.name);
        // After each figure: what is finished stays if a later one fails or Ctrl-C is pressed.
        if (!check_text) write_results(fresh, older, finished);
        progress.finish(entry.name);
    }
    const Text text{root / place.readme, root / "README.md", place.number};
    if (check_text) compare_text(text, told.blocks, told.claims);
    if (update_text) {
        rewrite_text(text.own, told.blocks);
        rewrite_seconds(text.book, place.folder, app::process_cpu_seconds() - begin);
        compare_text(text, told.blocks, told.claims);
    }
    if (!check_text && !update_text) tell_claims(told.claims, options.changed(not_of_the_figure({"quick"})));
}

Chapter::Chapter(Place place, const std::string& title, std::string revision, std::filesystem::path root)
    : self_{std::make_unique<Implementation>(std::move(place), title, std::move(revision), std::move(root))} {
}
Chapter::Chapter(const std::string& folder, const std::string& title, std::string revision,
                 std::filesystem::path root)
    : Chapter{Place::of_chapter(folder), title, std::move(revision), std::move(root)} {}
Chapter::~Chapter() = default;
Chapter::Chapter(Chapter&&) noexcept = default;
Chapter& Chapter::operator=(Chapter&&) noexcept = default;

Chapter& Chapter::figure(std::string name, std::string description, Task task) {
    self_->figures.push_back({std::move(name), std::move(description), std::move(task)});
    return *this;
}

Chapter& Chapter::timed_figure(std::string name, std::string description, Task task) {
    self_->figures.push_back({std::move(name), std::move(description), std::move(task), true});
    return *this;
}

Chapter& Chapter::scene(std::string name, std::string description, Task task) {
    self_->scenes.push_back({std::move(name), std::move(description), std::move(task)});
    return *this;
}

int Chapter::main(int argc, const char* const* argv) {
    return app::run([&] {
        self_->declare_options(argc, argv);
        if (self_->options.parse(argc, argv)) self_->run();
    });
}

}  // namespace report
