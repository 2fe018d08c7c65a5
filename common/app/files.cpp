#include "common/app/files.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <system_error>

#include "common/app/error.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const std::string& reason) {
    throw IoError{"cannot " + what + ": " + reason};
}
[[noreturn]] void fail(const std::string& what, int error) {
    fail(what, std::system_category().message(error));
}

/// An open file: closed at the end of its scope.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_{number} {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }
    /// Closes now; returns 0 or errno, for network disks report a full disk only here.
    int close() {
        const int result = ::close(number_);
        number_ = -1;
        return result == 0 || errno == EINTR ? 0 : errno;  // on Linux the file is closed after EINTR too
    }

  private:
    int number_;
};

/// Holds Ctrl-C and `kill` back while a temporary file exists, so that none stays behind.
class SignalsHeldBack {
  public:
    SignalsHeldBack() {
        sigset_t signals;
        sigemptyset(&signals);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&signals, signal);
        pthread_sigmask(SIG_BLOCK, &signals, &before_);
    }
    SignalsHeldBack(const SignalsHeldBack&) = delete;
    SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;
    ~SignalsHeldBack() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  private:
    sigset_t before_{};
};

/// Writes all bytes, in as many calls as the system wants; returns 0 or errno.
int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno == EAGAIN) {  // a pipe that somebody switched to non-blocking
            pollfd ready{descriptor, POLLOUT, 0};
            ::poll(&ready, 1, -1);
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

/// A new empty file in `folder` under a name of its own. Permissions: 0666 without the umask's.
/// Not mkstemp: that makes files which only their owner can read.
struct Temporary {
    fs::path path;
    Descriptor file{-1};

    Temporary(const fs::path& folder, const std::string& what) : Temporary{create(folder, what)} {}
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    ~Temporary() {
        if (!path.empty()) ::unlink(path.c_str());
    }

  private:
    struct Created {
        fs::path path;
        int descriptor;
    };
    explicit Temporary(Created created) : path{std::move(created.path)}, file{created.descriptor} {}
    static Created create(const fs::path& folder, const std::string& what) {
        static std::atomic<unsigned> counter{0};
        while (true) {
            auto path = folder / (".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
            const int number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (number >= 0) return {std::move(path), number};
            if (errno != EEXIST && errno != EINTR) fail(what, errno);
        }
    }
};

/// What is at the path that is to be written: the file behind a link, and its permissions if it exists.
struct Target {
    fs::path path;
    bool exists = false;
    mode_t permissions = 0;
};

Target find_target(const fs::path& path, const std::string& what) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0) {
        if (errno != ENOENT) fail(what, errno);
        return {path};
    }
    Target target{path, true};
    if (S_ISLNK(status.st_mode)) {
        // Renaming over a link would replace the link: write the file that it points to.
        if (::stat(path.c_str(), &status) != 0) fail(what, "a symbolic link that leads nowhere");
        std::error_code error;
        target.path = fs::canonical(path, error);
        if (error) fail(what, error.message());
    }
    if (S_ISDIR(status.st_mode)) fail(what, "Is a directory");
    // Renaming over a device or a pipe would destroy it, and writing into it is not atomic: neither is
    // wanted.
    if (!S_ISREG(status.st_mode)) fail(what, "not a regular file");
    // Renaming needs no permission on the old file; one that is write-protected is meant to stay.
    if (::access(target.path.c_str(), W_OK) != 0) fail(what, errno);
    target.permissions = status.st_mode & 0777;
    return target;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path{"."};
}

void create_folder(const fs::path& folder, const std::string& what) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail(what, error.message());
    if (!fs::is_directory(folder, error)) fail(what, "Not a directory");
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) {
    const std::string what = "write " + path.string();
    if (!path.has_filename()) fail(what, "not the name of a file");
    create_folder(folder_of(path), what);
    const Target target = find_target(path, what);

    const SignalsHeldBack held_back;
    Temporary temporary{folder_of(target.path), what};
    const int file = temporary.file.number();
    if (const int error = write_all(file, bytes)) fail(what, error);
    if (target.exists && ::fchmod(file, target.permissions) != 0) fail(what, errno);
    // Some file systems cannot flush (EINVAL, ENOTSUP): the file is as safe there as it gets.
    if (::fsync(file) != 0 && errno != EINVAL && errno != ENOTSUP) fail(what, errno);
    if (const int error = temporary.file.close()) fail(what, error);
    if (::rename(temporary.path.c_str(), target.path.c_str()) != 0) fail(what, errno);
    temporary.path.clear();  // it has become the file
}

std::string read_file(const fs::path& path) {
    const std::string what = "read " + path.string();
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.number() < 0) fail(what, errno);
    std::string bytes;
    std::string block(1 << 16, '\0');
    while (true) {
        const ssize_t count = ::read(file.number(), block.data(), block.size());
        if (count == 0) return bytes;
        if (count > 0) {
            bytes.append(block, 0, static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            fail(what, errno);
        }
    }
}

void write_stdout(std::string_view text) {
    std::cout.flush();  // text that came another way comes first
    std::fflush(stdout);
    if (const int error = write_all(STDOUT_FILENO, text)) fail("write standard output", error);
}

void require_writable_folder(const fs::path& folder) {
    const std::string what = "write into " + folder.string();
    if (folder.empty()) fail(what, "the name of the folder is empty");
    create_folder(folder, what);
    const SignalsHeldBack held_back;
    const Temporary probe{folder, what};
}

fs::path project_root() {
    return SPH_PROJECT_ROOT;
}

}  // namespace app
