#include "common/report/prices.hpp"

namespace report {

void Prices::add(Run& run, const std::string& label, const ListedPass& listed) {
    labels_.push_back(label);
    columns_.push_back(listed.columns);
    ns_.push_back(1e9 * run.time(listed.pass).best / static_cast<double>(listed.pairs));
    run.record(label, listed.particles, {{"cpu_ns_per_pair", ns_.back(), "ns"}});
    if (with_columns_)
        run.record(label, listed.particles, {{"columns", static_cast<double>(listed.columns), "columns"}});
}

std::string Prices::table() const {
    Table table{with_columns_ ? std::vector<std::string>{"listed", "columns of a particle", "ns a pair"}
                              : std::vector<std::string>{"listed", "ns a pair"}};
    for (std::size_t k = 0; k < ns_.size(); ++k) {
        std::vector<std::string> row{labels_[k]};
        if (with_columns_) row.push_back(std::to_string(columns_[k]));
        row.push_back(timing(ns_[k]));
        table.row(row);
    }
    return table.markdown();
}

plot::Figure Prices::figure(const std::string& name, const std::string& title) const {
    plot::Figure figure{name};
    figure.panel().titled(title).labels("CPU time a pair [ns]", "").bars(labels_, ns_);
    return figure;
}

}  // namespace report
