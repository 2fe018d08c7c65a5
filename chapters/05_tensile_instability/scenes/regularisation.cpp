#include "chapters/05_tensile_instability/scenes/regularisation.hpp"

#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"

namespace sph::tensile {
namespace {

/// Friction beside the force: the liquid can lose what its disorder stores.
struct Friction {
    double nu = 0;
    using Columns = List<>;
    using Drift = Velocity;
    auto effects() const { return Effects{PressureForce<>{}, Damping{nu}}; }
};

/// Displacements from the lattice, brought into the box, without their mean.
double disorder(const LatticeBox& box, const Columns<2>& x) {
    double sum = 0;
    for (std::size_t a = 0; a < 2; ++a) {
        double mean = 0, squares = 0;
        for (std::size_t i = 0; i < box.size(); ++i) {
            const double u = std::remainder(x[a][i] - lattice_place(box, i)[a], box.side());
            mean += u / static_cast<double>(box.size());
            squares += u * u / static_cast<double>(box.size());
        }
        sum += squares - mean * mean;
    }
    return std::sqrt(sum);
}

/// |u(t)/u(0)|^2 of u'' + nu u' + omega^2 u = 0 from rest.
double left(double omega2, double nu, double t) {
    const std::complex<double> q = std::sqrt(std::complex<double>{nu * nu / 4 - omega2});
    const std::complex<double> sine = std::abs(q) * t < 1e-6 ? t : std::sinh(q * t) / q;
    return std::norm(std::exp(-nu * t / 2) * (std::cosh(q * t) + nu / 2 * sine));
}

/// omega^2 of all waves of the box but the shifts of the whole.
Column all_frequencies(const LatticeBox& box) {
    const auto lattice = named_lattice<2>(box.kernel, box.h_over_dx);
    const int n = static_cast<int>(box.per_side);
    Column found;
    for (int index = 1; index < n * n; ++index) {
        const Vector<2> k{2 * pi * (index % n) / n, 2 * pi * (index / n) / n};
        const auto both =
            squared_frequencies<2>(dispersion_matrix<2>(lattice, isotropic<2>(box.pressure), k));
        for (const auto& omega2 : both) found.push_back(omega2.real());
    }
    return found;
}

double nearest_pair(const LatticeBox& box, const Columns<2>& x) {
    double nearest = box.side();
    for (std::size_t i = 0; i < box.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            nearest = std::min(nearest, std::hypot(std::remainder(x[0][i] - x[0][j], box.side()),
                                                   std::remainder(x[1][i] - x[1][j], box.side())));
        }
    }
    return nearest;
}

}  // namespace

DisorderRun run_disorder(const DisorderedBox& scene) {
    const LatticeBox& box = scene.box;
    const auto liquid = liquid_box(box, Friction{scene.friction});
    liquid->template integrate_by<RungeKutta2>();  // friction: leapfrog has no velocity in step with it
    const Column omega2 = all_frequencies(box);
    DisorderRun run;
    const auto look = [&](double t) {
        run.t.push_back(t);
        run.measured.push_back(disorder(box, liquid->particles.x));
        double sum = 0;
        for (const double one : omega2) sum += left(one, scene.friction, t);
        run.predicted.push_back(run.measured.front() * std::sqrt(sum / static_cast<double>(omega2.size())));
    };
    look(0);
    double t = 0, next = 1;
    march(*liquid, t, {.end = scene.time}, [&](double now) {
        if (now < next - 1e-9) return;
        look(now);
        next = now + 1;
    });
    run.nearest = nearest_pair(box, liquid->particles.x);
    return run;
}

}  // namespace sph::tensile
