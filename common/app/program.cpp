#include "common/app/program.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>

#include "common/app/error.hpp"

namespace app {
namespace {

// The project's only global variable: a signal handler is given no argument, so what it has to tell can only
// lie in one. Lock-free, because a handler may interrupt the holder of any lock.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void on_interrupt(int) {
    interrupted.store(true, std::memory_order_relaxed);
}

/// A signal's treatment for the length of a scope.
class SignalAction {
  public:
    SignalAction(int signal, void (*handler)(int), int flags) : signal_{signal} {
        struct sigaction action {};
        action.sa_handler = handler;
        action.sa_flags = flags;
        sigemptyset(&action.sa_mask);
        ::sigaction(signal, nullptr, &before_);
        // A program started with `nohup` or in the background keeps ignoring what its parent ignored.
        if (before_.sa_handler != SIG_IGN) ::sigaction(signal, &action, nullptr);
    }
    SignalAction(const SignalAction&) = delete;
    SignalAction& operator=(const SignalAction&) = delete;
    ~SignalAction() { ::sigaction(signal_, &before_, nullptr); }

  private:
    int signal_;
    struct sigaction before_ {};
};

/// Takes the numbers 0, 1 and 2 if the caller closed them; otherwise the next file to be opened would become
/// standard output. Opened for reading only, so that writing to them still fails and is reported.
void reserve_standard_streams() {
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(number, F_GETFD) == -1 && errno == EBADF) {
            [[maybe_unused]] const int opened = ::open("/dev/null", O_RDONLY);
        }
    }
}

/// Text that was written through the standard library may still be waiting, and may fail only now.
void flush_standard_output() {
    std::cout.flush();
    if (std::fflush(stdout) != 0 || !std::cout) throw IoError{"cannot write standard output"};
}

int report(ExitCode code, const std::string& prefix, std::string message) {
    for (char& c : message) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';  // one line, whatever is in it
    }
    std::fprintf(stderr, "%s%s\n", prefix.c_str(), message.c_str());
    return static_cast<int>(code);
}

}  // namespace

int run(const std::function<void()>& body) {
    reserve_standard_streams();
    interrupted = false;
    const SignalAction on_ctrl_c{SIGINT, on_interrupt, SA_RESTART | static_cast<int>(SA_RESETHAND)};
    // A closed pipe and a file that grows too large are reported as errors of the write, with a message.
    const SignalAction on_closed_pipe{SIGPIPE, SIG_IGN, 0};
    const SignalAction on_large_file{SIGXFSZ, SIG_IGN, 0};
    try {
        body();
        flush_standard_output();
        return static_cast<int>(ExitCode::done);
    } catch (const Interrupted& error) {
        return report(error.code(), "", error.what());
    } catch (const Error& error) {
        return report(error.code(), "error: ", error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return report(ExitCode::io, "error: ", error.what());
    } catch (const std::bad_alloc&) {
        std::fputs("error: out of memory\n", stderr);  // no string: that could need memory
    } catch (const std::exception& error) {
        return report(ExitCode::failed, "error: ", error.what());
    } catch (...) {
        std::fputs("error: unknown exception\n", stderr);
    }
    return static_cast<int>(ExitCode::failed);
}

void check_interrupt() {
    if (interrupted.load(std::memory_order_relaxed)) throw Interrupted{};
}

}  // namespace app
