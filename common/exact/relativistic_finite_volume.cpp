#include "common/exact/relativistic_finite_volume.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "common/exact/finite_volume_steps.hpp"
#include "common/exact/relativistic_hllc.hpp"
#include "common/exact/require.hpp"

namespace exact {
namespace {

constexpr const char* problem = "relativistic finite-volume solver";
constexpr double strong = 20;   ///< pressure jump over lower pressure, in a shock without slopes
constexpr double equal = 1e-6;  ///< relative difference of widths that are equal but for rounding

constexpr double one_cell = 1 + 1e-9;  ///< what a wave may cross in a step, and rounding

template <class Pointers>
auto load(const Pointers& columns, std::size_t i) {
    std::array<double, std::tuple_size_v<Pointers>> values{};
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = columns[k][i];
    return values;
}

}  // namespace

template <class Fluid>
typename Fluid::Columns RelativisticFiniteVolume<Fluid>::Columns::read(std::size_t first) const {
    typename Fluid::Columns pointers;
    for (std::size_t k = 0; k < of.size(); ++k) pointers[k] = of[k].data() + first;
    return pointers;
}
template <class Fluid>
typename Fluid::Results RelativisticFiniteVolume<Fluid>::Columns::write(std::size_t first) {
    typename Fluid::Results pointers;
    for (std::size_t k = 0; k < of.size(); ++k) pointers[k] = of[k].data() + first;
    return pointers;
}

template <class Fluid>
RelativisticFiniteVolume<Fluid>::RelativisticFiniteVolume(const Cells& initial, const Fluid& fluid,
                                                          const RelativisticFiniteVolumeOptions& options)
    : fluid_{fluid},
      options_{options},
      n_{initial.size()},
      begin_{initial.faces.empty() ? 0 : initial.faces.front()},
      width_{initial.faces.empty() ? 0 : (initial.faces.back() - begin_) / static_cast<double>(n_)},
      order_(n_ + 2 * ghosts, 1),
      primitive_{n_ + 2 * ghosts},
      next_primitive_{n_ + 2 * ghosts},
      conserved_{n_ + 2 * ghosts},
      next_conserved_{n_ + 2 * ghosts},
      west_{n_ + 2 * ghosts},
      east_{n_ + 2 * ghosts},
      flux_{n_ + 1},
      face_rate_(n_ + 1) {
    check(initial);
    for (std::size_t i = 0; i < n_; ++i) {
        const Values q = fluid_.primitive(initial.states[i]);
        const Values u = fluid_.conserved(q, relativistic::Motion{q[0]});
        for (std::size_t k = 0; k < q.size(); ++k) {
            primitive_.of[k][i + ghosts] = q[k];
            conserved_.of[k][i + ghosts] = u[k];
        }
    }
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::check(const Cells& initial) const {
    const auto& [left, right, courant, expansion] = options_;
    fluid_.check();
    require(n_ >= 2, problem, "number of cells", static_cast<double>(n_), "2 and above");
    require(initial.faces.size() == n_ + 1, problem, "number of faces",
            static_cast<double>(initial.faces.size()), "one more than there are cells");
    for (std::size_t i = 0; i < n_; ++i) {
        require(std::abs(initial.width(i) - width_) <= equal * width_, problem, "width of a cell",
                initial.width(i), "the numbers above 0 that all cells share");
        fluid_.check(initial.states[i]);
    }
    require(courant > 0 && courant <= 1, problem, "courant", courant, "(0, 1]");
    require((left == End::periodic) == (right == End::periodic), problem, "number of periodic ends", 1,
            "0, 2");
    require(left != End::inflow && right != End::inflow, problem, "inflow", 1, "two dimensions");
    require(expansion >= 0, problem, "expansion", expansion, "the numbers from 0 on");
    for (const auto& [end, x] : {std::pair{left, begin_}, std::pair{right, initial.faces.back()}}) {
        const double speed = expansion * x;
        require(std::abs(speed) <= 1, problem, "speed of an end", speed, "[-1, 1]");
        require(speed == 0 || end == End::transmissive, problem, "speed of a wall or periodic end", speed,
                "0");
    }
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::fill_ghosts() {
    const std::size_t end = n_ + ghosts;
    const auto copy = [&](std::size_t ghost, std::size_t from, bool mirrored) {
        for (auto& column : primitive_.of) column[ghost] = column[from];
        if (mirrored) primitive_.of[0][ghost] *= -1;
    };
    for (std::size_t k = 1; k <= ghosts; ++k) {
        copy(ghosts - k, steps::shown(options_.left, ghosts, ghosts + k - 1, end - k),
             options_.left == End::reflecting);
        copy(end + k - 1, steps::shown(options_.right, end - 1, end - k, ghosts + k - 1),
             options_.right == End::reflecting);
    }
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::weigh_slopes() {
    const auto q = std::as_const(primitive_).read();
    double* order = order_.data();
#pragma GCC ivdep
    for (std::size_t i = 1; i < n_ + 2 * ghosts - 1; ++i) {
        const double before = fluid_.pressure(load(q, i - 1)), after = fluid_.pressure(load(q, i + 1));
        const bool jump = std::abs(after - before) > strong * hllc::smaller(before, after);
        const bool converging = hllc::both(q[0][i - 1] > q[0][i], q[0][i] > q[0][i + 1]);
        order[i] = hllc::both(jump, converging) ? 0 : 1;
    }
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::predict(double dt) {
    const auto gas = std::as_const(primitive_).read();
    const auto west = west_.write(), east = east_.write();
    const double* order = order_.data();
    const double half = dt / 2 / (width_ * scale(time_));
    const double dv = options_.expansion * width_, v_0 = options_.expansion * begin_ - (ghosts - 0.5) * dv;
#pragma GCC ivdep
    for (std::size_t i = 1; i < n_ + 2 * ghosts - 1; ++i) {
        const Values q = load(gas, i);
        Values dq;
        for (std::size_t k = 0; k < q.size(); ++k) {
            dq[k] = order[i] * hllc::limited(gas[k][i] - gas[k][i - 1], gas[k][i + 1] - gas[k][i], 0.5, 0.5);
        }
        const Values rate = fluid_.rates(q, dq, v_0 + dv * static_cast<double>(i));
        bool keep = true;
        for (std::size_t k = 1; k < q.size(); ++k)
            keep &= q[k] + half * rate[k] - std::abs(dq[k]) / 2 > steps::least * q[k];
        for (std::size_t k = 0; k < q.size(); ++k) {
            const double mid = q[k] + half * rate[k];
            west[k][i] = keep ? mid - dq[k] / 2 : q[k];
            east[k][i] = keep ? mid + dq[k] / 2 : q[k];
        }
    }
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::solve_faces() {
    const auto left = std::as_const(east_).read(ghosts - 1), right = std::as_const(west_).read(ghosts);
    const auto flux = flux_.write();
    double* rate = face_rate_.data();
    const double per_width = 1 / (width_ * scale(time_));
    const double dv = options_.expansion * width_, v_0 = options_.expansion * begin_;
#pragma GCC ivdep
    for (std::size_t i = 0; i <= n_; ++i) {
        const auto l = relativistic::side(fluid_, load(left, i)),
                   r = relativistic::side(fluid_, load(right, i));
        const double face = v_0 + dv * static_cast<double>(i);
        const relativistic::Fan waves = relativistic::fan(l, r);
        rate[i] = hllc::larger(waves.right - face, face - waves.left) * per_width;
        const Values f = relativistic::flux(l, r, waves, face);
        for (std::size_t k = 0; k < f.size(); ++k) flux[k][i] = f[k];
    }
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::update(double dt) {
    const double before = width_ * scale(time_), after = width_ * scale(time_ + dt);
    const double kept = before / after, share = dt / after;
    for (std::size_t k = 0; k < Fluid::unknowns; ++k) {
        const double *u = conserved_.of[k].data() + ghosts, *flux = flux_.of[k].data();
        double* next = next_conserved_.of[k].data() + ghosts;
#pragma GCC ivdep
        for (std::size_t i = 0; i < n_; ++i) next[i] = kept * u[i] - share * (flux[i + 1] - flux[i]);
    }
    fluid_.recover(n_, std::as_const(next_conserved_).read(ghosts), next_primitive_.write(ghosts));
}

template <class Fluid>
bool RelativisticFiniteVolume<Fluid>::attempt(double dt) {
    predict(dt);
    solve_faces();
    rate_ = hllc::largest(face_rate_.data(), n_ + 1);
    update(dt);
    return hllc::all_positive(next_primitive_.of[1].data() + ghosts, n_);
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::advance_to(double t) {
    require(t >= time_ && std::isfinite(t), problem, "time", t, "the present one and later, finite");
    while (time_ < t) {
        fill_ghosts();
        weigh_slopes();
        if (rate_ == 0) attempt(0);
        step(t);
    }
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::step(double end) {
    double dt = options_.courant * (steps_ < steps::slow_steps ? steps::slow_start : 1) / rate_;
    for (int repeats = 0; repeats <= steps::most_repeats; ++repeats) {
        const bool last = !(dt < end - time_);
        if (last) dt = end - time_;
        if (!(time_ + dt > time_)) break;
        const bool physical = attempt(dt);
        if (physical && dt * rate_ <= one_cell) {
            accept(last ? end : time_ + dt);
            return;
        }
        ++repeated_;
        // A wave became faster than in the step before, or slopes go first and then length.
        dt = std::min(options_.courant / rate_, !physical && lowered_ ? dt / 2 : dt);
        if (!physical) lower_order();
    }
    give_up();
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::accept(double time) {
    std::swap(primitive_, next_primitive_);
    std::swap(conserved_, next_conserved_);
    time_ = time;
    ++steps_;
    lowered_ = false;
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::lower_order() {
    lowered_ = true;
    for (std::size_t i = ghosts; i < n_ + ghosts; ++i) {
        if (next_primitive_.of[1][i] > 0) continue;
        for (std::size_t k = i - ghosts; k <= i + ghosts; ++k) order_[k] = 0;
    }
}

template <class Fluid>
void RelativisticFiniteVolume<Fluid>::give_up() const {
    const auto& pressures = next_primitive_.of[1];
    std::size_t i = 0;
    while (i + 1 < n_ && pressures[i + ghosts] > 0) ++i;
    std::ostringstream text;
    text << "time " << time_ << ": cell " << i
         << " at x = " << (begin_ + (static_cast<double>(i) + 0.5) * width_) * scale(time_)
         << ": no pressure, or too fast a wave, at momentum, energy";
    if (Fluid::unknowns == 3) text << ", mass";
    for (const auto& column : next_conserved_.of) text << ' ' << column[i + ghosts];
    throw UnphysicalCell{text.str()};
}

template <class Fluid>
typename Fluid::Cells RelativisticFiniteVolume<Fluid>::cells() const {
    Cells cells{std::vector<double>(n_ + 1), std::vector<typename Fluid::State>(n_)};
    for (std::size_t i = 0; i <= n_; ++i)
        cells.faces[i] = (begin_ + width_ * static_cast<double>(i)) * scale(time_);
    for (std::size_t i = 0; i < n_; ++i) cells.states[i] = fluid_.state(load(primitive_.read(ghosts), i));
    return cells;
}

template <class Fluid>
long RelativisticFiniteVolume<Fluid>::cell_updates() const noexcept {
    return static_cast<long>(n_) * (steps_ + repeated_);
}

template <class Fluid>
double RelativisticFiniteVolume<Fluid>::total(std::size_t k) const {
    long double sum = 0;
    for (std::size_t i = ghosts; i < n_ + ghosts; ++i) sum += conserved_.of[k][i];
    return static_cast<double>(sum) * width_ * scale(time_);
}

template class RelativisticFiniteVolume<RelativisticGas>;
template class RelativisticFiniteVolume<BaryonFreeFluid>;

FluidCells half_slab(double end, std::size_t n, double outside) {
    require(end > 1, "slab", "end", end, "above 1");
    FluidCells cells{{0}, {}};
    for (std::size_t i = 0; i < n; ++i) {
        cells.faces.push_back(std::lerp(0, end, static_cast<double>(i + 1) / static_cast<double>(n)));
        const double inside = std::clamp((1 - cells.faces[i]) / cells.width(i), 0.0, 1.0);
        cells.states.push_back({std::lerp(outside, 1, inside), 0});
    }
    return cells;
}

}  // namespace exact
