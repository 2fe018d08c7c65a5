#pragma once
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "chapters/06_finite_particle_method/bases.hpp"

/// The functions that this chapter interpolates, with first and second derivatives.
namespace sph::fpm {

/// f(x, k): the k-th of value, gradient and second derivatives at x, in the order of Taylor's terms.
template <int d>
using Smooth = std::function<double(const Vector<d>& x, std::size_t k)>;

/// The axes along which the k-th term differentiates.
template <int d>
std::vector<std::size_t> axes_of_term(std::size_t k) {
    std::vector<std::size_t> axes;
    for (; k > 0; k = Taylor<d, 2>::terms[k].parent) axes.push_back(Taylor<d, 2>::terms[k].axis);
    return axes;
}

/// exp(-|x - a|^2/w^2) + 0.7 exp(-|x - b|^2/v^2) with a = 0.2, w = 0.2, b = 0.9, v = 0.1 along each axis: two
/// Gaussians (Mota, Chen & Qian 2017, fig. 1), placed so that neither they nor their slopes vanish at the
/// ends.
template <int d>
double two_gaussians(const Vector<d>& x, std::size_t k) {
    const auto bump = [&](double centre, double width) {
        double r2 = 0;
        for (const double c : x) r2 += (c - centre) * (c - centre);
        const auto axes = axes_of_term<d>(k);
        const auto slope = [&](std::size_t a) { return -2 * (x[a] - centre) / (width * width); };
        double factor = 1;
        for (const std::size_t a : axes) factor *= slope(a);
        if (axes.size() == 2 && axes[0] == axes[1]) factor -= 2 / (width * width);
        return factor * std::exp(-r2 / (width * width));
    };
    return bump(0.2, 0.2) + 0.7 * bump(0.9, 0.1);
}

/// sin(2 pi n (x + 2 y + 3 z)/d + 0.3), n = `waves` > 0.
template <int d>
double wave_with(double waves, const Vector<d>& x, std::size_t k) {
    const auto wave_number = [waves](std::size_t a) {
        return 2 * pi * waves * static_cast<double>(a + 1) / d;
    };
    double phase = 0.3;
    for (std::size_t a = 0; a < d; ++a) phase += wave_number(a) * x[a];
    double factor = 1;
    for (const std::size_t a : axes_of_term<d>(k)) factor *= wave_number(a), phase += pi / 2;
    return factor * std::sin(phase);
}

template <int d>
Smooth<d> wave_of(double waves) {
    return [waves](const Vector<d>& x, std::size_t k) { return wave_with<d>(waves, x, k); };
}
/// That with n = 1.
template <int d>
double plane_wave(const Vector<d>& x, std::size_t k) {
    return wave_with<d>(1, x, k);
}

/// A polynomial of second degree with all its terms: sum_k x^k/(1 + k).
template <int d>
double parabola(const Vector<d>& x, std::size_t k) {
    double sum = 0;
    for (std::size_t term = 0; term < derivatives<d>; ++term) {
        std::array<int, 3> power{};
        for (const std::size_t a : axes_of_term<d>(term)) ++power[a];
        double value = 1 / (1 + static_cast<double>(term));
        for (const std::size_t a : axes_of_term<d>(k)) value *= power[a]--;
        for (std::size_t a = 0; a < d && value != 0; ++a) value *= std::pow(x[a], power[a]);
        sum += value;
    }
    return sum;
}

/// two-gaussians, wave, parabola. Throws std::invalid_argument for another name.
template <int d>
Smooth<d> function_of_name(const std::string& name) {
    if (name == "two-gaussians") return two_gaussians<d>;
    if (name == "wave") return plane_wave<d>;
    if (name == "parabola") return parabola<d>;
    throw std::invalid_argument{"no such function: " + name};
}

}  // namespace sph::fpm
