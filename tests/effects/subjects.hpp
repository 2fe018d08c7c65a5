#pragma once
#include <cxxabi.h>

#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <regex>
#include <string>
#include <tuple>
#include <typeinfo>
#include <vector>

#include "tests/effects/directions.hpp"
#include "tests/effects/smoothings.hpp"

/// The effects under test, each with what it claims about i and j exchanged and about its sign. The tables
/// are chapter_*.cpp.
namespace sph::tested {

enum class Parity {
    antisymmetric,  ///< w_i term(i, j) = - w_j term(j, i): what i gets, j loses
    symmetric,      ///< w_i term(i, j) = w_j term(j, i)
    neither         ///< neither of these, with any of the weights below
};
/// What the particles count the term by.
enum class Weight { one, mass, volume, lab_volume, entropy };
inline constexpr std::array all_weights{Weight::one, Weight::mass, Weight::volume, Weight::lab_volume,
                                        Weight::entropy};
inline double weight(const auto& numbers, Weight by) {
    if (by == Weight::mass) return numbers.m;
    if (by == Weight::volume) return numbers.V;
    if (by == Weight::lab_volume) return numbers.m / numbers.n_star;
    if (by == Weight::entropy) return numbers.nu;
    return 1;
}

/// What holds of one column that an effect sums. `why`: for the reader of the table.
struct Claim {
    Parity parity;
    Weight by;
    Along along;
    bool one_kernel_only = false;  ///< the parity: where i and j see the same W and F, and only there
};
inline Claim antisymmetric(Weight by, Along along) {
    return {Parity::antisymmetric, by, along};
}
inline Claim symmetric(Weight by, Along along) {
    return {Parity::symmetric, by, along};
}
inline Claim symmetric_in_one_kernel(Weight by, Along along) {
    return {Parity::symmetric, by, along, true};
}
inline Claim neither(Along along, const char* /*why*/) {
    return {Parity::neither, Weight::one, along};
}

/// What one call of add() leaves: of each column that is summed, its components.
using Sums = std::vector<std::vector<Tile>>;

template <int d>
struct AnyEffect {
    virtual ~AnyEffect() = default;
    /// Begins as the pass does. A SidedPair only where the effect asks for nothing else.
    virtual Sums add(const Numbers<d>& i, const Eight<d>& j, const AnyPair<d>& pair) const = 0;
};

struct Subject {
    std::string name;  ///< of the type, without namespaces
    bool sided;        ///< asks a pair for nothing but F_i and F_j, so that BothH will do
    std::vector<Claim> claims;
    std::tuple<std::shared_ptr<AnyEffect<1>>, std::shared_ptr<AnyEffect<2>>, std::shared_ptr<AnyEffect<3>>>
        effects;

    /// Null in dimensions in which the effect has no meaning.
    template <int d>
    const AnyEffect<d>* in() const {
        return std::get<d - 1>(effects).get();
    }
};

/// The listed columns of all that there are: an effect sees what it declares and no more.
template <class T, int d, class... C>
Row<T, d, C...> only(const auto& all, List<C...>) {
    Row<T, d, C...> row;
    ((member<C, T, d>(row) = member<C, T, d>(all)), ...);
    return row;
}
template <int d, class... C>
Sums components(const Row<Tile, d, C...>& row) {
    Sums sums;
    const auto take = [&](const auto& column) {
        for_each_component([&](const Tile& tile) { sums.back().push_back(tile); }, column);
    };
    ((sums.emplace_back(), take(member<C, Tile, d>(row))), ...);
    return sums;
}

template <class E, int d, bool sided>
struct TheEffect final : AnyEffect<d> {
    E effect;
    explicit TheEffect(const E& which) : effect{which} {}
    Sums add(const Numbers<d>& i, const Eight<d>& j, const AnyPair<d>& pair) const override {
        using Needs = Effects<E>;
        RowOf<Tile, d, typename Needs::Summed> sum;
        pass_detail::SumTiles<typename Needs::Summed>::clear(sum);
        const auto own_i = only<double, d>(i, typename Needs::ReadI{});
        const auto own_j = only<Tile, d>(j, typename Needs::ReadJ{});
        if constexpr (sided) {
            std::visit([&](const auto& of_kind) { effect.add(own_i, own_j, of_kind, sum); }, pair);
        } else {
            effect.add(own_i, own_j, std::get<Pair<d, Tile>>(pair), sum);
        }
        return components(sum);
    }
};

/// "sph::euler::TracerForce" is TracerForce.
template <class E>
std::string name_of() {
    const std::unique_ptr<char, void (*)(void*)> full{
        abi::__cxa_demangle(typeid(E).name(), nullptr, nullptr, nullptr), std::free};
    return std::regex_replace(full.get(), std::regex{R"(\b[a-z_0-9]+::)"}, "");
}

template <class E, bool sided, int dimensions>
Subject subject(const E& effect, std::initializer_list<Claim> claims) {
    Subject made{name_of<E>(), sided, claims, {}};
    std::get<0>(made.effects) = std::make_shared<TheEffect<E, 1, sided>>(effect);
    if constexpr (dimensions > 1) {
        std::get<1>(made.effects) = std::make_shared<TheEffect<E, 2, sided>>(effect);
        std::get<2>(made.effects) = std::make_shared<TheEffect<E, 3, sided>>(effect);
    }
    return made;
}
/// An effect that asks for W, or for the F of the pair; one claim for each column of its Adds.
template <int dimensions = 3, class E>
Subject of_kernel(const E& effect, std::initializer_list<Claim> claims) {
    return subject<E, false, dimensions>(effect, claims);
}
/// An effect that asks for F_i and F_j, and so serves two kernels too.
template <int dimensions = 3, class E>
Subject of_gradients(const E& effect, std::initializer_list<Claim> claims) {
    return subject<E, true, dimensions>(effect, claims);
}

std::vector<Subject> chapters_1_and_2();
std::vector<Subject> chapter_3();
std::vector<Subject> chapter_4();
std::vector<Subject> chapter_5();
std::vector<Subject> chapter_5_cures();
std::vector<Subject> chapter_6();
std::vector<Subject> chapter_7();
std::vector<Subject> chapter_8();
std::vector<Subject> chapter_9();
const std::vector<Subject>& all_subjects();

}  // namespace sph::tested
