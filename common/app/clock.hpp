#pragma once

namespace app {

/// CPU seconds that the calling thread has used so far (not wall time: other users of the machine do not
/// count).
double thread_cpu_seconds();
/// Those that work() takes.
template <class Work>
double thread_cpu_seconds(Work&& work) {
    const double begin = thread_cpu_seconds();
    work();
    return thread_cpu_seconds() - begin;
}
/// Those of all threads of the program.
double process_cpu_seconds();

}  // namespace app
