#pragma once
#include "chapters/01_kernel_interpolation/interpolation.hpp"

/// Consistency as moments: what the sums make of 1, x and x^2 decides what they reproduce.
namespace sph {

/// m0_i = sum_j V_j W_ij, which should be 1   (Chen 2017, 87; Ye et al. 2019, 19 with n = 0, where it is
/// printed 0)
struct ZerothMoment {
    static constexpr std::string_view name = "zeroth moment";
    template <class T, int>
    struct In {
        T m0{};
    };
    using ReadsJ = List<Volume>;
    using Adds = List<ZerothMoment>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const { sum.m0 += j.V * pair.W; }
};

// [first]
/// m1_i = sum_j V_j W_ij x_ij, which should be 0   (Chen 2017, 88; Ye et al. 2019, 19 with n = 1)
struct FirstMoment {
    static constexpr std::string_view name = "first moment";
    template <class T, int d>
    struct In {
        Vec<T, d> m1{};
    };
    using ReadsJ = List<Volume>;
    using Adds = List<FirstMoment>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        sum.m1 += (j.V * pair.W) * pair.x_ij;
    }
};
// [end]

/// m2_i = sum_j V_j W_ij x_ij x_ij^T   (Ye et al. 2019, 19 with n = 2): in the limit <x^2> h^2 on its
/// diagonal, which cannot vanish for W >= 0.
struct SecondMoment {
    static constexpr std::string_view name = "second moment";
    template <class T, int d>
    struct In {
        Vec<Vec<T, d>, d> m2{};
    };
    using ReadsJ = List<Volume>;
    using Adds = List<SecondMoment>;
    void add(const auto&, const auto& j, const auto& pair, auto& sum) const {
        sum.m2 += outer((j.V * pair.W) * pair.x_ij, pair.x_ij);
    }
};

}  // namespace sph
