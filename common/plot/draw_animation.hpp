#pragma once
#include <cstddef>

#include "common/plot/animation.hpp"
#include "common/plot/canvas.hpp"

namespace plot {

/// Pictures wider than this many pixels are halved in an animation: a figure of one panel stays 800 pixels
/// wide, and one of two panels becomes so.
inline constexpr int widest_frame = 1000;

/// The picture of frame k of an animation without faults, in the size in which it is stored. The canvas'
/// former picture is lost.
Image draw_frame(Canvas& canvas, const Animation& animation, std::size_t k);

/// Half the size each way: each pixel is the plain average of 2x2, as edges are drawn by plain averages too.
/// A last odd row or column is left out.
Image halved(const Image& image);

}  // namespace plot
