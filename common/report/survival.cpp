#include "common/report/survival.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/app/error.hpp"

namespace report {
namespace {

std::string share(const Survival::Count& count) {
    return std::to_string(count.passed) + "/" + std::to_string(count.runs);
}

std::optional<double> error_of(const std::function<double(std::size_t, std::size_t)>& attempt, std::size_t k,
                               std::size_t r) {
    try {
        return attempt(k, r);
    } catch (const app::UnphysicalError&) {
        return {};
    }
}

}  // namespace

Survival::Survival(std::vector<std::string> cases, bool with_total, std::optional<Judge> judge)
    : cases_{std::move(cases)}, with_total_{with_total}, judge_{std::move(judge)} {}

void Survival::contestant(const std::string& name, const std::string& label, std::size_t runs,
                          const std::function<double(std::size_t, std::size_t)>& attempt) {
    Contestant who{name, label, runs, {}};
    for (std::size_t k = 0; k < cases_.size(); ++k) {
        who.errors.emplace_back();
        for (std::size_t r = 0; r < runs; ++r) who.errors.back().push_back(error_of(attempt, k, r));
    }
    contestants_.push_back(std::move(who));
}

const Survival::Contestant& Survival::find(const std::string& name) const {
    const auto found = std::find_if(contestants_.begin(), contestants_.end(),
                                    [&](const Contestant& one) { return one.name == name; });
    if (found == contestants_.end()) throw std::out_of_range{"no contestant " + name};
    return *found;
}

bool Survival::is_right(double error, std::size_t k, std::size_t r) const {
    if (!judge_) return true;
    const std::optional<double> reference = find(judge_->reference).errors[k].at(r);
    return !reference || error <= judge_->times * *reference;
}

Survival::Count Survival::count(const Contestant& who, std::size_t k) const {
    Count count{.runs = who.runs};
    for (std::size_t r = 0; r < who.runs; ++r) {
        const std::optional<double> error = who.errors[k][r];
        if (!error) continue;
        ++count.finished;
        if (is_right(*error, k, r)) ++count.passed;
    }
    return count;
}

Survival::Count Survival::all_of(const Contestant& who) const {
    Count all;
    for (std::size_t k = 0; k < cases_.size(); ++k) {
        const Count one = count(who, k);
        all.passed += one.passed, all.finished += one.finished, all.runs += one.runs;
    }
    return all;
}

Survival::Count Survival::all_of(const std::string& contestant) const {
    return all_of(find(contestant));
}

Survival::Count Survival::count(const std::string& contestant, const std::string& case_name) const {
    const auto place = std::find(cases_.begin(), cases_.end(), case_name);
    if (place == cases_.end()) throw std::out_of_range{"no case " + case_name};
    return count(find(contestant), static_cast<std::size_t>(place - cases_.begin()));
}

void Survival::record(Run& run) const {
    const auto add = [&](const std::string& name, const Count& count) {
        Quantities measured{{"finished", static_cast<double>(count.finished), "runs"}};
        if (judge_) measured.push_back({"passed", static_cast<double>(count.passed), "runs"});
        run.record(name, count.runs, measured);
    };
    for (const Contestant& who : contestants_) {
        for (std::size_t k = 0; k < cases_.size(); ++k) add(who.name + " " + cases_[k], count(who, k));
        if (with_total_) add(who.name + " all", all_of(who));
    }
}

std::string Survival::table() const {
    std::vector<std::string> titles{judge_ ? "runs passed" : "runs finished"};
    titles.insert(titles.end(), cases_.begin(), cases_.end());
    if (with_total_) titles.emplace_back("all");
    if (judge_) titles.emplace_back("finished, but wrong");
    Table table{titles};
    for (const Contestant& who : contestants_) {
        std::vector<std::string> row{who.label};
        for (std::size_t k = 0; k < cases_.size(); ++k) row.push_back(share(count(who, k)));
        const Count all = all_of(who);
        if (with_total_) row.push_back(share(all));
        if (judge_) row.push_back(std::to_string(all.wrong()));
        table.row(row);
    }
    return table.markdown();
}

plot::Figure Survival::figure(const std::string& name) const {
    std::vector<std::string> labels;
    plot::Values shares;  // [%]
    for (const Contestant& who : contestants_) {
        const Count all = all_of(who);
        labels.push_back(who.label);
        shares.push_back(100.0 * static_cast<double>(all.passed) / static_cast<double>(all.runs));
    }
    plot::Figure figure{name};
    figure.panel()
        .labels(judge_ ? "runs passed [%]" : "runs finished [%]", "")
        .x_range(0, 105)
        .bars(labels, shares);
    return figure;
}

}  // namespace report
