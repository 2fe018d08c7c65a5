#include "common/app/program.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <regex>
#include <thread>

#include "common/app/error.hpp"
#include "common/app/files.hpp"
#include "common/app/progress.hpp"
#include "tests/common/app/child.hpp"

namespace {

child::Outcome run(const std::function<void()>& body) {
    return child::run([&] { return app::run(body); });
}

void sleep_ms(int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds{milliseconds});
}

}  // namespace

TEST_CASE("every exception becomes one line and an exit status") {
    // Each line fails if its handler is removed or its status changed.
    const auto check = [](const std::function<void()>& body, int status, const std::string& err) {
        const auto outcome = run(body);
        CHECK(outcome.status == status);
        CHECK(outcome.err == err);
    };
    check([] {}, 0, "");
    check([] { throw app::UsageError{"--x: no"}; }, 2, "error: --x: no\n");
    check([] { throw app::UnphysicalError{"p < 0 at t = 1"}; }, 3, "error: p < 0 at t = 1\n");
    check([] { throw app::IoError{"cannot write x"}; }, 4, "error: cannot write x\n");
    check([] { throw app::Error{app::ExitCode::failed, "no"}; }, 1, "error: no\n");
    check([] { throw app::Interrupted{}; }, 130, "interrupted\n");
    check([] { throw std::bad_alloc{}; }, 1, "error: out of memory\n");
    check([] { throw std::runtime_error{"two\nlines\t\x1b[2J"}; }, 1, "error: two lines  [2J\n");
    check([] { throw 1; }, 1, "error: unknown exception\n");
    check([] { static_cast<void>(std::filesystem::file_size("/none")); }, 4,
          "error: filesystem error: cannot get file size: No such file or directory [/none]\n");
}

TEST_CASE("Ctrl-C is noticed at the next check, and a second one ends the program") {
    // Fails if the handler is not installed, or without SA_RESETHAND.
    CHECK(run([] {
              ::raise(SIGINT);
              app::check_interrupt();
          }).status == 130);
    CHECK(run([] {
              ::raise(SIGINT);
              ::raise(SIGINT);
          }).status == 128 + SIGINT);
    CHECK(run([] { app::check_interrupt(); }).status == 0);
}

TEST_CASE("an earlier Ctrl-C does not stop a later run, and handlers are put back") {
    // Fails if the flag is not cleared, or if run() leaves its handler behind.
    const auto outcome = child::run([] {
        app::run([] { ::raise(SIGINT); });
        if (app::run([] { app::check_interrupt(); }) != 0) return 1;
        ::raise(SIGINT);
        return 2;
    });
    CHECK(outcome.status == 128 + SIGINT);
}

TEST_CASE("a program in the background keeps ignoring Ctrl-C") {
    // Fails if run() overrides what the parent ignored.
    const auto outcome = child::run([] {
        std::signal(SIGINT, SIG_IGN);
        return app::run([] {
            ::raise(SIGINT);
            app::check_interrupt();
        });
    });
    CHECK(outcome.status == 0);
}

TEST_CASE("progress prints a plain line a finished item where nobody watches") {
    // Fails if control characters are printed into a file.
    const auto outcome = run([] {
        app::Progress progress{"chapter 1", 2};
        progress.begin("kernels");
        progress.finish("kernels");
        progress.begin("errors");
        progress.finish("errors");
    });
    const std::regex lines{
        "chapter 1: kernels done \\(1/2, [0-9.]+ s\\)\nchapter 1: errors done \\(2/2, [0-9.]+ s\\)\n"};
    CHECK(std::regex_match(outcome.err, lines));
}

TEST_CASE("the share of an item that is done is told only of long work where nobody watches") {
    // Fails if every call prints a line: long work may tell its share at each of a million steps.
    const auto outcome = run([] {
        app::Progress progress{"chapter 1", 1};
        progress.begin("tube");
        for (int k = 0; k < 1000; ++k) progress.share("tube", k / 1000.0);
        progress.finish("tube");
    });
    CHECK(std::regex_match(outcome.err, std::regex{"chapter 1: tube done \\(1/1, [0-9.]+ s\\)\n"}));
}

