#pragma once
#include <string>
#include <string_view>
#include <tuple>

#include "common/app/parameters.hpp"

/// What may be turned at an effect. An effect says it once,
///     struct AlphaBeta {
///         double alpha = 1;
///         static constexpr auto knobs() {
///             return std::tuple{Knob{"alpha", &AlphaBeta::alpha, {0, 10}, "strength of the linear term"}};
///         }
///     };
/// and what is made of other effects passes theirs on: auto parts(auto& self) { return
/// std::tie(self.viscosity); }. Options, --help and tables of parameters follow.
namespace sph {

template <class T>
struct Knob {
    std::string_view name;
    double T::*value;
    app::Range range;
    std::string_view meaning;
};
template <class T>
Knob(const char*, double T::*, app::Range, const char*) -> Knob<T>;

/// Calls visit(knob, part) for the knobs of a thing and of its parts.
template <class Thing, class Visit>
void for_each_knob(Thing& thing, Visit&& visit) {
    using T = std::remove_const_t<Thing>;
    if constexpr (requires { T::knobs(); })
        std::apply([&](const auto&... knob) { (visit(knob, thing), ...); }, T::knobs());
    if constexpr (requires { T::parts(thing); })
        std::apply([&](auto&... part) { (for_each_knob(part, visit), ...); }, T::parts(thing));
}

/// What may be turned, with the values that the thing has.
template <class Thing>
app::Parameters parameters_of(const Thing& thing) {
    app::Parameters parameters;
    for_each_knob(thing, [&](const auto& knob, const auto& part) {
        parameters.add({std::string{knob.name}, part.*knob.value, knob.range, std::string{knob.meaning}});
    });
    return parameters;
}
/// The thing with other values; knobs of one name are one parameter.
template <class Thing>
Thing with_parameters(Thing thing, const app::Parameters& parameters) {
    for_each_knob(thing, [&](const auto& knob, auto& part) {
        if (parameters.has(knob.name)) part.*knob.value = parameters.value(knob.name);
    });
    return thing;
}

}  // namespace sph
