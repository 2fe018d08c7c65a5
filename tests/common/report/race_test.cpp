#include "common/report/race.hpp"

#include <catch2/catch.hpp>

#include "common/app/error.hpp"
#include "tests/common/report/fake_run.hpp"

using report::Contestant;
using report::Lap;
using report::RaceCourse;
using report::Reading;
using Kind = report::Reading::Kind;
using Rows = std::vector<std::string>;

namespace {

/// Error 1/n^2 after n seconds.
Contestant second_order(const std::string& name = "sph") {
    return {name, "SPH", {}, [](std::size_t n) {
                const auto x = static_cast<double>(n);
                return Lap{.error = 1 / (x * x), .seconds = x};
            }};
}

/// A track of given errors, at 1, 2, 4, ... seconds.
report::Track track_of(const plot::Values& errors) {
    report::Track track{second_order()};
    double seconds = 1;
    for (const double error : errors) {
        track.n.push_back(static_cast<std::size_t>(10 * seconds));
        track.error.push_back(error);
        track.seconds.push_back(seconds);
        seconds *= 2;
    }
    return track;
}

}  // namespace

TEST_CASE("a race runs every contestant at every size and keeps its rows") {
    // Fails if a row is lost, if the course's name is, or if pairs that were not counted are rows.
    FakeRun run;
    Contestant counted = second_order("grid");
    counted.run = [](std::size_t n) {
        return Lap{
            .error = 0.5, .seconds = 3, .pairs = 7.0 * static_cast<double>(n), .more = {{"l1_v", 2, "1"}}};
    };
    counted.sizes = {5};
    const RaceCourse course{.name = "wave", .sizes = {10, 20}, .quantity = "l1_rho"};
    const auto tracks = report::race(run, course, {second_order(), counted});
    CHECK(run.rows == Rows{"wave sph,10,l1_rho,0.0100,1", "wave sph,10,cpu_seconds,10.0,s",
                           "wave sph,20,l1_rho,0.00250,1", "wave sph,20,cpu_seconds,20.0,s",
                           "wave grid,5,l1_rho,0.500,1", "wave grid,5,l1_v,2.00,1",
                           "wave grid,5,pairs,35.0,1", "wave grid,5,cpu_seconds,3.00,s"});
    REQUIRE(tracks.size() == 2);
    CHECK(tracks[0].n == std::vector<std::size_t>{10, 20});
    CHECK(tracks[0].seconds == plot::Values{10, 20});
    CHECK(tracks[0].order() == Approx(2));
    CHECK(tracks[1].n == std::vector<std::size_t>{5});
    CHECK(tracks[1].pairs == plot::Values{35});
    const report::Quantities lap = tracks[1].lap(0);
    REQUIRE(lap.size() == 4);
    CHECK(lap[0].name == "l1_rho");
    CHECK(lap[3].value == 3);
    run.rows.clear();
    Contestant untimed = second_order();
    untimed.run = [](std::size_t) { return Lap{.error = 0.25}; };
    report::race(run, {.sizes = {2}}, {untimed});
    CHECK(run.rows == Rows{"sph,2,error,0.250,1"});  // neither pairs nor seconds were counted
}

TEST_CASE("the least seconds of several laps count, and where it does not matter one lap is run") {
    // Fails if the last lap's seconds count, or if a quick run takes its time.
    FakeRun run;
    int laps = 0;
    Contestant slower = second_order();
    slower.run = [&](std::size_t) {
        const std::array seconds{5.0, 3.0, 4.0};
        return Lap{.error = 1, .seconds = seconds[static_cast<std::size_t>(laps++ % 3)]};
    };
    const auto best = [&](const RaceCourse& course) {
        laps = 0;
        return report::race(run, course, {slower}).front().seconds.front();
    };
    CHECK(best({.sizes = {1}}) == 3);
    CHECK(laps == 3);
    CHECK(best({.sizes = {1}, .repeats = 2}) == 3);
    CHECK(laps == 2);
    CHECK(best({.sizes = {1}, .repeat_below = 4}) == 5);  // a long lap is run once
    CHECK(laps == 1);
    for (bool FakeRun::*why : {&FakeRun::is_quick, &FakeRun::is_checking}) {
        run.*why = true;
        CHECK(best({.sizes = {1}}) == 5);
        CHECK(laps == 1);
        run.*why = false;
    }
}

TEST_CASE("a lap that leaves physics is left out, with its reason; other errors are not caught") {
    // Fails if the whole contestant is lost, if its row stays, or if a mistake of the program is taken for
    // it.
    FakeRun run;
    Contestant fragile = second_order();
    fragile.run = [](std::size_t n) {
        if (n == 20) throw app::UnphysicalError{"p < 0 at t = 1"};
        return Lap{.error = 1.0 / static_cast<double>(n), .seconds = 1};
    };
    const auto track = report::race(run, {.sizes = {10, 20, 40}}, {fragile}).front();
    CHECK(track.n == std::vector<std::size_t>{10, 40});
    CHECK(track.error == plot::Values{0.1, 0.025});
    CHECK(track.left_out == Rows{"N = 20: p < 0 at t = 1"});
    CHECK(run.rows.size() == 4);
    fragile.run = [](std::size_t) -> Lap { throw std::out_of_range{"mistake"}; };
    CHECK_THROWS_AS(report::race(run, {.sizes = {10}}, {fragile}), std::out_of_range);
}

