#include "common/report/race.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/app/error.hpp"
#include "common/plot/method_looks.hpp"
#include "common/report/norms.hpp"

namespace report {
namespace {

std::string row_name(const RaceCourse& course, const Contestant& who) {
    return course.name.empty() ? who.name : course.name + " " + who.name;
}

/// y at x between two points, on logarithmic scales.
double between(double x0, double y0, double x1, double y1, double x) {
    return y0 * std::pow(y1 / y0, std::log(x / x0) / std::log(x1 / x0));
}

Lap best_lap(Run& run, const RaceCourse& course, const Contestant& who, std::size_t n) {
    Lap best = who.run(n);
    const bool again =
        best.seconds > 0 && best.seconds < course.repeat_below && !run.quick() && !run.checking();
    for (int repeat = 1; again && repeat < course.repeats; ++repeat)
        best.seconds = std::min(best.seconds, who.run(n).seconds);
    return best;
}

Track follow(Run& run, const RaceCourse& course, const Contestant& who) {
    Track track{who, course.quantity};
    const std::string name = row_name(course, who);
    for (const std::size_t n : who.sizes.empty() ? course.sizes : who.sizes) {
        try {
            const Lap lap = best_lap(run, course, who, n);
            track.n.push_back(n);
            track.error.push_back(lap.error);
            track.seconds.push_back(lap.seconds);
            track.pairs.push_back(lap.pairs);
            track.more.push_back(lap.more);
            run.record(name, n, track.lap(track.n.size() - 1));
        } catch (const app::UnphysicalError& failure) {
            track.left_out.push_back("N = " + std::to_string(n) + ": " + failure.what());
        }
    }
    return track;
}

/// Those that are spoken of in their own looks, the others in grey, the first of these with a label.
std::vector<std::pair<const Track*, plot::Style>> looks_of(const std::vector<Track>& tracks,
                                                           const std::vector<std::string>& spoken_of) {
    std::vector<std::pair<const Track*, plot::Style>> looks;
    std::string label = "the others";
    for (const Track& track : tracks) {
        const bool own = spoken_of.empty() ||
                         std::find(spoken_of.begin(), spoken_of.end(), track.who.name) != spoken_of.end();
        looks.emplace_back(&track, own ? track.who.look : plot::rest(std::exchange(label, own ? label : "")));
    }
    return looks;
}

}  // namespace

std::string Reading::text(double factor) const {
    if (kind == Kind::not_reached) return never_reached;
    if (kind == Kind::not_in_time) return no_run;
    return (kind == Kind::at_most ? "≤ " : "") + timing(factor * value);
}

Reading Track::seconds_at_error(double bound) const {
    const std::size_t k = first_below(bound);
    if (k == n.size()) return {};
    if (k == 0) return {Reading::Kind::at_most, seconds[0]};
    return {Reading::Kind::value, between(error[k - 1], seconds[k - 1], error[k], seconds[k], bound)};
}

Reading Track::error_in_seconds(double limit) const {
    if (n.empty() || seconds[0] > limit) return {Reading::Kind::not_in_time};
    double least = error[0];
    for (std::size_t k = 1; k < n.size(); ++k) {
        if (seconds[k] > limit) {
            const double there = between(seconds[k - 1], error[k - 1], seconds[k], error[k], limit);
            return {Reading::Kind::value, std::min(least, there)};
        }
        least = std::min(least, error[k]);
    }
    return {Reading::Kind::at_most, least};
}

Quantities Track::lap(std::size_t k) const {
    Quantities all{{quantity, error[k]}};
    all.insert(all.end(), more[k].begin(), more[k].end());
    if (pairs[k] > 0) all.push_back({"pairs", pairs[k]});
    if (seconds[k] > 0) all.push_back({"cpu_seconds", seconds[k], "s"});
    return all;
}

std::size_t Track::first_below(double bound) const {
    return static_cast<std::size_t>(
        std::find_if(error.begin(), error.end(), [&](double e) { return e <= bound; }) - error.begin());
}

double Track::order() const {
    return fitted_order(sizes(), error);
}

std::vector<Track> race(Run& run, const RaceCourse& course, const std::vector<Contestant>& contestants) {
    std::vector<Track> tracks;
    for (const Contestant& who : contestants) tracks.push_back(follow(run, course, who));
    return tracks;
}

void draw_error_against_seconds(plot::Panel& panel, const std::vector<Track>& tracks,
                                const std::vector<std::string>& spoken_of) {
    for (const auto& [track, look] : looks_of(tracks, spoken_of))
        panel.curve(track->seconds, track->error, look);
}

void draw_error_against_size(plot::Panel& panel, const std::vector<Track>& tracks,
                             const std::vector<std::string>& spoken_of) {
    for (const auto& [track, look] : looks_of(tracks, spoken_of))
        panel.curve(track->sizes(), track->error, look);
}

}  // namespace report
