#pragma once
#include <initializer_list>
#include <string>
#include <string_view>

namespace exact::program {

/// The output of every solution: `# name=value` lines with the parameters and derived constants, the columns'
/// names, and rows of numbers with the 17 significant digits that identify a double.
class Csv {
  public:
    Csv& parameter(std::string_view name, double value);
    Csv& columns(std::string_view names);  ///< "x,u"
    /// Also the place where a long table notices Ctrl-C: throws app::Interrupted.
    Csv& row(std::initializer_list<double> values);

    const std::string& text() const& noexcept { return text_; }
    void text() && = delete;  // what it refers to would be gone

  private:
    std::string text_;
};

}  // namespace exact::program
