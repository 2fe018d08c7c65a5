#include "common/app/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "common/app/program.hpp"

namespace app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// "0.4 s", "12 s", "2 min 05 s"
std::string duration(double seconds) {
    char text[64];
    if (seconds < 9.95) {
        std::snprintf(text, sizeof text, "%.1f s", seconds);
    } else if (seconds < 99.5) {
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    } else {
        const long whole = static_cast<long>(seconds + 0.5);
        std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
    }
    return text;
}

bool can_redraw() {
    const char* kind = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) == 1 && kind && std::string_view{kind} != "dumb";
}

std::size_t terminal_width() {
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

Progress::Progress(std::string title, int total)
    : title_{std::move(title)},
      total_{total},
      terminal_{can_redraw()},
      start_{Clock::now()},
      item_start_{start_},
      shown_{start_} {}

Progress::~Progress() {
    if (terminal_ && drawn_) std::fputc('\n', stderr);  // what follows begins on a line of its own
}

void Progress::begin(const std::string& item) {
    item_start_ = Clock::now();
    if (terminal_) draw(item);
}

void Progress::finish(const std::string& item) {
    ++done_;
    total_ = std::max(total_, done_);
    if (terminal_) {
        draw(item);
    } else {
        std::fprintf(stderr, "%s: %s done (%d/%d, %s)\n", title_.c_str(), item.c_str(), done_, total_,
                     duration(seconds_since(item_start_)).c_str());
    }
    check_interrupt();
}

void Progress::share(const std::string& item, double share) {
    constexpr double first_terminal = 1, then_terminal = 0.2, plain = 10;
    const bool started = seconds_since(item_start_) > (terminal_ ? first_terminal : plain);
    if (!(share > 0) || !started || seconds_since(shown_) < (terminal_ ? then_terminal : plain)) return;
    shown_ = Clock::now();
    if (terminal_) return draw(item, share);
    const double elapsed = seconds_since(item_start_);
    std::fprintf(stderr, "%s: %s %.0f %%, %s, about %s left\n", title_.c_str(), item.c_str(), 100 * share,
                 duration(elapsed).c_str(), duration(elapsed / share * (1 - share)).c_str());
}

void Progress::draw(const std::string& item, double share) {
    constexpr int cells = 24;
    const double done = std::min(done_ + share, static_cast<double>(total_));
    const int filled = total_ > 0 ? static_cast<int>(cells * done / total_) : cells;
    const double elapsed = seconds_since(start_);
    std::string line = title_ + " [" + std::string(static_cast<std::size_t>(filled), '#') +
                       std::string(static_cast<std::size_t>(cells - filled), '.') + "] " +
                       std::to_string(done_) + "/" + std::to_string(total_) + " " + item + ", " +
                       duration(elapsed);
    // The rest is guessed from the mean so far: a guess is not worth showing before anything is done.
    if (done > 0 && done < total_) line += ", about " + duration(elapsed / done * (total_ - done)) + " left";
    // A line that wraps could not be redrawn in place.
    line.resize(std::min(line.size(), terminal_width() - 1));
    std::fprintf(stderr, "\r%s\033[K", line.c_str());
    std::fflush(stderr);
    drawn_ = true;
}

}  // namespace app
