#include "chapters/03_euler_sph/scenes/star.hpp"

/// The star at rest, and what linear oscillations about it look like.
namespace sph::euler {

Dense jacobian(LineGas& gas) {
    const std::size_t n = gas.size();
    const Column &m = gas.get<Mass>(), &rho = gas.get<Density>();
    const auto accelerations = [&] {
        gas.rates(0);
        return gas.get<Acceleration>()[0];
    };
    Dense J{n};
    for (std::size_t j = 0; j < n; ++j) {
        double& x = gas.get<Position>()[0][j];
        // Large enough for ten digits of the difference, small enough for its own error of that order.
        const double start = x, shift = 1e-4 * m[j] / rho[j];
        x = start + shift;
        const Column above = accelerations();
        x = start - shift;
        const Column below = accelerations();
        for (std::size_t i = 0; i < n; ++i) J(i, j) = (above[i] - below[i]) / (2 * shift);
        x = start;
    }
    return J;
}

Dense relax(LineGas& gas) {
    constexpr int most_steps = 30;
    Column& x = gas.get<Position>()[0];
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_steps; ++step) {
        Dense J = jacobian(gas);
        gas.rates(0);
        const Column& a = gas.get<Acceleration>()[0];
        double force = 0;
        for (const double one : a) force = std::max(force, std::abs(one));
        // Newton doubles the digits until rounding is reached.
        if (force < 1e-14 || (force < 1e-11 && force > before / 2)) return J;
        before = force;
        const Column shift = solve(J, a);
        double part = 1;
        for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            const double gap = x[i + 1] - x[i], closing = std::abs(shift[i + 1] - shift[i]);
            if (part * closing > 0.4 * gap) part = 0.4 * gap / closing;
        }
        for (std::size_t i = 0; i < x.size(); ++i) x[i] -= part * shift[i];
        require_physical(x, Position::name, false, 0);
    }
    // A force that stays at 1e-8 is no rounding: such stars have edges that clump, and swing wrongly.
    throw Unstable{
        0, Unstable::no_particle,
        "the star at rest (none was found; a smaller h or another spacing may have one): largest force",
        before};
}

std::vector<double> star_frequencies(const StarScene& scene, const GasMethod& method, int modes) {
    const auto gas = star_gas(scene, method);
    std::vector<double> omega;
    for (const auto& value : eigenvalues(relax(*gas)))
        omega.push_back(std::sqrt(std::max(0.0, -value.real())));
    std::sort(omega.begin(), omega.end());
    omega.resize(static_cast<std::size_t>(modes));
    return omega;
}

Column star_omega(const StarScene& scene, const GasMethod& method) {
    const auto gas = star_gas(scene, method);
    relax(*gas);
    return gas->get<GradH>();
}

}  // namespace sph::euler
