#include "chapters/04_artificial_viscosity/figures/figures.hpp"

namespace sph::shocks {

plot::Style style_of(const std::string& method) {
    using plot::Marker;
    static constexpr std::array markers{Marker::plus,    Marker::triangle_down, Marker::triangle_up,
                                        Marker::diamond, Marker::square,        Marker::triangle_up,
                                        Marker::square,  Marker::diamond,       Marker::triangle_down,
                                        Marker::cross,   Marker::circle};
    static constexpr std::array<std::size_t, 11> colours{7, 6, 5, 3, 1, 4, 2, 5, 3, 1, 0};
    const auto& methods = tube_methods();
    for (std::size_t k = 0; k < methods.size(); ++k) {
        if (methods[k].name != method) continue;
        return {.label = methods[k].label, .colour = plot::cycle(colours[k]), .marker = markers[k]};
    }
    return {.label = method};
}

std::vector<Method> methods_named(const std::vector<std::string>& names) {
    std::vector<Method> methods;
    for (const std::string& name : names) methods.push_back(tube_method(name));
    return methods;
}

}  // namespace sph::shocks
