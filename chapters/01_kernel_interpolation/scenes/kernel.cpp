#include "chapters/01_kernel_interpolation/scenes/kernel.hpp"

#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/kernels.hpp"

namespace sph::interpolation {
namespace {

template <int d>
void tabulate(report::Run& run, const std::string& name) {
    with_kernel<d>(name, [&](auto kernel) {
        using K = decltype(kernel);
        std::string csv = "q,W,dW_dr,d2W_dr2,F,dW_dh\n";
        for (const double q : linear_space(0, K::support, 201)) {
            csv += report::csv_row(
                {q, K::W(q, 1), K::dW_dr(q, 1), K::d2W_dr2(q, 1), K::F(q, 1), K::dW_dh(q, 1)});
        }
        run.print(csv);
    });
}

}  // namespace

void KernelCommand::declare(app::CommandLine& line) {
    line.choice("kernel", kernel_, kernel_names(), "smoothing kernel")
        .integer("dimension", dimension_, 1, 3, "of space");
}

void KernelCommand::run(report::Run& run) const {
    if (dimension_ == 1) tabulate<1>(run, kernel_);
    if (dimension_ == 2) tabulate<2>(run, kernel_);
    if (dimension_ == 3) tabulate<3>(run, kernel_);
}

}  // namespace sph::interpolation
