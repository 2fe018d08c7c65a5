#pragma once
#include <functional>
#include <string>
#include <vector>

#include "chapters/07_godunov_sph/scenes/godunov_methods.hpp"
#include "common/report/race.hpp"

/// What figures of this chapter share.
namespace sph::godunov {

/// The paper's scheme and its repairs, one at a time, up to the recommended one.
inline std::vector<Method<1>> one_at_a_time() {
    return line_methods().named(
        {"inutsuka", "careful", "own-width", "limited", "narrow-faces", "varying-h", "godunov"});
}

/// Chapter 4's method of that name; its recommended one, which has the look of this chapter's, open.
inline Method<1> of_chapter_4(const std::string& name) {
    Method<1> method = shocks::tube_methods()[name];
    if (name == "reconstructed") method.look.filled = false, method.look.dash = plot::Dash::dashed;
    return method;
}

}  // namespace sph::godunov
