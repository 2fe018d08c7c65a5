#pragma once
#include <chrono>
#include <string>

namespace app {

/// Progress of a known number of steps, on stderr: a bar that redraws itself when stderr is a terminal, and
/// one plain line a finished item otherwise. Also the place where long work notices Ctrl-C.
class Progress {
  public:
    /// `total` steps are expected in all; `title` names the work ("chapter 1").
    Progress(std::string title, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void begin(const std::string& item);   ///< what is being worked on now
    void finish(const std::string& item);  ///< one step is done; throws Interrupted after Ctrl-C
    /// The share, 0..1, of the item that is done, as often as one likes: shown after a second and then five
    /// times in a second on a terminal, otherwise as a line every ten seconds.
    void share(const std::string& item, double share);

  private:
    void draw(const std::string& item, double share = 0);
    std::string title_;
    int total_;
    int done_ = 0;
    bool terminal_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point start_, item_start_, shown_;
};

}  // namespace app
