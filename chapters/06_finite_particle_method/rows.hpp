#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "chapters/06_finite_particle_method/neighbourhood.hpp"

/// Estimates as a sparse matrix: derivative k of f at place i is sum_j c_kij f_j. A finite difference is such
/// a row, too; so particles and grids are compared with one loop.
namespace sph {

enum class Parity { even, odd };  ///< of a function at a mirror: an image has f_j, or - f_j

template <int d>
class Rows {
  public:
    std::size_t size() const { return rows_.size(); }
    std::size_t entries() const { return owner_.size(); }
    /// Forgets all; there will be `n` rows, empty as yet.
    void reset(std::size_t n) {
        rows_.assign(n, {});
        owner_.clear(), sign_.clear();
        for (Column& one : c_) one.clear();
    }
    /// Row i is what is added from here on. A row may be written again: the last one counts.
    void begin(std::size_t i) { rows_[i] = {owner_.size(), owner_.size()}, writing_ = i; }
    /// An entry: the neighbour, 1 or for an image -1, and what the derivatives take of it.
    void add(std::uint32_t owner, double sign, const std::array<double, derivatives<d>>& c) {
        owner_.push_back(owner), sign_.push_back(sign);
        for (std::size_t k = 0; k < c.size(); ++k) c_[k].push_back(sign * c[k]);
        ++rows_[writing_].end;
    }
    /// What all of it takes in memory, on average for each row.
    double bytes() const {
        const std::size_t entry = sizeof(std::uint32_t) + sizeof(double) * (1 + c_.size());
        return static_cast<double>(sizeof(Range) * size() + entry * entries()) / static_cast<double>(size());
    }
    std::size_t entries(std::size_t i) const { return rows_[i].end - rows_[i].begin; }

    /// out_i = sum_j c_kij f_j.
    void apply(std::size_t k, std::span<const double> f, Parity parity, Column& out) const {
        out.resize(size());
        for (std::size_t i = 0; i < size(); ++i) {
            double sum = 0;
            for (std::size_t e = rows_[i].begin; e < rows_[i].end; ++e)
                sum += c_[k][e] * (parity == Parity::odd ? 1 : sign_[e]) * f[owner_[e]];
            out[i] = sum;
        }
    }
    /// Slope and curvature of an odd function on a line, in one sweep over the entries.
    void apply_both(std::span<const double> f, Column& slope, Column& curvature) const {
        // [apply]
        for (std::size_t i = 0; i < size(); ++i) {
            double first = 0, second = 0;
            for (std::size_t e = rows_[i].begin; e < rows_[i].end; ++e) {
                first += c_[1][e] * f[owner_[e]];
                second += c_[2][e] * f[owner_[e]];
            }
            slope[i] = first, curvature[i] = second;
        }
        // [end]
    }

  private:
    struct Range {
        std::size_t begin = 0, end = 0;  // of the entries
    };
    std::vector<Range> rows_;
    std::size_t writing_ = 0;
    std::vector<std::uint32_t> owner_;
    Column sign_;
    std::array<Column, derivatives<d>> c_;  // for odd functions: of images with their sign
};

}  // namespace sph
