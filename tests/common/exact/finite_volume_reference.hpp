#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "common/exact/finite_volume.hpp"

/// What the tests of the finite-volume solvers measure against.
namespace finite_volume_reference {

using exact::End;
using exact::FiniteVolume;
using exact::FiniteVolumeOptions;
using exact::Frame;
using exact::GasCells;
using exact::Riemann;

constexpr double two_pi = 6.283185307179586;

/// A shock tube in |x| < 0.5 with its jump at 0, all waves inside at `time`.
struct Tube {
    std::string name;
    double gamma, time;
    Riemann::State left, right;
};
inline const Tube sod{"sod", 1.4, 0.2, {1, 0, 1}, {0.125, 0, 0.1}};
inline const Tube blast{"blast", 5.0 / 3, 0.0065, {1, 0, 3000}, {1, 0, 1e-7}};

/// sum |f - f_exact| dx / sum |f_exact| dx over |x| < 0.5.
struct Errors {
    double rho, v, p;
};

inline Errors errors(const GasCells& cells, const Tube& tube) {
    const Riemann exact{tube.left, tube.right, tube.gamma};
    std::array<double, 3> wrong{}, all{};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& [rho, v, p] = cells.states[i];
        if (std::abs(cells.centre(i)) > 0.5) continue;
        const Riemann::Point e = exact.at(cells.centre(i), tube.time);
        const std::array<double, 3> off{rho - e.rho, v - e.v, p - e.p}, size{e.rho, e.v, e.p};
        for (std::size_t k = 0; k < 3; ++k) {
            wrong[k] += std::abs(off[k]) * cells.width(i);
            all[k] += std::abs(size[k]) * cells.width(i);
        }
    }
    return {wrong[0] / all[0], wrong[1] / all[1], wrong[2] / all[2]};
}

inline FiniteVolumeOptions options(Frame frame, double gamma, End ends = End::transmissive) {
    FiniteVolumeOptions chosen;
    chosen.gamma = gamma;
    chosen.frame = frame;
    chosen.left = chosen.right = ends;
    return chosen;
}

/// Uniform cells in the Eulerian frame, cells of equal mass in the Lagrangian one.
inline FiniteVolume solver(const Tube& tube, Frame frame, std::size_t n) {
    const auto make = frame == Frame::eulerian ? exact::uniform_tube : exact::equal_mass_tube;
    return {make(-0.5, 0, 0.5, n, tube.left, tube.right), options(frame, tube.gamma)};
}

inline Errors errors(const Tube& tube, Frame frame, std::size_t n) {
    FiniteVolume solution = solver(tube, frame, n);
    solution.advance_to(tube.time);
    return errors(solution.cells(), tube);
}

}  // namespace finite_volume_reference
