#include "chapters/03_euler_sph/scenes/dispersion.hpp"

#include "chapters/01_kernel_interpolation/kernels.hpp"
#include "chapters/03_euler_sph/dispersion.hpp"

namespace sph::euler {

void DispersionCommand::declare(app::CommandLine& line) {
    line.choice("kernel", kernel_, kernel_names(), "smoothing kernel")
        .number("h-over-dx", h_over_dx_, {0.5, 8}, "spacings", "smoothing length")
        .number("gamma", gamma_, {1, 100}, "", "adiabatic index")
        .numbers("k-dx", k_dx_, {0, 1000}, "1/spacing", "wave numbers, a comma-separated list");
}

void DispersionCommand::run(report::Run& run) const {
    std::string csv = "k_dx,omega2_constant_h,omega2_variable_h\n";
    with_kernel<1>(kernel_, [&](const auto& kernel) {
        app::require_above("h-over-dx", h_over_dx_, 1 / kernel.support, "with the kernel " + kernel_);
        for (const double k : k_dx_) {
            const auto d = dispersion<std::decay_t<decltype(kernel)>>(h_over_dx_, gamma_, k);
            csv += report::csv_row({k, d.fixed_h, d.variable_h});
        }
    });
    run.print(csv);
}

}  // namespace sph::euler
