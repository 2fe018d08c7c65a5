#include "common/core/motion.hpp"

#include <algorithm>

#include "common/core/unstable.hpp"

namespace sph {

void Motion::add(const Evolving& equation) {
    equations_.push_back(equation);
    for (Evolving& one : equations_) {
        one.drift = std::any_of(equations_.begin(), equations_.end(),
                                [&](const Evolving& other) { return other.value == one.rate; });
    }
    std::stable_sort(equations_.begin(), equations_.end(),
                     [](const Evolving& a, const Evolving& b) { return a.drift && !b.drift; });
}

template <class Visit>
void Motion::for_each_range(const Evolving& equation, Visit&& visit) const {
    constexpr std::size_t grain = 1 << 14;  // numbers for which waking a thread pays
    const auto on_all_threads = [&](std::size_t first, std::size_t last) {
        if (!team_) return visit(first, last);
        team_->parallel_for(
            last - first, [&](std::size_t begin, std::size_t end) { visit(first + begin, first + end); },
            grain);
    };
    const std::size_t n = equation.value->size();
    if (equation.groups) {
        equation.groups->for_each_free(n, on_all_threads);
    } else {
        on_all_threads(0, n);
    }
}

void Motion::advance(bool drifts, double dt) const {
    for (const Evolving& one : equations_) {
        if (one.drift != drifts) continue;
        for_each_range(one, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) (*one.value)[i] += dt * (*one.rate)[i];
        });
    }
}

void Motion::require_physical(double t) const {
    for (const Evolving& one : equations_) sph::require_physical(*one.value, one.name, one.positive, t);
    for (const Watched& one : watched_) sph::require_physical(*one.column, one.name, true, t);
}

void Motion::Saved::save(const Motion& motion) {
    columns_.resize(motion.equations_.size());
    for (std::size_t k = 0; k < columns_.size(); ++k)
        columns_[k].assign(motion.equations_[k].value->begin(), motion.equations_[k].value->end());
}

void Motion::Saved::restore(const Motion& motion) const {
    for (std::size_t k = 0; k < columns_.size(); ++k) *motion.equations_[k].value = columns_[k];
}

void Motion::Saved::advance(const Motion& motion, double dt) const {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const Evolving& one = motion.equations_[k];
        motion.for_each_range(one, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) (*one.value)[i] = columns_[k][i] + dt * (*one.rate)[i];
        });
    }
}

void Motion::Saved::add(const Motion& motion, double dt) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const Evolving& one = motion.equations_[k];
        motion.for_each_range(one, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) columns_[k][i] += dt * (*one.rate)[i];
        });
    }
}

}  // namespace sph
