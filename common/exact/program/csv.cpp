#include "common/exact/program/csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "common/app/program.hpp"

namespace exact::program {

Csv& Csv::parameter(std::string_view name, double value) {
    fmt::format_to(std::back_inserter(text_), "# {}={:.17g}\n", name, value);
    return *this;
}

Csv& Csv::columns(std::string_view names) {
    text_.append(names).append("\n");
    return *this;
}

Csv& Csv::row(std::initializer_list<double> values) {
    app::check_interrupt();
    std::string_view separator = "";
    for (const double value : values) {
        fmt::format_to(std::back_inserter(text_), "{}{:.17g}", separator, value);
        separator = ",";
    }
    text_ += '\n';
    return *this;
}

}  // namespace exact::program
