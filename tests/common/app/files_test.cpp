#include "common/app/files.hpp"

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "common/app/error.hpp"
#include "common/app/program.hpp"
#include "tests/common/app/child.hpp"

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

std::string io_error(const std::function<void()>& work) {
    try {
        work();
    } catch (const app::IoError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("a file is written whole, folders included") {
    // Fails if text mode changes a byte, if a zero byte ends the text, or if the temporary file stays.
    const child::Folder folder;
    const fs::path path = folder.path() / "a" / "b" / "file.bin";
    std::string bytes(100000, '\0');
    for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<char>(k * 7);
    app::write_file(path, bytes);
    CHECK(app::read_file(path) == bytes);
    app::write_file(path, "");
    CHECK(app::read_file(path).empty());
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator{path.parent_path()}) ++count;
    CHECK(count == 1);
}

TEST_CASE("permissions are the usual ones, and an existing file keeps its own") {
    // Fails with mkstemp, whose files nobody else may read.
    const child::Folder folder;
    const fs::path path = folder.path() / "file";
    const mode_t before = ::umask(0027);
    app::write_file(path, "new");
    ::umask(before);
    const auto mode = [&] { return static_cast<unsigned>(fs::status(path).permissions()); };
    CHECK(mode() == 0640);
    fs::permissions(path, static_cast<fs::perms>(0604));
    app::write_file(path, "newer");
    CHECK(mode() == 0604);
}

TEST_CASE("a failed write leaves the old file and nothing else") {
    // Fails if the file is opened for writing in place, if a short write is taken for a whole one, or if the
    // temporary file is not removed. The limit on the size of files stands for a full disk.
    const child::Folder folder;
    const fs::path path = folder.path() / "file";
    app::write_file(path, "old");
    const auto outcome = child::run([&] {
        return app::run([&] {
            const rlimit limit{10000, 10000};
            ::setrlimit(RLIMIT_FSIZE, &limit);
            app::write_file(path, std::string(20000, 'x'));
        });
    });
    CHECK(outcome.status == 4);
    CHECK(outcome.err == "error: cannot write " + path.string() + ": File too large\n");
    CHECK(app::read_file(path) == "old");
    CHECK(folder.names() == Names{"file"});
}

TEST_CASE("a full disk leaves the old file and nothing else") {
    // As before, on a disk of 64 kB where the test may mount one.
    const child::Folder folder;
    if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0) {
        WARN("skipped: no permission to mount a small disk");
        return;
    }
    const fs::path path = folder.path() / "file";
    app::write_file(path, "old");
    const std::string message = io_error([&] { app::write_file(path, std::string(200000, 'x')); });
    const std::string old = app::read_file(path);
    const Names names = folder.names();
    ::umount(folder.path().c_str());
    CHECK(message == "cannot write " + path.string() + ": No space left on device");
    CHECK(old == "old");
    CHECK(names == Names{"file"});
}

TEST_CASE("what is not a regular file is not replaced") {
    // Fails if a pipe or a folder is renamed over. A pipe of the test's own: were the guard broken, a device
    // in /dev would be lost to the whole machine.
    const child::Folder folder;
    const fs::path pipe = folder.path() / "pipe", inner = folder.path() / "inner";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    fs::create_directory(inner);
    CHECK(io_error([&] { app::write_file(pipe, "x"); }) ==
          "cannot write " + pipe.string() + ": not a regular file");
    CHECK(io_error([&] { app::write_file(inner, "x"); }) ==
          "cannot write " + inner.string() + ": Is a directory");
    CHECK(fs::is_fifo(pipe));
    CHECK(folder.names() == Names{"inner", "pipe"});
}

TEST_CASE("a link stays a link") {
    // Fails if the link itself is renamed over.
    const child::Folder folder;
    const fs::path file = folder.path() / "file", link = folder.path() / "link",
                   lost = folder.path() / "lost";
    app::write_file(file, "old");
    fs::create_symlink("file", link);
    fs::create_symlink("nowhere", lost);
    app::write_file(link, "new");
    CHECK(fs::is_symlink(link));
    CHECK(app::read_file(file) == "new");
    CHECK_THAT(io_error([&] { app::write_file(lost, "x"); }),
               Catch::EndsWith("a symbolic link that leads nowhere"));
}

