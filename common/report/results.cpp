#include "common/report/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "common/app/files.hpp"

namespace report {
namespace {

constexpr std::string_view header = "scene,method,n,quantity,value,unit";

std::string name_of(const std::string& scene, const std::string& method, long n,
                    const std::string& quantity) {
    return fmt::format("{},{},{},{}", scene, method, n, quantity);
}

template <class T>
bool read(std::string_view word, T& value) {
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    return result.ec == std::errc{} && result.ptr == word.data() + word.size();
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

Row parse_row(const std::string& line) {
    const auto cells = split(line, ',');
    if (cells.size() != 6) throw std::invalid_argument{"six values are needed"};
    Row row{cells[0], cells[1], 0, cells[3], 0, cells[5]};
    if (!read(cells[2], row.n)) throw std::invalid_argument{"n is not a whole number"};
    if (!read(cells[4], row.value)) throw std::invalid_argument{"the value is not a number"};
    return row;
}

}  // namespace

void Results::add(std::string scene, std::string method, long n, std::string quantity, double value,
                  std::string unit) {
    for (const auto* text : {&scene, &method, &quantity, &unit}) {
        if (text->find_first_of(",\"\n\r") != std::string::npos)
            throw std::invalid_argument{"results: a comma, quote or newline in \"" + *text + "\""};
    }
    if (!std::isfinite(value))
        throw std::invalid_argument{"results: " + name_of(scene, method, n, quantity) + " is not finite"};
    rows_.push_back({std::move(scene), std::move(method), n, std::move(quantity), value, std::move(unit)});
}

double Results::value(const std::string& scene, const std::string& method, long n,
                      const std::string& quantity) const {
    const Row* found = nullptr;
    for (const auto& row : rows_) {
        if (row.scene != scene || row.method != method || row.n != n || row.quantity != quantity) continue;
        if (found) throw std::out_of_range{"results: more than one " + name_of(scene, method, n, quantity)};
        found = &row;
    }
    if (!found) throw std::out_of_range{"results: no " + name_of(scene, method, n, quantity)};
    return found->value;
}

void Results::merge_older(const Results& older) {
    const auto common = [](const Results& results) {
        auto left = results.parameters;
        std::erase_if(left,
                      [](const auto& one) { return one.first == "particles" || one.first == "method"; });
        return left;
    };
    const bool alike = common(*this) == common(older);
    std::set<std::string> own;
    std::set<std::tuple<std::string, std::string, long>> runs;
    for (const auto& row : rows_) own.insert(row.scene), runs.emplace(row.scene, row.method, row.n);
    std::vector<Row> rows;
    std::copy_if(older.rows_.begin(), older.rows_.end(), std::back_inserter(rows), [&](const Row& row) {
        return !own.contains(row.scene) || (alike && !runs.contains({row.scene, row.method, row.n}));
    });
    rows_.insert(rows_.begin(), rows.begin(), rows.end());
}

void Results::append(const Results& more) {
    rows_.insert(rows_.end(), more.rows_.begin(), more.rows_.end());
}

void Results::sort_by_scene(const std::vector<std::string>& order) {
    const auto place = [&](const Row& row) { return std::find(order.begin(), order.end(), row.scene); };
    std::stable_sort(rows_.begin(), rows_.end(),
                     [&](const Row& a, const Row& b) { return place(a) < place(b); });
}

std::string Results::csv() const {
    std::string text;
    for (const auto& [name, value] : parameters) text += "# " + name + "=" + value + "\n";
    text += std::string{header} + "\n";
    for (const auto& row : rows_)
        text += fmt::format("{},{},{},{},{:.17g},{}\n", row.scene, row.method, row.n, row.quantity, row.value,
                            row.unit);
    return text;
}

Results Results::parse(const std::string& csv) {
    Results results;
    auto lines = split(csv, '\n');
    if (lines.back().empty()) lines.pop_back();  // after the last newline
    bool in_rows = false;
    for (std::size_t k = 0; k < std::max<std::size_t>(lines.size(), 1); ++k) {
        try {
            std::string line = lines.empty() ? "" : lines[k];
            if (line.ends_with('\r')) line.pop_back();
            if (!in_rows && line.starts_with("# ") && line.find('=') != std::string::npos) {
                results.parameters.emplace_back(line.substr(2, line.find('=') - 2),
                                                line.substr(line.find('=') + 1));
                continue;
            }
            if (!in_rows && line != header)
                throw std::invalid_argument{"the header must be " + std::string{header}};
            if (!std::exchange(in_rows, true)) continue;
            Row row = parse_row(line);
            results.add(std::move(row.scene), std::move(row.method), row.n, std::move(row.quantity),
                        row.value, std::move(row.unit));
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument{fmt::format("line {}: {}", k + 1, error.what())};
        }
    }
    return results;
}

void Results::write(const std::filesystem::path& path) const {
    app::write_file(path, csv());
}

}  // namespace report
