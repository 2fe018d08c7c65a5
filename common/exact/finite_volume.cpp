#include "common/exact/finite_volume.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "common/exact/finite_volume_frames.hpp"
#include "common/exact/finite_volume_steps.hpp"
#include "common/exact/require.hpp"

namespace exact {

using steps::problem;

FiniteVolume::FiniteVolume(const GasCells& initial, const FiniteVolumeOptions& options)
    : options_{options},
      n_{initial.size()},
      faces_{initial.faces},
      face_velocity_(n_ + 1),
      width_(n_ + 2 * ghosts),
      near_west_(n_ + 2 * ghosts),
      near_east_(n_ + 2 * ghosts),
      order_(n_ + 2 * ghosts, 1),
      gas_{n_ + 2 * ghosts},
      next_gas_{n_ + 2 * ghosts},
      conserved_{n_ + 2 * ghosts},
      next_conserved_{n_ + 2 * ghosts},
      west_{n_ + 2 * ghosts},
      east_{n_ + 2 * ghosts},
      flux_{n_ + 1},
      face_rate_(n_ + 1) {
    require(n_ >= 2, problem, "number of cells", static_cast<double>(n_), "2 and above");
    require(faces_.size() == n_ + 1, problem, "number of faces", static_cast<double>(faces_.size()),
            "one more than there are cells");
    require(options.gamma > 1 && options.gamma <= 100, problem, "gamma", options.gamma, "(1, 100]");
    require(options.courant > 0 && options.courant <= 1, problem, "courant", options.courant, "(0, 1]");
    require((options.left == End::periodic) == (options.right == End::periodic), problem,
            "number of periodic ends", 1, "0, 2");
    require(options.left != End::inflow && options.right != End::inflow, problem, "inflow", 1,
            "two dimensions");
    options.frame == Frame::eulerian ? set_cells(frames::Eulerian{options.gamma}, initial)
                                     : set_cells(frames::Lagrangian{options.gamma}, initial);
    set_widths_of_ghosts();
}

template <class InFrame>
void FiniteVolume::set_cells(const InFrame& frame, const GasCells& initial) {
    for (std::size_t i = 0; i < n_; ++i) {
        const auto& [rho, v, p] = initial.states[i];
        require(rho > 0 && std::isfinite(rho), problem, "rho", rho, "the finite numbers above 0");
        require(std::isfinite(v), problem, "v", v, "the finite numbers");
        require(p > 0 && std::isfinite(p), problem, "p", p, "the finite numbers above 0");
        require(initial.width(i) > 0, problem, "width of a cell", initial.width(i), "above 0");
        const std::size_t k = i + ghosts;
        width_[k] = frame.width(initial.width(i), rho);
        const auto [a, b, c] = frame.conserved({rho, v, p});
        conserved_.a[k] = a, conserved_.b[k] = b, conserved_.c[k] = c;
        gas_.a[k] = a, gas_.b[k] = v, gas_.c[k] = p;
    }
}

void FiniteVolume::set_widths_of_ghosts() {
    const std::size_t end = n_ + ghosts;
    const bool periodic = options_.left == End::periodic;
    for (std::size_t k = 1; k <= ghosts; ++k) {
        width_[ghosts - k] = width_[periodic ? end - k : ghosts + k - 1];
        width_[end + k - 1] = width_[periodic ? ghosts + k - 1 : end - k];
    }
    for (std::size_t i = 1; i + 1 < width_.size(); ++i) {
        near_west_[i] = width_[i] / (width_[i] + width_[i - 1]);
        near_east_[i] = width_[i] / (width_[i] + width_[i + 1]);
    }
}

void FiniteVolume::fill_ghosts() {
    const std::size_t end = n_ + ghosts;
    const auto copy = [&](std::size_t ghost, std::size_t from, bool mirrored) {
        gas_.a[ghost] = gas_.a[from];
        gas_.b[ghost] = mirrored ? -gas_.b[from] : gas_.b[from];
        gas_.c[ghost] = gas_.c[from];
    };
    for (std::size_t k = 1; k <= ghosts; ++k) {
        copy(ghosts - k, steps::shown(options_.left, ghosts, ghosts + k - 1, end - k),
             options_.left == End::reflecting);
        copy(end + k - 1, steps::shown(options_.right, end - 1, end - k, ghosts + k - 1),
             options_.right == End::reflecting);
    }
}

void FiniteVolume::advance_to(double t) {
    require(t >= time_ && std::isfinite(t), problem, "time", t, "the present one and later, finite");
    while (time_ < t) {
        fill_ghosts();
        if (options_.quiet_shocks) mark_shocks();
        if (rate_ == 0) attempt(0);
        step(t);
    }
}

void FiniteVolume::step(double end) {
    double dt = options_.courant * (steps_ < steps::slow_steps ? steps::slow_start : 1) / rate_;
    for (int repeats = 0; repeats <= steps::most_repeats; ++repeats) {
        const bool last = !(dt < end - time_);
        if (last) dt = end - time_;
        if (!(time_ + dt > time_)) break;
        const bool positive = attempt(dt);
        if (positive && dt * rate_ <= 1) {
            accept(dt, last ? end : time_ + dt);
            return;
        }
        ++repeated_;
        // A wave became faster than in the step before, or slopes go first and then length.
        dt = std::min(options_.courant / rate_, !positive && lowered_ ? dt / 2 : dt);
        if (!positive) lower_order();
    }
    give_up();
}

void FiniteVolume::accept(double dt, double time) {
    for (std::size_t i = 0; i <= n_; ++i) faces_[i] += dt * face_velocity_[i];
    std::swap(gas_, next_gas_);
    std::swap(conserved_, next_conserved_);
    time_ = time;
    ++steps_;
    if (std::exchange(lowered_, false)) std::fill(order_.begin(), order_.end(), 1);
}

// A shock is where the gas converges and the pressures on both sides differ by more than a third of the lower
// one: Colella & Woodward, J. Comput. Phys. 54 (1984) 174, appendix. From there on slopes fade out.
void FiniteVolume::mark_shocks() {
    const double *v = gas_.b.data(), *p = gas_.c.data();
    double* order = order_.data();
    for (std::size_t i = 1; i < n_ + 2 * ghosts - 1; ++i) {
        const double jump = std::abs(p[i + 1] - p[i - 1]) / hllc::smaller(p[i + 1], p[i - 1]);
        order[i] = v[i - 1] > v[i + 1] ? 1 - std::clamp(jump - 1.0 / 3, 0.0, 1.0) : 1;
    }
}

void FiniteVolume::lower_order() {
    lowered_ = true;
    for (std::size_t i = ghosts; i < n_ + ghosts; ++i) {
        if (next_gas_.a[i] > 0 && next_gas_.c[i] > 0) continue;
        for (std::size_t k = i - ghosts; k <= i + ghosts; ++k) order_[k] = 0;
    }
}

void FiniteVolume::give_up() const {
    const auto failure = [&](std::size_t i, const char* what, double value) {
        std::ostringstream text;
        text << "time " << time_ << ": cell " << i << " at x = " << (faces_[i] + faces_[i + 1]) / 2 << ": "
             << what << " " << value;
        return UnphysicalCell{text.str()};
    };
    for (std::size_t i = 0; i < n_; ++i) {
        const double a = next_gas_.a[i + ghosts], p = next_gas_.c[i + ghosts];
        if (!(a > 0)) throw failure(i, options_.frame == Frame::eulerian ? "density" : "volume per mass", a);
        if (!(p > 0)) throw failure(i, "pressure", p);
    }
    // All are positive, but waves cross one faster than any step that still moves the clock.
    const auto fastest = std::max_element(face_rate_.begin(), face_rate_.end()) - face_rate_.begin();
    throw failure(std::min(static_cast<std::size_t>(fastest), n_ - 1), "rate of crossing", rate_);
}

GasCells FiniteVolume::cells() const {
    GasCells cells{faces_, std::vector<Riemann::State>(n_)};
    for (std::size_t i = 0; i < n_; ++i) {
        const double a = gas_.a[i + ghosts];
        cells.states[i] = {options_.frame == Frame::eulerian ? a : 1 / a, gas_.b[i + ghosts],
                           gas_.c[i + ghosts]};
    }
    return cells;
}

long FiniteVolume::cell_updates() const noexcept {
    return static_cast<long>(n_) * (steps_ + repeated_);
}

double FiniteVolume::total(const std::vector<double>& density) const {
    long double sum = 0;
    for (std::size_t i = ghosts; i < n_ + ghosts; ++i)
        sum += static_cast<long double>(width_[i]) * density[i];
    return static_cast<double>(sum);
}

double FiniteVolume::mass() const {
    // In the Lagrangian frame the widths are the masses.
    return options_.frame == Frame::eulerian ? total(conserved_.a)
                                             : total(std::vector<double>(width_.size(), 1));
}
double FiniteVolume::momentum() const {
    return total(conserved_.b);
}
double FiniteVolume::energy() const {
    return total(conserved_.c);
}

}  // namespace exact
