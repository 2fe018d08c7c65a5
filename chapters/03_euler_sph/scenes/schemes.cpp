#include "chapters/03_euler_sph/figures/figures.hpp"

namespace sph::euler {

std::vector<Named> compared_schemes(double best_h) {
    using plot::Marker;
    std::vector<Named> all{
        {"fixed-h", "one $h$", {"fixed-h", "cubic", 1.2}, {}},
        {"averaged-h", "mean of both $h$", {"averaged-h", "cubic", 1.2}, {}},
        {"without-omega", "own $h$, without Ω", {"without-omega", "cubic", 1.2}, {}},
        {"consistent-h", "own $h$, with Ω", {"consistent-h", "cubic", 1.2}, {}},
        {"super-gaussian", "with Ω, super-Gaussian", {"consistent-h", "super-gaussian", best_h}, {}}};
    constexpr std::array markers{Marker::square, Marker::triangle_up, Marker::diamond, Marker::circle,
                                 Marker::triangle_down};
    for (std::size_t k = 0; k < all.size(); ++k)
        all[k].style = {.label = all[k].label, .colour = plot::cycle(k), .marker = markers[k]};
    return all;
}

}  // namespace sph::euler
