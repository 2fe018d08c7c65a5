#pragma once
#include <array>
#include <cmath>
#include <random>
#include <span>

#include "chapters/03_euler_sph/scenes/necklace.hpp"
#include "chapters/04_artificial_viscosity/physical_viscosity.hpp"
#include "chapters/04_artificial_viscosity/switches.hpp"
#include "chapters/05_tensile_instability/cures.hpp"
#include "chapters/05_tensile_instability/total_lagrangian.hpp"
#include "chapters/08_landau_model/relativistic_dissipation.hpp"
#include "chapters/09_transverse_expansion/curved_fluid.hpp"

/// Random particles for tests of effects: every number where it has a meaning, and neighbours as a pass hands
/// them over.
namespace sph::tested {

/// All that the book's effects read. One that reads more does not compile here: name the column, and below
/// where its numbers lie.
using AllColumns =
    List<Position, Velocity, MiddleVelocity, Mass, Density, Volume, Quantity, Pressure, SoundSpeed,
         ThermalEnergy, SmoothingLength, GradH, ViscousPressure, ViscosityAlpha, ShearFactor, ConductionAlpha,
         DynamicViscosity, ViscousStress, VelocityGradient, PressureGradient, Entropy, EntropyDensity,
         BaryonDensity, MomentumPerCharge, EnergyPerBaryon, Enthalpy, Rapidity, RapidityGradient,
         LabPressureGradient, Stress, ArtificialStress, Displacement, DisplacementGradient, ReferenceStress,
         TransportVelocity, InverseCorrection, WeighedPressure>;

/// Where the components of a column lie. Of either sign, if nothing else is said.
struct Range {
    double low, high;
};
template <class C>
inline constexpr Range range_of = is_positive<C> ? Range{0.3, 2} : Range{-1, 1};
// So that |v| < 1, also in three dimensions.
template <>
inline constexpr Range range_of<Velocity>{-0.55, 0.55};
template <>
inline constexpr Range range_of<SmoothingLength>{0.4, 1.2};
template <>
inline constexpr Range range_of<Pressure>{0.1, 3};
template <>
inline constexpr Range range_of<WeighedPressure>{0.1, 3};
template <>
inline constexpr Range range_of<SoundSpeed>{0.05, 0.55};
template <>
inline constexpr Range range_of<Enthalpy>{1.1, 4};
template <>
inline constexpr Range range_of<GradH>{0.7, 1.3};
template <>
inline constexpr Range range_of<ViscousPressure>{0, 3};
template <>
inline constexpr Range range_of<DynamicViscosity>{0, 3};
template <>
inline constexpr Range range_of<ViscosityAlpha>{0.1, 2};
template <>
inline constexpr Range range_of<ShearFactor>{0, 1};
template <>
inline constexpr Range range_of<ConductionAlpha>{0, 1};

/// Numbers in [0, 1) that are the same for every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_{seed} {}
    double number() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
    double in(const Range& range) { return range.low + (range.high - range.low) * number(); }

  private:
    std::mt19937_64 bits_;
};

/// One particle.
template <int d>
using Numbers = RowOf<double, d, AllColumns>;

template <int d, class... C>
void draw(Random& random, Row<double, d, C...>& numbers) {
    (for_each_component([&](double& value) { value = random.in(range_of<C>); },
                        member<C, double, d>(numbers)),
     ...);
}
template <int d>
Numbers<d> particle(Random& random) {
    Numbers<d> numbers;
    draw(random, numbers);
    numbers.V = numbers.m / numbers.rho;
    numbers.y = std::atanh(numbers.v[0]);
    return numbers;
}
/// A particle at `distance` from i, in any direction.
template <int d>
void place(Random& random, const Numbers<d>& i, double distance, Numbers<d>& numbers) {
    Vector<d> direction;
    double length = 0;
    do {
        for (double& component : direction) component = random.in({-1, 1});
        length = std::sqrt(dot(direction, direction));
    } while (length < 0.1 || length > 1);
    numbers.x = i.x - (distance / length) * direction;
}

template <int d, class L>
struct EightOf;
template <int d, class... C>
struct EightOf<d, List<C...>> {
    using type = pass_detail::Neighbour<d, C...>;
};
/// Eight neighbours, as the pass transposes them from rows.
template <int d>
using Eight = typename EightOf<d, Difference<AllColumns, List<Position>>>::type;

/// How far the pass moves padding: a thousand times the largest reach, which is 3 h here.
inline constexpr double beyond = 1e3 * 3 * range_of<SmoothingLength>.high;

template <int d, class... C>
Eight<d> gather(const Vector<d>& x_i, std::span<const Numbers<d>> near, List<C...> columns) {
    RowBuffer rows;
    rows.resize(near.size(), static_cast<std::size_t>(d) + count_components<d>(columns));
    for (std::size_t k = 0; k < near.size(); ++k) {
        double* out = rows.row(k);
        const auto put = [&out](const double& value) { *out++ = value; };
        for_each_component(put, near[k].x);
        (for_each_component(put, member<C, double, d>(near[k])), ...);
    }
    std::array<std::uint32_t, tile_width> index{};
    for (std::size_t lane = 0; lane < tile_width; ++lane)
        index[lane] = static_cast<std::uint32_t>(std::min(lane, near.size() - 1));
    return {rows, index.data(), x_i, columns};
}
/// One to eight neighbours of i. Lanes behind the last repeat it, far away, as pass.hpp pads a tile.
template <int d>
Eight<d> neighbours_of(const Numbers<d>& i, std::span<const Numbers<d>> near) {
    Eight<d> j = gather<d>(i.x, near, Difference<AllColumns, List<Position>>{});
    j.x_ij[0] += beyond * unused_lanes(near.size());
    return j;
}

}  // namespace sph::tested
