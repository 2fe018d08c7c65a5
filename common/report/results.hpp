#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace report {

/// One measured number: a row of results.csv.
struct Row {
    std::string scene, method;
    long n = 0;
    std::string quantity;
    double value = 0;
    std::string unit;
};

/// The measured numbers of a run, in the order in which they were added.
class Results {
  public:
    /// Throws std::invalid_argument if a text holds a comma, quote or newline, or if `value` is not finite:
    /// a number that was not measured must not look like one.
    void add(std::string scene, std::string method, long n, std::string quantity, double value,
             std::string unit = "1");
    const std::vector<Row>& rows() const& noexcept { return rows_; }
    void rows() && = delete;  // what it refers to would be gone
    /// The value of the only row that matches. Throws std::out_of_range naming the row if there is none, or
    /// more than one.
    double value(const std::string& scene, const std::string& method, long n,
                 const std::string& quantity) const;
    /// Keeps rows of `older`, before the own ones, in their order: those whose scene has no row here, and
    /// those of another method or number of particles if both are results of the same parameters but for
    /// these.
    void merge_older(const Results& older);
    /// The scene's parameters, name and value, which csv() tells in lines "# name=value" above the header.
    std::vector<std::pair<std::string, std::string>> parameters;
    void append(const Results& more);  ///< its rows after the own ones
    /// Brings the rows into the order of their scenes in `order` (others last); rows of a scene keep theirs.
    void sort_by_scene(const std::vector<std::string>& order);
    /// "scene,method,n,quantity,value,unit" and the rows, values with 17 significant digits.
    std::string csv() const;
    static Results parse(const std::string& csv);         ///< throws std::invalid_argument naming the line
    void write(const std::filesystem::path& path) const;  ///< atomically; throws app::IoError

  private:
    std::vector<Row> rows_;
};

}  // namespace report
