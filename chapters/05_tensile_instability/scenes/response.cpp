#include "chapters/05_tensile_instability/scenes/response.hpp"

#include <cmath>
#include <complex>

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
    for (std::size_t i = 0; i < answers.size(); ++i) {
        for (std::size_t a = 0; a < 2; ++a) {
            answers[i][a][of] += factor * motion[a][i];
            answers[i][2 + a][of] += factor * force[a][i];
        }
    }
}

std::vector<std::complex<double>> eigenvalues_of(const Response::Matrix& matrix) {
    Dense dense{4};
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b) dense(a, b) = matrix[a][b];
    return eigenvalues(std::move(dense));
}

}  // namespace

Response::Response(const CureMethod& method, double pressure) : answers_(n * n) {
    CureSetup setup;
    setup.box.per_side = n, setup.box.pressure = pressure;
    const auto liquid = cured(method, setup);
    for (std::size_t of = 0; of < 4; ++of) {
        Columns<2>& changed = of < 2 ? liquid->get<Position>() : liquid->get<Velocity>();
        double& value = changed[of % 2][0];
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
        // The lattice is its own mirror image, so the sines add up to nothing.
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b) sum[a][b] += answers_[i][a][b] * std::cos(phase);
    }
    return sum;
}

double Response::growth() const {
    double largest = -1e300;
    constexpr int half = per_side / 2;
    for (int y = 0; y <= half; ++y) {
        for (int x = y == 0 ? 1 : 0; x <= half; ++x) {
            for (const std::complex<double>& one : eigenvalues_of(matrix(x, y)))
                largest = std::max(largest, one.real());
        }
    }
    return largest;
}

double Response::speed(int axis) const {
    const Matrix wave = matrix(1, 0);
    const auto a = static_cast<std::size_t>(axis);
    Dense one{2};  // sound and shear along an axis of the lattice do not mix
    one(0, 0) = wave[a][a], one(0, 1) = wave[a][2 + a], one(1, 0) = wave[2 + a][a],
           one(1, 1) = wave[2 + a][2 + a];
    double omega = 0;
    for (const std::complex<double>& value : eigenvalues(std::move(one)))
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