TEST_CASE("progress redraws one line on a terminal") {
    // Fails if each step prints a line of its own, if the line wraps, or if the next text continues the bar.
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0) {  // a bare root without /dev/pts
        WARN("there are no pseudo-terminals here: not tested");
        return;
    }
    REQUIRE((::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0));
    const winsize size{24, 70, 0, 0};
    ::ioctl(terminal, TIOCSWINSZ, &size);
    child::run([&] {
        ::setenv("TERM", "xterm", 1);
        ::dup2(::open(::ptsname(terminal), O_RDWR | O_NOCTTY), STDERR_FILENO);
        return app::run([] {
            app::Progress progress{"chapter 1", 2};
            progress.begin("kernels");
            sleep_ms(20);
            progress.finish("kernels");
            progress.begin("a name that is much too long for one line of this terminal, and goes on");
        });
    });
    std::string shown;
    std::array<char, 4096> text{};
    // A terminal hands over what it holds piece by piece, and fails once the other side is closed.
    for (ssize_t count = 0; (count = ::read(terminal, text.data(), text.size())) > 0;)
        shown.append(text.data(), static_cast<std::size_t>(count));
    ::close(terminal);
    REQUIRE(!shown.empty());
    const std::string clear = "\x1b[K", seconds = "[0-9.]+ s";
    const std::string begun = "\rchapter 1 \\[\\.{24}\\] 0/2 kernels, " + seconds + "\x1b\\[K";
    const std::string done = "\rchapter 1 \\[#{12}\\.{12}\\] 1/2 kernels, " + seconds + ", about " + seconds;
    CHECK(std::regex_search(shown, std::regex{begun}));
    CHECK(std::regex_search(shown, std::regex{done}));
    CHECK_THAT(shown, Catch::EndsWith("1/2 a name that is much too long" + clear + "\r\n"));
    CHECK(std::count(shown.begin(), shown.end(), '\n') == 1);
}

TEST_CASE("Ctrl-C during long work leaves whole files") {
    // Fails if finish() does not check, if a file is written in place, or if the status is not 130.
    const child::Folder folder;
    const std::string text(300000, 'x');
    child::Running program{[&] {
        return app::run([&] {
            app::Progress progress{"work", 1000};
            for (int k = 0; k < 1000; ++k) {
                progress.begin(std::to_string(k));
                app::write_file(folder.path() / std::to_string(k), text);
                progress.finish(std::to_string(k));
                sleep_ms(1);
            }
        });
    }};
    REQUIRE(child::wait_until([&] { return folder.names().size() > 3; }));
    ::kill(program.id(), SIGINT);
    const auto outcome = program.wait();
    CHECK(outcome.status == 130);
    CHECK_THAT(outcome.err, Catch::EndsWith("interrupted\n"));
    const auto names = folder.names();
    CHECK(names.size() < 1000);
    for (const auto& name : names) {
        CHECK(name.front() != '.');
        CHECK(app::read_file(folder.path() / name) == text);
    }
}

TEST_CASE("two Ctrl-C while files are written leave no temporary file") {
    // Fails if signals are not held back while a temporary file exists.
    const child::Folder folder;
    child::Running program{[&] {
        return app::run([&] {
            for (int k = 0; k < 2000; ++k) app::write_file(folder.path() / "file", std::string(300000, 'x'));
        });
    }};
    REQUIRE(child::wait_until([&] { return std::filesystem::exists(folder.path() / "file"); }));
    // Many: two that arrive during one slow write are one to the system.
    for (int k = 0; k < 100; ++k) {
        ::kill(program.id(), SIGINT);
        sleep_ms(3);
    }
    CHECK(program.wait().status == 128 + SIGINT);
    CHECK(folder.names() == std::vector<std::string>{"file"});
}
