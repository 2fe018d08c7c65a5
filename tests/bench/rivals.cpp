#include "tests/bench/rivals.hpp"

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

constexpr double alpha = 1, beta = 2, softening = 0.01;

/// What both directions of a pair have in common.
template <int d, class Kernel>
struct PairTerms {
    double x[d], W, F, approach, Pi;
    bool inside;

    PairTerms(const Structure<d>& i, const Structure<d>& j, double h) {
        double r2 = 0;
        for (int a = 0; a < d; ++a) {
            x[a] = i.x[a] - j.x[a];
            r2 += x[a] * x[a];
        }
        inside = r2 < Kernel::support * Kernel::support * h * h;
        // Of a pair outside nothing else is read.
        // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject)
        if (!inside) return;
        const double r = std::sqrt(r2);
        W = Kernel::W(r, h);
        F = r > 0 ? Kernel::F(r, h) : 0.0;
        approach = 0;
        for (int a = 0; a < d; ++a) approach += (i.v[a] - j.v[a]) * x[a];
        Pi = 0;
        if (approach < 0) {
            const double mu = h * approach / (r2 + softening * h * h);
            Pi = mu * (beta * mu - alpha * 0.5 * (i.c_s + j.c_s)) / (0.5 * (i.rho + j.rho));
        }
    }
};

template <int d, class Kernel>
void add_to(Structure<d>& i, const Structure<d>& j, const PairTerms<d, Kernel>& pair, double sign) {
    const double P_i = i.p / (i.rho * i.rho);
    const double mF = j.m * pair.F;
    const double force = sign * mF * (P_i + j.p / (j.rho * j.rho) + pair.Pi);
    i.rho_sum += j.m * pair.W;
    i.drho_dt += mF * pair.approach;
    for (int a = 0; a < d; ++a) i.dv_dt[a] -= force * pair.x[a];
    i.du_dt += mF * (P_i + 0.5 * pair.Pi) * pair.approach;
}

}  // namespace

template <int d>
void Rivals<d>::add(S& i, const S& j) const {
    const PairTerms<d, Kernel> pair{i, j, h_};
    if (pair.inside) add_to(i, j, pair, 1);
}

template <int d>
void Rivals<d>::add_both(S& i, S& j) const {
    const PairTerms<d, Kernel> pair{i, j, h_};
    if (!pair.inside) return;
    add_to(i, j, pair, 1);
    if (&i != &j && !j.ghost) add_to(j, i, pair, -1);
}

template <int d>
Rivals<d>::Rivals(const Gas<d>& gas) : h_{gas.smoothing.h}, cells_{axis_cells(gas.smoothing.reach())} {
    width_ = gas.smoothing.reach();
    const auto& neighbours = gas.neighbours;
    const auto& p = gas.particles;
    // In the order in which the particles were made, ghosts behind them, as a code that knows no cells holds
    // them.
    std::vector<std::size_t> source(neighbours.sources());
    for (std::size_t k = 0; k < source.size(); ++k) source[k] = k;
    std::stable_sort(source.begin(), source.end(), [&](std::size_t a, std::size_t b) {
        const bool ghost_a = neighbours.ghost(a) != nullptr, ghost_b = neighbours.ghost(b) != nullptr;
        return ghost_a != ghost_b ? ghost_b : !ghost_a && neighbours.owner(a) < neighbours.owner(b);
    });
    std::vector<std::uint32_t> place(source.size());
    for (std::size_t n = 0; n < source.size(); ++n) {
        const std::size_t k = source[n];
        const std::uint32_t owner = neighbours.owner(k);
        place[k] = static_cast<std::uint32_t>(n);
        S s{};
        for (std::size_t a = 0; a < d; ++a) {
            s.x[a] = neighbours.source_position(k)[a];
            s.v[a] = p.v[a][owner];
        }
        s.m = p.m[owner];
        s.rho = p.rho[owner];
        s.p = p.p[owner];
        s.c_s = p.c_s[owner];
        s.owner = owner;
        s.ghost = neighbours.ghost(k) != nullptr;
        unsorted_.push_back(s);
    }
    std::size_t all = 1;
    for (int a = 0; a < d; ++a) all *= static_cast<std::size_t>(cells_);
    first_.assign(all, -1);
    for (std::size_t n = 0; n < unsorted_.size(); ++n) {
        unsorted_[n].next = first_[cell_of(unsorted_[n])];
        first_[cell_of(unsorted_[n])] = static_cast<std::int32_t>(n);
    }
    sorted_ = unsorted_;
    std::stable_sort(sorted_.begin(), sorted_.end(),
                     [&](const S& a, const S& b) { return cell_of(a) < cell_of(b); });
    start_.assign(all + 1, 0);
    for (const S& s : sorted_) ++start_[cell_of(s) + 1];
    for (std::size_t c = 0; c < all; ++c) start_[c + 1] += start_[c];
    // The engine's own list, in the places of the unsorted structures' cells order.
    std::vector<std::uint32_t> sorted_place(sorted_.size());
    {
        std::vector<std::uint32_t> order(unsorted_.size());
        for (std::size_t n = 0; n < order.size(); ++n) order[n] = static_cast<std::uint32_t>(n);
        std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return cell_of(unsorted_[a]) < cell_of(unsorted_[b]);
        });
        for (std::size_t k = 0; k < order.size(); ++k) sorted_place[order[k]] = static_cast<std::uint32_t>(k);
    }
    std::vector<std::vector<std::uint32_t>> lists(sorted_.size());
    sph::Indices scratch;
    for (std::size_t r = 0; r < neighbours.receivers().size(); ++r) {
        const auto [index, count] = neighbours.of(r, scratch);
        const std::uint32_t i = sorted_place[neighbours.receivers()[r].index];
        for (std::size_t k = 0; k < count; ++k) lists[i].push_back(sorted_place[place[index[k]]]);
    }
    for (std::size_t i = 0; i < lists.size(); ++i) {
        list_start_.push_back(list_.size());
        half_start_.push_back(half_.size());
        for (const std::uint32_t j : lists[i]) {
            list_.push_back(j);
            if (j >= i || sorted_[j].ghost) half_.push_back(j);
        }
    }
    list_start_.push_back(list_.size());
    half_start_.push_back(half_.size());
}

