#include "chapters/05_tensile_instability/scenes/response.hpp"

#include <cmath>
#include <complex>
#include <numeric>

#include "common/core/dense.hpp"

namespace sph::tensile {
namespace {

constexpr std::size_t n = Response::per_side;
constexpr double small = 1e-4;  // a step of central differences [dx] and [c]

/// Adds factor times the rates of all particles to the column `of` of their matrices.
void add_rates(Integrated<2>& liquid, std::vector<Response::Matrix>& answers, std::size_t of, double factor) {
    liquid.rates(0);
    const Columns<2>& motion = motion_of(liquid);
    const Columns<2>& force = liquid.get<Acceleration>();
    const Column* compression = liquid.has<DensityRate>() ? &liquid.get<DensityRate>() : nullptr;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        for (std::size_t a = 0; a < 2; ++a) {
            answers[i][a][of] += factor * motion[a][i];
            answers[i][2 + a][of] += factor * force[a][i];
        }
        if (compression) answers[i][4][of] += factor * (*compression)[i];
    }
}

/// Of the rows and columns that are named.
std::vector<std::complex<double>> eigenvalues_of(const Response::Matrix& matrix,
                                                 const std::vector<std::size_t>& states) {
    Dense dense{states.size()};
    for (std::size_t a = 0; a < states.size(); ++a)
        for (std::size_t b = 0; b < states.size(); ++b) dense(a, b) = matrix[states[a]][states[b]];
    return eigenvalues(std::move(dense));
}

}  // namespace

Response::Response(const CureMethod& method, double pressure) : answers_(n * n) {
    CureSetup setup;
    setup.box.per_side = n, setup.box.pressure = pressure;
    const auto liquid = cured(method, setup);
    if (liquid->has<DensityRate>()) states_ = 5;
    for (std::size_t of = 0; of < states_; ++of) {
        Columns<2>& changed = of < 2 ? liquid->get<Position>() : liquid->get<Velocity>();
        double& value = of < 4 ? changed[of % 2][0] : liquid->get<Density>()[0];
        const double before = value;
        for (const double sign : {1.0, -1.0}) {
            value = before + sign * small;
            add_rates(*liquid, answers_, of, sign / (2 * small));
        }
        value = before;
    }
}

Response::Matrix Response::matrix(int wave_x, int wave_y) const {
    Matrix sum{};
    for (std::size_t i = 0; i < n * n; ++i) {
        const double phase = 2 * pi *
                             (wave_x * static_cast<double>(i % n) + wave_y * static_cast<double>(i / n)) /
                             static_cast<double>(n);
        // The lattice is its own mirror image: between vectors the sines add up to nothing, between a vector
        // and the density the cosines do. The i before rho makes that real, too.
        for (std::size_t a = 0; a < states_; ++a) {
            for (std::size_t b = 0; b < states_; ++b) {
                const bool to = a == 4, from = b == 4;
                const double part = to == from ? std::cos(phase) : to ? std::sin(phase) : -std::sin(phase);
                sum[a][b] += answers_[i][a][b] * part;
            }
        }
    }
    return sum;
}

double Response::growth() const {
    double largest = -1e300;
    std::vector<std::size_t> states(states_);
    std::iota(states.begin(), states.end(), 0);
    constexpr int half = per_side / 2;
    for (int y = 0; y <= half; ++y) {
        for (int x = y == 0 ? 1 : 0; x <= half; ++x) {
            for (const std::complex<double>& one : eigenvalues_of(matrix(x, y), states))
                largest = std::max(largest, one.real());
        }
    }
    return largest;
}

double Response::speed(int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    std::vector<std::size_t> states{a, 2 + a};  // sound and shear along an axis of the lattice do not mix
    if (states_ == 5) states.push_back(4);
    double omega = 0;
    for (const std::complex<double>& value : eigenvalues_of(matrix(1, 0), states))
        omega = std::max(omega, value.imag());
    return omega * per_side / (2 * pi);
}
double Response::sound_speed() const {
    return speed(0);
}
double Response::shear_speed() const {
    return speed(1);
}

}  // namespace sph::tensile
