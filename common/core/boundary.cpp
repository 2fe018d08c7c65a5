#include "common/core/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sph {
namespace {

/// x -> sign x + shift: one image of an axis.
struct Image {
    double sign = 1, shift = 0;
};

/// Calls visit(image) for each image of an axis, other than the points themselves, that can come within
/// `reach` of [low, high]. Mirrors at both ends make images of images: translations by twice the length, and
/// reflections between them.
template <class Visit>
void for_each_image(double low, double high, std::pair<Face, Face> faces, double reach, Visit&& visit) {
    const double length = high - low;
    const bool periodic = faces.first == Face::periodic;
    const bool at_low = faces.first == Face::mirror, at_high = faces.second == Face::mirror;
    if (periodic || (at_low && at_high)) {
        const double period = periodic ? length : 2 * length;
        constexpr double most = 1e6;  // beyond, counting them would take for ever
        if (!(reach < most * period))
            throw std::invalid_argument{"Box: the reach spans more than 1e6 images"};
        const int layers = static_cast<int>(std::ceil(reach / period)) + (periodic ? 0 : 1);
        for (int k = -layers; k <= layers; ++k) {
            if (k != 0) visit(Image{1, k * period});
            if (!periodic) visit(Image{-1, 2 * low + k * period});
        }
    } else {
        if (at_low) visit(Image{-1, 2 * low});
        if (at_high) visit(Image{-1, 2 * high});
    }
}

template <int d>
void require_sound(const Box<d>& box) {
    for (std::size_t a = 0; a < d; ++a) {
        if (!(box.high[a] > box.low[a])) throw std::invalid_argument{"Box: high must be above low"};
        const auto [first, second] = box.faces[a];
        if ((first == Face::periodic) != (second == Face::periodic))
            throw std::invalid_argument{"Box: an axis is periodic at both ends or at none"};
    }
}

template <int d>
std::array<std::pair<Face, Face>, static_cast<std::size_t>(d)> all(Face face) {
    std::array<std::pair<Face, Face>, static_cast<std::size_t>(d)> faces;
    faces.fill({face, face});
    return faces;
}

}  // namespace

template <int d>
Box<d>::Box(const Vector<d>& low_corner, const Vector<d>& high_corner, Face everywhere)
    : Box{low_corner, high_corner, all<d>(everywhere)} {}

template <int d>
Box<d>::Box(const Vector<d>& low_corner, const Vector<d>& high_corner,
            std::array<std::pair<Face, Face>, static_cast<std::size_t>(d)> each)
    : low{low_corner}, high{high_corner}, faces{each} {
    require_sound(*this);
}

template <int d>
void Box<d>::add_ghosts(const Columns<d>& x, double reach, std::vector<Ghost<d>>& ghosts) const {
    const std::size_t first_ghost = ghosts.size(), n = x[0].size();
    Vector<d> same{};
    for (double& sign : same) sign = 1;
    // Axis by axis: an image on one axis has images on the next, and so corners come out right.
    for (std::size_t a = 0; a < d; ++a) {
        if (faces[a].first == Face::free && faces[a].second == Face::free) continue;
        const std::size_t before = ghosts.size();
        const auto add_images = [&](const Ghost<d>& original) {
            for_each_image(low[a], high[a], faces[a], reach, [&](const Image& image) {
                const double moved = image.sign * original.x[a] + image.shift;
                if (moved < low[a] - reach || moved > high[a] + reach) return;
                Ghost<d> copy = original;
                copy.x[a] = moved;
                copy.sign[a] *= image.sign;
                ghosts.push_back(copy);
            });
        };
        // Images of what lies farther from both faces than the reach are farther still.
        const double margin = reach + 1e-12 * (high[a] - low[a]);
        const double inner_low = low[a] + margin, inner_high = high[a] - margin;
        for (std::size_t i = 0; i < n; ++i) {
            if (x[a][i] > inner_low && x[a][i] < inner_high) continue;
            Ghost<d> particle{static_cast<std::uint32_t>(i), {}, same};
            for (std::size_t b = 0; b < d; ++b) particle.x[b] = x[b][i];
            add_images(particle);
        }
        for (std::size_t k = first_ghost; k < before; ++k) add_images(Ghost<d>{ghosts[k]});
    }
}

template struct Box<1>;
template struct Box<2>;
template struct Box<3>;

}  // namespace sph
