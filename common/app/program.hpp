#pragma once
#include <functional>

namespace app {

/// Runs `body` as a program: turns every exception into one line on stderr ("error: ...") and an exit status
/// (app::Error: its own; std::filesystem's: 4; std::bad_alloc, other exceptions: 1), and Ctrl-C into
/// Interrupted at the next call of check_interrupt() (the second Ctrl-C ends the program at once). What could
/// not be written to standard output is an error too, also behind a closed pipe. Every main() is one call of
/// this.
int run(const std::function<void()>& body);

/// Throws Interrupted if Ctrl-C was pressed since run() began. Cheap: one atomic load.
void check_interrupt();

}  // namespace app