template <int d>
std::size_t Rivals<d>::cell_of(const S& s) const {
    std::size_t index = 0;
    for (int a = d - 1; a >= 0; --a) {
        const int c = static_cast<int>(std::floor(s.x[a] / width_)) + 1;
        index =
            index * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(std::clamp(c, 0, cells_ - 1));
    }
    return index;
}

/// Calls visit(cell, cells in a row) for the rows of cells around a particle.
template <int d>
template <class Visit>
void Rivals<d>::for_each_cell_around(const S& s, Visit&& visit) const {
    const auto n = static_cast<std::ptrdiff_t>(cells_);
    const auto centre = static_cast<std::ptrdiff_t>(cell_of(s));
    for (std::ptrdiff_t k = d == 3 ? -1 : 0; k <= (d == 3 ? 1 : 0); ++k) {
        for (std::ptrdiff_t j = -1; j <= 1; ++j)
            visit(static_cast<std::size_t>(centre + (k * n + j) * n - 1));
    }
}

template <int d>
void Rivals<d>::clear() {
    for (S& s : *used_) {
        s.rho_sum = s.drho_dt = s.du_dt = 0;
        for (double& component : s.dv_dt) component = 0;
    }
}

template <int d>
void Rivals<d>::linked_list() {
    used_ = &unsorted_;
    clear();
    for (S& i : unsorted_) {
        if (i.ghost) continue;
        for_each_cell_around(i, [&](std::size_t row) {
            for (std::size_t cell = row; cell < row + 3; ++cell) {
                for (std::int32_t j = first_[cell]; j >= 0; j = unsorted_[static_cast<std::size_t>(j)].next)
                    add(i, unsorted_[static_cast<std::size_t>(j)]);
            }
        });
    }
}

template <int d>
void Rivals<d>::sorted_cells() {
    used_ = &sorted_;
    clear();
    for (S& i : sorted_) {
        if (i.ghost) continue;
        for_each_cell_around(i, [&](std::size_t row) {
            for (std::size_t j = start_[row]; j < start_[row + 3]; ++j) add(i, sorted_[j]);
        });
    }
}

template <int d>
void Rivals<d>::from_list() {
    used_ = &sorted_;
    clear();
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
        for (std::size_t k = list_start_[i]; k < list_start_[i + 1]; ++k) add(sorted_[i], sorted_[list_[k]]);
    }
}

template <int d>
void Rivals<d>::from_half_list() {
    used_ = &sorted_;
    clear();
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
        for (std::size_t k = half_start_[i]; k < half_start_[i + 1]; ++k)
            add_both(sorted_[i], sorted_[half_[k]]);
    }
}

template <int d>
double Rivals<d>::worst_difference(const GasParticles<d>& engine) const {
    double difference = 0, largest = 0;
    const auto compare = [&](double value, double expected) {
        difference = std::max(difference, std::abs(value - expected));
        largest = std::max(largest, std::abs(expected));
    };
    for (const S& s : *used_) {
        if (s.ghost) continue;
        compare(s.rho_sum, engine.rho[s.owner]);
        compare(s.drho_dt, engine.drho_dt[s.owner]);
        compare(s.du_dt, engine.du_dt[s.owner]);
        for (std::size_t a = 0; a < d; ++a) compare(s.dv_dt[a], engine.dv_dt[a][s.owner]);
    }
    return difference / largest;
}

template class Rivals<2>;
template class Rivals<3>;

}  // namespace bench
