#pragma once
#include <cstdint>

#include "common/core/vec.hpp"

namespace sph {

/// A copy of particle `owner` at x, which exists only while neighbours are summed. Component a of a vector is
/// multiplied by sign[a], of a tensor by both signs.
template <int d>
struct Ghost {
    std::uint32_t owner = 0;
    Vector<d> x{}, sign{};
};

}  // namespace sph
