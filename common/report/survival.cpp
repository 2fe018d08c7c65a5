#include "common/report/survival.hpp"

#include "common/app/error.hpp"

namespace report {
namespace {

std::vector<std::string> header_of(const std::vector<std::string>& cases, bool with_total) {
    std::vector<std::string> cells{"runs finished"};
    cells.insert(cells.end(), cases.begin(), cases.end());
    if (with_total) cells.emplace_back("all");
    return cells;
}

std::string share(std::size_t part, std::size_t whole) {
    return std::to_string(part) + "/" + std::to_string(whole);
}

bool finishes(const std::function<void(std::size_t, std::size_t)>& attempt, std::size_t k, std::size_t r) {
    try {
        attempt(k, r);
        return true;
    } catch (const app::UnphysicalError&) {
        return false;
    }
}

}  // namespace

Survival::Survival(std::vector<std::string> cases, bool with_total)
    : cases_{std::move(cases)}, with_total_{with_total}, table_{header_of(cases_, with_total)} {}

void Survival::contestant(Run& run, const std::string& name, const std::string& label, std::size_t runs,
                          const std::function<void(std::size_t, std::size_t)>& attempt) {
    std::vector<std::string> row{label};
    std::size_t all = 0;
    for (std::size_t k = 0; k < cases_.size(); ++k) {
        std::size_t finished = 0;
        for (std::size_t r = 0; r < runs; ++r) finished += finishes(attempt, k, r) ? 1 : 0;
        all += finished;
        run.record(name + " " + cases_[k], runs, {{"finished", static_cast<double>(finished), "runs"}});
        row.push_back(share(finished, runs));
    }
    const std::size_t possible = runs * cases_.size();
    if (with_total_) {
        row.push_back(share(all, possible));
        run.record(name + " all", possible, {{"finished", static_cast<double>(all), "runs"}});
    }
    table_.row(row);
    labels_.push_back(label);
    shares_.push_back(100.0 * static_cast<double>(all) / static_cast<double>(possible));
}

plot::Figure Survival::figure(const std::string& name) const {
    plot::Figure figure{name};
    figure.panel().labels("runs finished [%]", "").x_range(0, 105).bars(labels_, shares_);
    return figure;
}

}  // namespace report