TEST_CASE("unusual names") {
    // Fails if the temporary file's name is built from a name that is already as long as names may be.
    const child::Folder folder;
    const std::string longest(255, 'n'), odd = "a b\n'\"\\";
    app::write_file(folder.path() / longest, "x");
    app::write_file(folder.path() / odd, "y");
    CHECK(app::read_file(folder.path() / longest) == "x");
    CHECK(app::read_file(folder.path() / odd) == "y");
    CHECK_THAT(io_error([&] { app::write_file(folder.path() / std::string(256, 'n'), "x"); }),
               Catch::EndsWith("File name too long"));
    CHECK_THAT(io_error([&] { app::write_file("", "x"); }), Catch::Contains("cannot write"));
    CHECK(folder.names().size() == 2);
}

TEST_CASE("folders that cannot be written to are found before the work") {
    // Fails if only the folder's existence is checked.
    const child::Folder folder;
    const fs::path file = folder.path() / "file", locked = folder.path() / "locked";
    app::write_file(file, "x");
    CHECK_THAT(io_error([&] { app::require_writable_folder(file / "inner"); }),
               Catch::Contains("Not a directory"));
    CHECK_THAT(io_error([&] { app::require_writable_folder(file); }), Catch::Contains("cannot write into"));
    CHECK_THAT(io_error([&] { app::write_file(file / "x", "x"); }), Catch::Contains("Not a directory"));
    CHECK_THAT(io_error([&] { app::require_writable_folder("/proc/sph"); }), Catch::Contains("/proc/sph"));
    app::require_writable_folder(folder.path() / "new" / "er");
    CHECK(fs::is_empty(folder.path() / "new" / "er"));

    fs::create_directory(locked);
    fs::permissions(locked, static_cast<fs::perms>(0500));
    const auto outcome = child::run([&] {
        return app::run([&] {
            // To the superuser nothing is locked: the child becomes somebody else.
            fs::permissions(folder.path(), static_cast<fs::perms>(0755));
            if (::geteuid() == 0 && ::setuid(65534) != 0) throw std::runtime_error{"still the superuser"};
            app::require_writable_folder(locked);
        });
    });
    CHECK(outcome.status == 4);
    CHECK(outcome.err == "error: cannot write into " + locked.string() + ": Permission denied\n");
    fs::permissions(locked, static_cast<fs::perms>(0700));
}

TEST_CASE("files that cannot be read") {
    // Fails if a folder is read as an empty file.
    const child::Folder folder;
    CHECK(io_error([&] { app::read_file(folder.path() / "none"); }) ==
          "cannot read " + (folder.path() / "none").string() + ": No such file or directory");
    CHECK_THAT(io_error([&] { app::read_file(folder.path()); }), Catch::EndsWith("Is a directory"));
}

TEST_CASE("a full disk, a closed pipe and a closed stream behind standard output are errors") {
    // Fails if SIGPIPE ends the program without a word, or if a failed write goes unnoticed.
    const auto print = [](const std::function<void()>& prepare, const std::function<void()>& write) {
        return child::run([&] {
            prepare();
            return app::run(write);
        });
    };
    const auto full_disk = [] { ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO); };
    const auto closed_pipe = [] {
        int ends[2];
        if (::pipe(ends) != 0) return;
        ::dup2(ends[1], STDOUT_FILENO);
        ::close(ends[0]);
        ::close(ends[1]);
    };
    const auto closed = [] { ::close(STDOUT_FILENO); };
    const auto write = [] { app::write_stdout("text\n"); };

    const auto full = print(full_disk, write);
    CHECK(full.status == 4);
    CHECK(full.err == "error: cannot write standard output: No space left on device\n");
    const auto pipe = print(closed_pipe, write);
    CHECK(pipe.status == 4);
    CHECK(pipe.err == "error: cannot write standard output: Broken pipe\n");
    const auto none = print(closed, write);
    CHECK(none.status == 4);
    CHECK(none.err == "error: cannot write standard output: Bad file descriptor\n");
    const auto by_printf = print(full_disk, [] { std::printf("text\n"); });
    CHECK(by_printf.status == 4);
}

TEST_CASE("a file never becomes standard output") {
    // Fails if a closed stream's number is left to the next file that is opened.
    const child::Folder folder;
    const fs::path path = folder.path() / "file";
    const auto outcome = child::run([&] {
        ::close(STDOUT_FILENO);
        return app::run([&] {
            const int file = ::open(path.c_str(), O_WRONLY | O_CREAT, 0600);
            app::write_stdout("printed");
            ::close(file);
        });
    });
    CHECK(outcome.status == 4);
    CHECK(app::read_file(path).empty());
}

TEST_CASE("the project's root holds the project") {
    // Fails if the folder is not handed over by CMake.
    CHECK(fs::exists(app::project_root() / "common" / "app" / "files.hpp"));
}
