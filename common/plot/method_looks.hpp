#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "common/plot/figure.hpp"

/// How the methods of the book look: one name, one colour and marker, in every figure of every chapter.
namespace plot {

/// `method`: its name in results.csv; `label`: its legend entry. The method that a chapter recommends is a
/// blue circle; the finite-volume grids, their competitors, are black and grey. Throws std::invalid_argument
/// for a name that the registry (method_looks.cpp) does not know: a new method gets its line there.
Style look_of(std::string_view method, std::string label = "");
/// All names that look_of() knows.
std::vector<std::string> methods_with_looks();

/// Curves that a figure needs and its text does not speak of: thin, grey, behind the others. A panel's first
/// one may bear the label of all.
Style rest(std::string label = "");

}  // namespace plot
