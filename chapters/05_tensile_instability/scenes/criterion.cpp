#include "chapters/05_tensile_instability/scenes/criterion.hpp"

#include "chapters/01_kernel_interpolation/kernels.hpp"

namespace sph::tensile {

template <int d>
std::vector<Verdict> verdicts(const std::vector<double>& h_over_dx, const std::vector<double>& pressures) {
    std::vector<Verdict> all;
    for_each_kernel<d>([&](const auto& kernel) {
        using K = std::decay_t<decltype(kernel)>;
        for (const double h : h_over_dx) {
            if (K::support * h <= 1) continue;
            const auto lattice = lattice_kernel<K>(h);
            for (const double P : pressures) {
                const bool called = -P * K::d2W_dr2(1.0, h) > 0;
                all.push_back({std::string{K::name}, h, P, called,
                               growth_on_grid<d>(lattice, isotropic<d>(P), d == 1 ? 200 : 24)});
            }
        }
    });
    return all;
}
template std::vector<Verdict> verdicts<1>(const std::vector<double>&, const std::vector<double>&);
template std::vector<Verdict> verdicts<2>(const std::vector<double>&, const std::vector<double>&);

}  // namespace sph::tensile
