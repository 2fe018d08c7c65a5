#include "chapters/06_finite_particle_method/estimates.hpp"

namespace sph {

template <int d>
void Estimates<d>::find(const Columns<d>& places, std::span<const double> h, double factor) {
    reach_.resize(h.size());
    for (std::size_t i = 0; i < h.size(); ++i) reach_[i] = factor * kernel_.support * h[i];
    neighbours_.find_around(places, reach_, x_);
}

template <int d>
void Estimates<d>::gather(std::size_t r, double h, std::size_t own) {
    const auto found = neighbours_.of(r, scratch_);
    const Vector<d> at = neighbours_.receivers()[r].x;
    near_.resize(found.count);
    near_.h = h;
    near_.self = Neighbourhood<d>::nobody;
    for (std::size_t j = 0; j < found.count; ++j) {
        const std::size_t k = found.index[j];
        const std::uint32_t owner = neighbours_.owner(k);
        const Vector<d> x = neighbours_.source_position(k);
        for (std::size_t a = 0; a < d; ++a) near_.offset[a][j] = x[a] - at[a];
        near_.mass[j] = m_[owner];
        near_.volume[j] = rho_.empty() ? 1 : m_[owner] / rho_[owner];
        if (owner == own && neighbours_.ghost(k) == nullptr) near_.self = j;
    }
}

template <int d>
void Estimates<d>::sum_densities(const Columns<d>& x, std::span<const double> h) {
    rho_.clear();
    Column rho(x[0].size());
    for (std::size_t i = 0; i < rho.size(); ++i) {
        gather(i, h[h.size() == 1 ? 0 : i], i);
        for (std::size_t t = 0; t < near_.tiles(); ++t) {
            const Vec<Tile, d> x_ji = near_.x_ji(t);
            rho[i] += (near_.m(t) * kernel_.W(dot(x_ji, x_ji).sqrt(), near_.h)).sum();
        }
    }
    rho_ = std::move(rho);
}

template <int d>
double Estimates<d>::take_row(std::size_t r, std::size_t i, double h, bool own) {
    gather(r, h, own ? i : Neighbourhood<d>::nobody);
    row_.resize(near_.tiles() * tile_width);
    const double condition = estimator_->coefficients(near_, kernel_, row_);
    const auto found = neighbours_.of(r, scratch_);
    rows_.begin(i);
    for (std::size_t j = 0; j < near_.count; ++j) {
        std::array<double, derivatives<d>> c;
        bool any = false;
        for (std::size_t k = 0; k < c.size(); ++k) {
            c[k] = row_.of(k)[j];
            any = any || c[k] != 0;
        }
        const Ghost<d>* image = neighbours_.ghost(found.index[j]);
        // A neighbour on the edge of the support has W = 0.
        if (any) rows_.add(neighbours_.owner(found.index[j]), image == nullptr ? 1 : -1, c);
    }
    return condition;
}

template <int d>
void Estimates<d>::enlarge(const Columns<d>& places, std::span<const double> h, bool own) {
    enlarged_.flagged += flagged_.size();
    double factor = 1;
    for (int round = 0; round < rounds && !flagged_.empty(); ++round) {
        factor *= growth;
        Columns<d> at;
        Column larger;
        for (const std::size_t i : flagged_) {
            for (std::size_t a = 0; a < d; ++a) at[a].push_back(places[a][i]);
            larger.push_back(factor * h[h.size() == 1 ? 0 : i]);
        }
        find(at, larger, 1);
        std::vector<std::size_t> still;
        for (std::size_t r = 0; r < flagged_.size(); ++r) {
            const double condition = take_row(r, flagged_[r], larger[r], own);
            if (!(condition <= largest_condition)) {
                still.push_back(flagged_[r]);
            } else {
                enlarged_.worst_condition = std::max(enlarged_.worst_condition, condition);
                enlarged_.largest_factor = std::max(enlarged_.largest_factor, factor);
            }
        }
        flagged_ = std::move(still);
    }
    enlarged_.left += flagged_.size();
}

template <int d>
const Rows<d>& Estimates<d>::fit(const Columns<d>& places, std::span<const double> h, bool own) {
    const std::size_t n = places[0].size();
    rows_.reset(n);
    flagged_.clear();
    conditions_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double condition = conditions_[i] = take_row(i, i, h[h.size() == 1 ? 0 : i], own);
        if (!(condition <= largest_condition))
            flagged_.push_back(i);
        else
            enlarged_.worst_condition = std::max(enlarged_.worst_condition, condition);
    }
    if (!flagged_.empty()) enlarge(places, h, own);
    return rows_;
}

template <int d>
const Rows<d>& Estimates<d>::at_particles(const Columns<d>& x, std::span<const double> m,
                                          std::span<const double> h) {
    x_ = x;
    m_.assign(m.begin(), m.end());
    find(x, h, 1);
    if (estimator_->needs_volumes()) sum_densities(x, h);
    return fit(x, h, true);
}

template <int d>
const Rows<d>& Estimates<d>::at(const Columns<d>& places, std::span<const double> h) {
    find(places, h, 1);
    return fit(places, h, false);
}

template class Estimates<1>;
template class Estimates<2>;
template class Estimates<3>;

}  // namespace sph
