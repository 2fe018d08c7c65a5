#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "common/exact/landau.hpp"
#include "common/exact/relativistic_finite_volume.hpp"
#include "common/exact/relativistic_riemann.hpp"

/// What the tests of the relativistic finite-volume solver measure against.
namespace relativistic_reference {

using exact::BaryonFreeFluid;
using exact::End;
using exact::FluidCells;
using exact::GasCells;
using exact::RelativisticFiniteVolume;
using exact::RelativisticGas;
using Options = exact::RelativisticFiniteVolumeOptions;
using GasSolver = RelativisticFiniteVolume<RelativisticGas>;
using FluidSolver = RelativisticFiniteVolume<BaryonFreeFluid>;
using State = RelativisticGas::State;

constexpr double two_pi = 6.283185307179586;

inline Options ends(End both) {
    Options options;
    options.left = options.right = both;
    return options;
}
inline Options courant(double number) {
    Options options;
    options.courant = number;
    return options;
}
inline double velocity(double lorentz) {
    return std::sqrt((1 - 1 / lorentz) * (1 + 1 / lorentz));
}

/// A tube in |x| < 0.5 with its jump at 0, all waves inside at `time`.
struct Tube {
    double gamma, time;
    State left, right;
};
/// Source: Marti & Mueller, Living Rev. Relativity 6 (2003) 7, problems 1 and 2; 1 with p = 1e-8 for 0.
inline const Tube blast_1{5.0 / 3, 0.4, {10, 0, 13.33}, {1, 0, 1e-8}};
inline const Tube blast_2{5.0 / 3, 0.35, {1, 0, 1000}, {1, 0, 0.01}};

/// sum |f - f_exact| / sum |f_exact| over the cells.
struct Errors {
    double rho, v, p;
};
inline Errors errors(const GasCells& cells, const Tube& tube) {
    const auto& [left, right] = std::pair{tube.left, tube.right};
    const exact::RelativisticRiemann exact{
        {left.rho, left.v, left.p}, {right.rho, right.v, right.p}, tube.gamma};
    std::array<double, 3> wrong{}, all{};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto e = exact.at(cells.centre(i), tube.time);
        const std::array<double, 3> should{e.rho, e.v, e.p};
        const std::array<double, 3> is{cells.states[i].rho, cells.states[i].v, cells.states[i].p};
        for (std::size_t k = 0; k < 3; ++k) {
            wrong[k] += std::abs(is[k] - should[k]);
            all[k] += std::abs(should[k]);
        }
    }
    return {wrong[0] / all[0], wrong[1] / all[1], wrong[2] / all[2]};
}

inline GasSolver solver(const Tube& tube, std::size_t n, const Options& options = {}) {
    return {exact::uniform_tube(-0.5, 0, 0.5, n, tube.left, tube.right), RelativisticGas{tube.gamma},
            options};
}
inline Errors errors(const Tube& tube, std::size_t n, const Options& options = {}) {
    GasSolver solution = solver(tube, n, options);
    solution.advance_to(tube.time);
    return errors(solution.cells(), tube);
}

/// Landau's slab: its right half in n cells, which expand with it or stand in 0..11.
inline FluidSolver slab(std::size_t n, bool expanding) {
    const double end = expanding ? static_cast<double>(n) / static_cast<double>(n - 4) : 11;
    Options options;
    options.left = End::reflecting;
    options.expansion = expanding ? 1 / end : 0;
    options.courant = expanding ? 0.5 : 0.8;
    return {exact::half_slab(end, n), BaryonFreeFluid{}, options};
}
/// sum |s* - s*_exact| / sum s*_exact over 0 < x < 1 + t.
inline double slab_error(const FluidSolver& solution) {
    const exact::LandauSlab exact{solution.time()};
    const FluidCells cells = solution.cells();
    double wrong = 0, all = 0;
    for (std::size_t i = 0; i < cells.size() && cells.centre(i) < exact.edge(); ++i) {
        const double should = exact.at(cells.centre(i)).s_star;
        wrong += std::abs(BaryonFreeFluid{}.entropy_star(cells.states[i]) - should);
        all += should;
    }
    return wrong / all;
}

}  // namespace relativistic_reference
