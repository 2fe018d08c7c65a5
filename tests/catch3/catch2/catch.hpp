#pragma once
#include <catch2/catch_all.hpp>
#include <string>

/// Catch2 3 under the names of Catch2 2, in which the tests are written: in the include path where 3 is
/// found.
namespace Catch {

using Matchers::EndsWith;
using Matchers::Matches;
using Matchers::StartsWith;
inline auto Contains(const std::string& text) {
    return Matchers::ContainsSubstring(text);
}

}  // namespace Catch

using Catch::Approx;
