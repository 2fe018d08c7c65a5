#pragma once
#include <fcntl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

/// Programs under test run in a child process: their exit status, signals and closed files are their own.
namespace child {

struct Outcome {
    int status = -1;  ///< exit status; 128 + signal if a signal ended it
    std::string out, err;
};

/// Runs `body` in a child and collects what it prints. The child ends with body's result as its exit status.
Outcome run(const std::function<int()>& body);

/// The same for a child that a test sends signals to while it runs.
class Running {
  public:
    explicit Running(const std::function<int()>& body);
    pid_t id() const { return id_; }
    Outcome wait();

  private:
    pid_t id_ = -1;
    int out_ = -1, err_ = -1;
};

/// Waits until `condition` holds, at most ten seconds; whether it does.
bool wait_until(const std::function<bool()>& condition);

/// An argv of a program called "program".
class Arguments {
  public:
    explicit Arguments(std::vector<std::string> words);
    int count() const { return static_cast<int>(pointers_.size()) - 1; }
    const char* const* values() const { return pointers_.data(); }

  private:
    std::vector<std::string> words_;
    std::vector<const char*> pointers_;
};

/// An empty folder that is removed at the end of the scope.
class Folder {
  public:
    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();
    const std::filesystem::path& path() const { return path_; }
    std::vector<std::string> names() const;  ///< of what lies in it, sorted

  private:
    std::filesystem::path path_;
};

namespace detail {

/// A nameless file for what the child prints: unlike a pipe it cannot fill up and block the child.
inline int scratch_file() {
    char name[] = "/tmp/sph_test_XXXXXX";
    const int file = ::mkstemp(name);
    if (file < 0) throw std::runtime_error{"no scratch file"};
    ::unlink(name);
    return file;
}

inline std::string read_and_close(int file) {
    std::string text;
    char block[4096];
    ::lseek(file, 0, SEEK_SET);
    for (ssize_t count; (count = ::read(file, block, sizeof block)) > 0;)
        text.append(block, static_cast<std::size_t>(count));
    ::close(file);
    return text;
}

}  // namespace detail

inline Running::Running(const std::function<int()>& body)
    : out_{detail::scratch_file()}, err_{detail::scratch_file()} {
    std::fflush(nullptr);  // or the child would print the parent's waiting text once more
    id_ = ::fork();
    if (id_ < 0) throw std::runtime_error{"no child process"};
    if (id_ > 0) return;
    ::dup2(out_, STDOUT_FILENO);
    ::dup2(err_, STDERR_FILENO);
    int status = 99;
    try {
        status = body();
    } catch (...) {
        std::fputs("an exception left the child's body\n", stderr);
    }
    std::fflush(nullptr);
    ::_exit(status);
}

inline Outcome Running::wait() {
    int status = 0;
    ::waitpid(id_, &status, 0);
    Outcome outcome;
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.out = detail::read_and_close(out_);
    outcome.err = detail::read_and_close(err_);
    return outcome;
}

inline Outcome run(const std::function<int()>& body) {
    return Running{body}.wait();
}

inline bool wait_until(const std::function<bool()>& condition) {
    for (int k = 0; k < 1000; ++k) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    return condition();
}

inline Arguments::Arguments(std::vector<std::string> words) : words_{std::move(words)} {
    words_.insert(words_.begin(), "program");
    for (const auto& word : words_) pointers_.push_back(word.c_str());
    pointers_.push_back(nullptr);
}

inline Folder::Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "sph_test_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error{"no temporary folder"};
    path_ = name;
}
inline Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}
inline std::vector<std::string> Folder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator{path_})
        names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace child
