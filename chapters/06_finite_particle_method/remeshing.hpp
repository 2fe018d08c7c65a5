#pragma once
#include <cmath>

#include "chapters/06_finite_particle_method/burgers_line.hpp"

/// Particles that have come too close are replaced by even ones, on a line from 0 to 1 with mirrors.
namespace sph {

/// Monaghan's M4': even, of support 2, its sum over an even line is 1, and it carries the first and second
/// moments over exactly (Monaghan 1985; Chen 2017 has splines only).
inline double m4_prime(double q) {
    q = std::abs(q);
    if (q < 1) return 1 - q * q * (2.5 - 1.5 * q);
    if (q < 2) return 0.5 * (2 - q) * (2 - q) * (1 - q);
    return 0;
}

/// The places (i + 1/2)/n.
inline Columns<1> even_places(std::size_t n) {
    Columns<1> x;
    for (std::size_t i = 0; i < n; ++i)
        x[0].push_back((static_cast<double>(i) + 0.5) / static_cast<double>(n));
    return x;
}

/// What particles have is shared out to even ones: a_p = sum_q a_q M4'((x_p - x_q)/dx), for the carried mass
/// and for a = u times the space of a particle (its part of the integral of u). Conserves both sums, but for
/// what passes the mirrors.
inline void remesh_by_sharing(BurgersParticles& p) {
    const std::size_t n = p.size();
    const double dx = 1 / static_cast<double>(n);
    Column mass(n, 0.0), momentum(n, 0.0);
    for (std::size_t q = 0; q < n; ++q) {
        const double u_space = p.v[0][q] * space_of(p.x[0], q);
        for (const bool image : {false, true}) {
            const double wall = p.x[0][q] < 0.5 ? 0 : 1, x = image ? 2 * wall - p.x[0][q] : p.x[0][q];
            const auto first = static_cast<long>(std::floor(x / dx - 0.5)) - 1;
            for (long k = std::max(first, 0L); k < std::min(first + 4, static_cast<long>(n)); ++k) {
                const auto at = static_cast<std::size_t>(k);
                const double weight = m4_prime((static_cast<double>(k) + 0.5) - x / dx);
                mass[at] += p.carried[q] * weight;
                momentum[at] += (image ? -u_space : u_space) * weight;
            }
        }
    }
    for (std::size_t i = 0; i < n; ++i) p.v[0][i] = momentum[i] / dx;
    p.carried = mass;
    p.x = even_places(n);
}

/// u and the carried mass by length are interpolated at even places by the fit of `estimates`.
inline void remesh_by_fit(BurgersParticles& p, Estimates<1>& estimates) {
    // [remesh]
    const std::size_t n = p.size();
    estimates.at_particles(p.x, p.m, p.h);
    const Columns<1> places = even_places(n);
    const Rows<1>& rows = estimates.at(places, p.h);
    Column u, carried_by_length(n), density;
    for (std::size_t i = 0; i < n; ++i) carried_by_length[i] = p.carried[i] / space_of(p.x[0], i);
    rows.apply(0, p.v[0], Parity::odd, u);
    rows.apply(0, carried_by_length, Parity::even, density);
    p.x = places, p.v[0] = u;
    for (std::size_t i = 0; i < n; ++i) p.carried[i] = density[i] / static_cast<double>(n);
    // [end]
}

}  // namespace sph
