#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "common/plot/layout.hpp"
#include "common/plot/save.hpp"

namespace plot {
namespace {

/// A cell of a CSV file (RFC 4180): quoted if it holds a comma, a quote or a line break.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

class Table {
  public:
    /// Adds to `text`; every row begins with `before`.
    Table(std::string& text, std::string before) : text_{text}, before_{std::move(before)} {}

    void begin(std::string_view panel, std::string_view kind, const std::string& label) {
        start_ = fmt::format("{}{},{},{}", before_, panel, kind, cell(label));
    }
    /// A row; cells of `value` and `error` stay empty without a pointer.
    void row(double x, double y, const double* value = nullptr, const double* error = nullptr) {
        auto out = std::back_inserter(text_);
        fmt::format_to(out, "{},{:.7g},{:.7g},", start_, x, y);
        if (value) fmt::format_to(out, "{:.7g}", *value);
        text_ += ',';
        if (error) fmt::format_to(out, "{:.7g}", *error);
        text_ += '\n';
    }

  private:
    std::string& text_;
    std::string before_, start_;
};

void add_fields(Table& table, const std::string& letter, const Panel& panel) {
    for (const auto& discs : panel.discs) {
        table.begin(letter, "disc", discs.name);
        for (std::size_t i = 0; i < discs.x.size(); ++i) table.row(discs.x[i], discs.y[i], &discs.value[i]);
    }
    for (const auto& field : panel.fields) {
        table.begin(letter, "field", field.name);
        for (std::size_t i = 0; i < field.value.size(); ++i)
            table.row(field.x[i % field.x.size()], field.y[i / field.x.size()], &field.value[i]);
    }
    for (const auto& arrows : panel.arrows) {
        const auto add = [&](std::string_view kind, const Values& component) {
            table.begin(letter, kind, arrows.name);
            for (std::size_t i = 0; i < arrows.x.size(); ++i)
                table.row(arrows.x[i], arrows.y[i], &component[i]);
        };
        add("arrow u", arrows.u);
        add("arrow v", arrows.v);
    }
}

void add_panel(Table& table, const std::string& letter, const Panel& panel) {
    for (const auto& curve : panel.curves) {
        table.begin(letter, "curve", curve.style.label);
        for (std::size_t i = 0; i < curve.x.size(); ++i)
            table.row(curve.x[i], curve.y[i], nullptr, curve.error.empty() ? nullptr : &curve.error[i]);
    }
    for (const auto& band : panel.bands) {
        const auto add = [&](std::string_view kind, const Values& y) {
            table.begin(letter, kind, band.label);
            for (std::size_t i = 0; i < band.x.size(); ++i) table.row(band.x[i], y[i]);
        };
        add("band low", band.low);
        add("band high", band.high);
    }
    add_fields(table, letter, panel);
}

constexpr auto csv_columns = "panel,kind,label,x,y,value,error\n";

void add_figure(Table& table, const Figure& figure) {
    for (std::size_t k = 0; k < figure.panels.size(); ++k) {
        const std::string letter = panel_letter(k);
        add_panel(table, letter.substr(1, letter.size() - 2), figure.panels[k]);
    }
}

}  // namespace

std::string data_csv(const Figure& figure) {
    std::string text = csv_columns;
    Table table{text, ""};
    add_figure(table, figure);
    return text;
}

std::string data_csv(const Animation& animation) {
    std::string text = "frame,";
    text += csv_columns;
    for (std::size_t k = 0; k < animation.frames.size(); ++k) {
        Table table{text, fmt::format("{},", k + 1)};
        add_figure(table, animation.frames[k].figure);
    }
    return text;
}

}  // namespace plot
