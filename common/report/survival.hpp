#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/report/chapter.hpp"

/// Hard cases: which methods finish them, and are right.
namespace report {

/// What is right: an error of at most `times` that of the contestant `reference` in the same run of the same
/// case. Where the reference does not finish, whoever does is right.
struct Judge {
    std::string reference;
    double times = 2;
};

/// A table of contestants against cases, "5/6", and bars of the share that each has passed. With a judge a
/// run has passed if it has finished and is right, and a last column counts those that finished but are
/// wrong; without one, if it has finished.
class Survival {
  public:
    /// `with_total`: a column with the sum over all cases.
    Survival(std::vector<std::string> cases, bool with_total, std::optional<Judge> judge = {});

    /// `attempt(k, r)` makes run r of `runs` of case k and returns its error; it has failed if that throws
    /// app::UnphysicalError. An error that is not a number is wrong.
    void contestant(const std::string& name, const std::string& label, std::size_t runs,
                    const std::function<double(std::size_t k, std::size_t r)>& attempt);

    /// What follows is about all contestants so far, and throws std::out_of_range if the judge's reference
    /// is not among them, or has fewer runs than another.
    ///
    /// Rows of results.csv: finished runs of "name case", and of "name all" with a total; with a judge passed
    /// ones, too.
    void record(Run& run) const;
    std::string table() const;
    plot::Figure figure(const std::string& name) const;
    /// How many runs of all cases a contestant has passed, finished, made.
    struct Count {
        std::size_t passed = 0, finished = 0, runs = 0;
        std::size_t wrong() const { return finished - passed; }
    };
    Count all_of(const std::string& contestant) const;
    /// Of one case. Throws std::out_of_range, as all_of does, for a name that is none.
    Count count(const std::string& contestant, const std::string& case_name) const;

  private:
    struct Contestant {
        std::string name, label;
        std::size_t runs;
        std::vector<std::vector<std::optional<double>>> errors;  // [case][run], of those that finished
    };
    const Contestant& find(const std::string& name) const;
    Count count(const Contestant& who, std::size_t k) const;
    Count all_of(const Contestant& who) const;
    bool is_right(double error, std::size_t k, std::size_t r) const;

    std::vector<std::string> cases_;
    bool with_total_;
    std::optional<Judge> judge_;
    std::vector<Contestant> contestants_{};
};

}  // namespace report
