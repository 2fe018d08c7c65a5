#pragma once
#include <cstddef>
#include <span>

#include "common/exact/woodward_colella.hpp"

namespace exact {

/// The stored reference, and the number of cells that it was computed with. The source file is what
/// `exact woodward-colella --cells 51200 --table` prints.
std::span<const WoodwardColella::Node> woodward_colella_table();
std::size_t woodward_colella_table_cells();

}  // namespace exact