TEST_CASE("the seconds at which an error is reached") {
    // Between two laps on logarithmic scales: error 1/s^2 through 1 and 2 s is 1/2 at sqrt 2. Fails if the
    // scale is linear (1.67), or if a bound that no lap reaches is extrapolated.
    const auto track = track_of({1, 0.25, 1.0 / 16});
    const Reading between = track.seconds_at_error(0.5);
    CHECK(between.kind == Kind::value);
    CHECK(between.value == Approx(std::sqrt(2.0)));
    CHECK(track.seconds_at_error(0.25).value == Approx(2));
    const Reading first = track.seconds_at_error(3);
    CHECK(first.kind == Kind::at_most);  // perhaps a smaller run would do as well
    CHECK(first.value == 1);
    CHECK(track.seconds_at_error(0.01).kind == Kind::not_reached);
    CHECK(track.first_below(0.3) == 1);
    CHECK(track.first_below(0.01) == 3);
    CHECK(track_of({}).seconds_at_error(1).kind == Kind::not_reached);
}

TEST_CASE("the error that is to be had in a time") {
    // Fails if the last lap before the limit counts, without what lies between.
    const auto track = track_of({1, 0.25, 1.0 / 16});
    const Reading between = track.error_in_seconds(std::sqrt(2.0));
    CHECK(between.kind == Kind::value);
    CHECK(between.value == Approx(0.5));
    CHECK(track.error_in_seconds(0.9).kind == Kind::not_in_time);
    const Reading all = track.error_in_seconds(100);
    CHECK(all.kind == Kind::at_most);
    CHECK(all.value == 1.0 / 16);
    CHECK(track_of({}).error_in_seconds(1).kind == Kind::not_in_time);
}

TEST_CASE("an error that rises with the number of particles") {
    // Fails if the least error so far is forgotten, or if a bound is read from the rising branch.
    const auto track = track_of({0.1, 0.4, 0.05, 0.2});
    const Reading falling = track.seconds_at_error(0.1 * std::sqrt(2.0));
    CHECK(falling.kind == Kind::at_most);  // the first lap is below it already
    const Reading reached = track.seconds_at_error(0.07);
    CHECK(reached.kind == Kind::value);
    CHECK(reached.value > 2);  // on the falling branch between the second and the third lap
    CHECK(reached.value < 4);
    CHECK(track.error_in_seconds(1.5).value == 0.1);  // not what lies on the way to 0.4
    CHECK(track.error_in_seconds(6).value == 0.05);
    CHECK(track.error_in_seconds(8).value == 0.05);
}

TEST_CASE("readings as text") {
    CHECK(Reading{Kind::value, 2.44}.text() == "≈2.4");
    CHECK(Reading{Kind::value, 0.00244}.text(1000) == "≈2.4");
    CHECK(Reading{Kind::at_most, 2.44}.text() == "≤ ≈2.4");
    CHECK(Reading{}.text() == "not reached");
    CHECK(Reading{Kind::not_in_time}.text() == "≈ no run");
}

TEST_CASE("a race is drawn against seconds and against size") {
    // Fails if the axes are exchanged, or if a look is lost.
    FakeRun run;
    Contestant who = second_order();
    who.look = {.label = "SPH", .marker = plot::Marker::diamond};
    const auto tracks = report::race(run, {.sizes = {2, 4}}, {who});
    plot::Panel seconds, size;
    report::draw_error_against_seconds(seconds, tracks);
    report::draw_error_against_size(size, tracks);
    CHECK(seconds.curves.front().x == plot::Values{2, 4});
    CHECK(size.curves.front().x == plot::Values{2, 4});
    CHECK(seconds.curves.front().y == plot::Values{0.25, 0.0625});
    CHECK(size.curves.front().style.marker == plot::Marker::diamond);
}

TEST_CASE("curves that the text does not speak of are grey, under one entry of the legend") {
    // Fails if one that is spoken of loses its look, or if each of the others has an entry.
    FakeRun run;
    Contestant who = second_order("best");
    who.look = {.label = "best", .marker = plot::Marker::diamond};
    const auto tracks = report::race(run, {.sizes = {2, 4}}, {second_order("a"), who, second_order("b")});
    plot::Panel panel;
    report::draw_error_against_seconds(panel, tracks, {"best"});
    REQUIRE(panel.curves.size() == 3);
    CHECK(panel.curves[0].style.label == "the others");
    CHECK(panel.curves[1].style.label == "best");
    CHECK(panel.curves[1].style.marker == plot::Marker::diamond);
    CHECK(panel.curves[2].style.label.empty());
    CHECK(panel.curves[2].style.layer < panel.curves[1].style.layer);
}
