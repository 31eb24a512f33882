// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solver/real.h"

namespace stiction {

/// Points hashed by the cell of a uniform grid that they are in [Teschner2003]:
///
///   hash(i, j, k) = (73856093·i ⊕ 19349663·j ⊕ 83492791·k) mod n
///
/// Deviations: n is a power of two (twice the number of points or more); the modulus is taken of
/// the unsigned product, so negative cells need no guard; the table is built by counting, which
/// keeps the points of a cell in their order and allocates nothing once it is warm; each point
/// carries its cell, so that two cells with one hash are told apart.
class SpatialHash {
 public:
  using Cell = Eigen::Matrix<std::int32_t, 3, 1>;

  /// Forgets all points; `cell_size` > 0, m.
  void clear(Real cell_size) {
    inverse_cell_size_ = 1 / cell_size;
    entries_.clear();
  }

  void add(std::int32_t point, const Vec3& x) { entries_.push_back({cell(x), point}); }

  /// To be called once, when all points are in.
  void build() {
    std::size_t size = 16;
    while (size < 2 * entries_.size()) size *= 2;
    mask_ = static_cast<std::uint32_t>(size - 1);
    begin_.assign(size + 1, 0);
    for (const Entry& entry : entries_) ++begin_[bucket(entry.cell) + 1];
    for (std::size_t k = 1; k <= size; ++k) begin_[k] += begin_[k - 1];
    sorted_.resize(entries_.size());
    for (const Entry& entry : entries_) {
      // Each bucket's begin moves to its end here, and back below.
      sorted_[begin_[bucket(entry.cell)]++] = entry;
    }
    for (std::size_t k = size; k > 0; --k) begin_[k] = begin_[k - 1];
    begin_[0] = 0;
  }

  /// Places beyond the range of the cells' numbers, and what is no number, are in the outermost
  /// cells: an exploding body is slow to look up, not undefined.
  Cell cell(const Vec3& x) const {
    constexpr Real kFarthest = 1e9;
    const auto number = [&](Real along) {
      const Real place = std::floor(along * inverse_cell_size_);
      return static_cast<std::int32_t>(place >= -kFarthest ? std::min(place, kFarthest)
                                                           : -kFarthest);
    };
    return {number(x[0]), number(x[1]), number(x[2])};
  }

  /// Calls `use(point)` for each point in the cells from `low` to `high`, both included, once a
  /// point. Where there are far more cells than points, the points are walked instead.
  template <class Use>
  void for_each_in(const Cell& low, const Cell& high, Use&& use) const {
    const Eigen::Array3d cells = (high - low).template cast<double>().array() + 1.0;
    if (cells.prod() > 64.0 + 8.0 * static_cast<double>(entries_.size())) {
      for (const Entry& entry : sorted_) {
        const auto& c = entry.cell;
        if ((c.array() >= low.array()).all() && (c.array() <= high.array()).all()) use(entry.point);
      }
      return;
    }
    for (std::int32_t k = low[2]; k <= high[2]; ++k) {
      for (std::int32_t j = low[1]; j <= high[1]; ++j) {
        for (std::int32_t i = low[0]; i <= high[0]; ++i) {
          const Cell here(i, j, k);
          const std::size_t b = bucket(here);
          for (std::uint32_t e = begin_[b]; e < begin_[b + 1]; ++e) {
            if (sorted_[e].cell == here) use(sorted_[e].point);
          }
        }
      }
    }
  }

  bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    Cell cell;
    std::int32_t point;
  };

  std::size_t bucket(const Cell& c) const {
    const auto u = c.cast<std::uint32_t>();
    return (73856093u * u[0] ^ 19349663u * u[1] ^ 83492791u * u[2]) & mask_;
  }

  Real inverse_cell_size_ = 1.0;
  std::uint32_t mask_ = 0;
  std::vector<Entry> entries_;
  std::vector<Entry> sorted_;
  std::vector<std::uint32_t> begin_;
};

}  // namespace stiction
