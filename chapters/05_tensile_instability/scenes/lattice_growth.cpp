#include "chapters/05_tensile_instability/scenes/lattice_growth.hpp"

#include <algorithm>

#include "chapters/01_kernel_interpolation/kernels.hpp"

namespace sph::tensile {
namespace {

/// Goes uphill from a wave by steps along the axes and diagonals, which shrink where none leads higher.
template <int d, class Rate>
GrowingWave<d> climb(GrowingWave<d> best, double step, Rate&& rate) {
    constexpr double finest = 1e-6;  // of k: the rate is flat at its top, so 1e-12 of it
    while (step > finest) {
        const GrowingWave<d> from = best;
        for (int direction = 0; direction < (d == 1 ? 3 : 9); ++direction) {
            Vector<d> k = from.k;
            k[0] += step * (direction % 3 - 1);
            if constexpr (d == 2) k[1] += step * (direction / 3 - 1);
            const double here = rate(k);
            if (here > best.rate) best = {here, k};
        }
        if (best.rate == from.rate) step /= 2;
    }
    return best;
}

/// The grid's points, in units of the reciprocal vectors: of the half zone, since k and -k are one wave; of
/// an eighth where both axes are alike.
template <int d>
std::vector<Vector<d>> zone(const LatticeKernel<d>& lattice, int grid, bool isotropic_stress) {
    const bool eighth = isotropic_stress && lattice.basis == square_lattice<d>();
    const Tensor<d> b = reciprocal<d>(lattice.basis);
    std::vector<Vector<d>> points;
    const double step = pi / grid;
    for (int m = 0; m <= grid; ++m) {
        if constexpr (d == 1) {
            points.push_back((m * step) * b[0]);
        } else {
            for (int n = eighth ? 0 : -grid; n <= (eighth ? m : grid); ++n)
                points.push_back((m * step) * b[0] + (n * step) * b[1]);
        }
    }
    return points;
}

template <int d>
bool is_isotropic(const Tensor<d>& pressure) {
    return pressure == isotropic<d>(pressure[0][0]);
}

}  // namespace

template <int d>
LatticeKernel<d> named_lattice(const std::string& kernel, double h_over_dx, const Tensor<d>& basis) {
    LatticeKernel<d> lattice;
    const bool found = with_kernel<d>(kernel, [&](const auto& one) {
        lattice = lattice_kernel<std::decay_t<decltype(one)>>(h_over_dx, basis);
    });
    if (!found) throw std::invalid_argument{"no such kernel: " + kernel};
    if (lattice.half.empty()) throw std::invalid_argument{"a lattice without neighbours"};
    return lattice;
}
template LatticeKernel<1> named_lattice(const std::string&, double, const Tensor<1>&);
template LatticeKernel<2> named_lattice(const std::string&, double, const Tensor<2>&);

template <int d>
double growth_on_grid(const LatticeKernel<d>& lattice, const Tensor<d>& pressure, int grid) {
    double fastest = 0;
    for (const auto& k : zone<d>(lattice, grid, is_isotropic<d>(pressure)))
        fastest = std::max(fastest, growth(lattice, pressure, k));
    return fastest;
}
template double growth_on_grid(const LatticeKernel<1>&, const Tensor<1>&, int);
template double growth_on_grid(const LatticeKernel<2>&, const Tensor<2>&, int);

template <int d>
GrowingWave<d> fastest_wave(const LatticeKernel<d>& lattice, const Tensor<d>& pressure, int grid) {
    constexpr std::size_t climbed = 6;  // the highest point need not lie beside the grid's highest
    const auto rate = [&](const Vector<d>& k) { return growth(lattice, pressure, k); };
    std::vector<GrowingWave<d>> waves;
    for (const auto& k : zone<d>(lattice, grid, is_isotropic<d>(pressure))) waves.push_back({rate(k), k});
    const auto begin = waves.begin(), end = begin + std::ptrdiff_t(std::min(climbed, waves.size()));
    std::partial_sort(begin, end, waves.end(), [](const auto& a, const auto& b) { return a.rate > b.rate; });
    GrowingWave<d> best;
    for (auto wave = begin; wave != end; ++wave) {
        if (wave->rate <= 0) break;
        const GrowingWave<d> top = climb(*wave, pi / grid / 2, rate);
        if (top.rate > best.rate) best = top;
    }
    return best;
}
template GrowingWave<1> fastest_wave(const LatticeKernel<1>&, const Tensor<1>&, int);
template GrowingWave<2> fastest_wave(const LatticeKernel<2>&, const Tensor<2>&, int);

double long_wave_speed(const LatticeKernel<2>& lattice, double P, double length) {
    const double k = 2 * pi / length;
    return std::sqrt(dispersion_matrix<2>(lattice, isotropic<2>(P), {k, 0})[0][0]) / k;
}

void LatticeGrowthCommand::declare(app::CommandLine& line) {
    line.choice("kernel", kernel_, kernel_names(), "smoothing kernel")
        .number("h-over-dx", h_over_dx_, {0.5, 8}, "spacings", "smoothing length")
        .numbers("pressure", pressure_, {-100, 100}, "m c^2/dx^2",
                 "pressure on the lattice, below 0: tension; a comma-separated list")
        .number("tension-x", tension_x_, {-100, 100}, "m c^2/dx^2",
                "a tension along x alone, besides: stress is then a tensor");
}

void LatticeGrowthCommand::run(report::Run& run) const {
    with_kernel<2>(kernel_, [&](const auto& kernel) {
        app::require_above("h-over-dx", h_over_dx_, 1 / kernel.support, "with the kernel " + kernel_);
    });
    const auto lattice = named_lattice<2>(kernel_, h_over_dx_);
    std::string csv = "pressure,growth,kx,ky\n";
    for (const double P : pressure_) {
        Tensor<2> pressure = isotropic<2>(P);
        pressure[0][0] -= tension_x_;
        const auto wave = fastest_wave<2>(lattice, pressure);
        csv += report::csv_row({P, wave.rate, wave.k[0], wave.k[1]});
    }
    run.print(csv);
}

}  // namespace sph::tensile
