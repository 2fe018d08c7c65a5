#include "common/app/clock.hpp"

#include <cerrno>
#include <ctime>
#include <system_error>

namespace app {
namespace {

double seconds_of(clockid_t clock) {
    timespec now{};
    if (::clock_gettime(clock, &now) != 0)
        throw std::system_error{errno, std::generic_category(), "CPU clock"};
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double thread_cpu_seconds() {
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}
double process_cpu_seconds() {
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

}  // namespace app
