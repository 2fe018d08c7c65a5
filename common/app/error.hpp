#pragma once
#include <stdexcept>
#include <string>

namespace app {

/// Exit status of every program of this project.
enum class ExitCode : int { done = 0, failed = 1, usage = 2, unphysical = 3, io = 4, interrupted = 130 };

/// An error that a user can act on: what() is one line, without a trailing full stop or newline.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const std::string& message) : std::runtime_error{message}, code_{code} {}
    ExitCode code() const noexcept { return code_; }

  private:
    ExitCode code_;
};

/// A wrong option or value: the message names the option, the value and the allowed range.
struct UsageError : Error {
    explicit UsageError(const std::string& message) : Error{ExitCode::usage, message} {}
};

/// A simulated state that has no physical meaning: the message names time, particle and quantity.
struct UnphysicalError : Error {
    explicit UnphysicalError(const std::string& message) : Error{ExitCode::unphysical, message} {}
};

/// A file that cannot be read or written: the message names the file and the system's reason.
struct IoError : Error {
    explicit IoError(const std::string& message) : Error{ExitCode::io, message} {}
};

/// Ctrl-C: unwinds the stack so that no temporary file stays behind.
struct Interrupted : Error {
    Interrupted() : Error{ExitCode::interrupted, "interrupted"} {}
};

}  // namespace app
