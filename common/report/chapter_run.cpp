#include "common/report/chapter_run.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "common/app/clock.hpp"
#include "common/app/files.hpp"
#include "common/app/program.hpp"

namespace report {

FigureRun::FigureRun(std::string scene, bool timed, const Settings& settings,
                     std::optional<plot::Studio>& studio, Told& told, app::Progress& progress)
    : scene_{std::move(scene)},
      timed_{timed},
      settings_{settings},
      metadata_{settings.metadata},
      studio_{studio},
      told_{told},
      progress_{progress} {}

/// Times of a figure that runs beside others would be wrong.
void FigureRun::require_timed(bool is_time, const std::string& what) const {
    if (is_time && !timed_)
        throw std::logic_error{scene_ + ": " + what + " is a time, so this must be a timed_figure"};
}

void FigureRun::result(const std::string& method, long n, const std::string& quantity, double value,
                       const std::string& unit) {
    app::check_interrupt();  // a figure hands over results often enough for Ctrl-C to be noticed here
    require_timed(unit == "s" || unit == "ns", quantity);
    results_.add(scene_, method, n, quantity, value, unit);
}

template <class Drawing>
void FigureRun::save_drawing(const Drawing& drawing) {
    app::check_interrupt();
    if (settings_.check_text) return;
    if (!studio_) studio_.emplace();
    studio_->save(drawing, settings_.out, metadata_);
}

void FigureRun::save(const plot::Figure& figure) {
    save_drawing(figure);
}

void FigureRun::save(const plot::Animation& animation) {
    save_drawing(animation);
}

void FigureRun::fill(const std::string& name, const std::string& text) {
    require_timed(text.find("≈") != std::string::npos, "the text " + name);
    const auto [place, added] = told_.blocks.emplace(name, text);
    if (!added && place->second != text)
        throw std::invalid_argument{"the text " + name + " is filled twice, with different contents"};
}

void FigureRun::claim(const std::string& name, const std::function<bool()>& holds, Needs needs) {
    const bool skipped = quick() && needs == Needs::full_run;
    const Verdict verdict = skipped ? Verdict::skipped : holds() ? Verdict::holds : Verdict::fails;
    if (!told_.claims.emplace(name, verdict).second)
        throw std::invalid_argument{"the claim " + name + " is asserted twice"};
}

Timing FigureRun::time(const std::function<void()>& work) {
    require_timed(true, "what it measures");
    if (settings_.check_text) {
        const double start = app::thread_cpu_seconds();
        work();
        const double seconds = app::thread_cpu_seconds() - start;
        return {seconds, seconds, 1};
    }
    return settings_.quick ? report::time(work, 3, 0.002) : report::time(work, 5, 0.004);
}

void FigureRun::write(const std::string& file_name, const std::string& text) {
    if (settings_.check_text) return;
    app::write_file(settings_.out / file_name,
                    file_name.ends_with(".csv") ? metadata_.csv_head + text : text);
}

void FigureRun::parameter(const std::string& name, const std::string& value) {
    const std::string begin = "# " + name + "=";
    if (("\n" + metadata_.csv_head).find("\n" + begin) == std::string::npos)
        metadata_.csv_head += begin + value + "\n";
}

void FigureRun::print(const std::string& text) {
    if (!settings_.check_text) app::write_stdout(text);
}

void FigureRun::warn(const std::string& text) {
    fmt::print(stderr, "warning: {}\n", text);
}

std::function<void(double)> FigureRun::progress() {
    return [this](double share) { progress_.share(scene_, share); };
}

}  // namespace report
