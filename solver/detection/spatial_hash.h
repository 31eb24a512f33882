// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solver/detection/boxes.h"
#include "solver/real.h"

namespace stiction {

/// Points hashed by the cell of a uniform grid that they are in [Teschner2003]:
///
///   hash(i, j, k) = (73856093·i ⊕ 19349663·j ⊕ 83492791·k) mod n
///
/// Deviations: n is a power of two (twice the number of points or more); the modulus is taken of
/// the unsigned product, so negative cells need no guard; the table is built by counting, which
/// keeps the points of a cell in their order and allocates nothing once it is warm; each point
/// carries its cell, so that two cells with one hash are told apart. Where the points fill the box of
/// their cells, as those of a surface where it touches another do, the cells are numbered row by row
/// instead, and a row is looked up at once.
class SpatialHash {
 public:
  using Cell = Eigen::Matrix<std::int32_t, 3, 1>;

  /// Forgets all points; `cell_size` > 0, m.
  void clear(Real cell_size) {
    inverse_cell_size_ = 1 / cell_size;
    entries_.clear();
  }

  void add(std::int32_t point, const Vec3& x) { entries_.push_back({x, cell(x), point}); }

  /// To be called once, when all points are in.
  void build() {
    number_cells();
    std::size_t size = cells_;
    if (!by_rows()) {
      size = 16;
      while (size < 2 * entries_.size()) size *= 2;
      mask_ = static_cast<std::uint32_t>(size - 1);
    }
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

  /// Calls `use(point)` for each point in the box, once a point. Few points are walked, and so are all
  /// where the box has far more cells than there are points.
  template <class Use>
  void for_each_in(const Box3& box, Use&& use) const {
    const auto use_inside = [&](std::uint32_t begin, std::uint32_t end, const auto& also) {
      for (std::uint32_t e = begin; e < end; ++e) {
        const Entry& entry = sorted_[e];
        if (also(entry) && holds(box, entry.x)) use(entry.point);
      }
    };
    const auto any = [](const Entry&) { return true; };
    const auto walk = [&] { use_inside(0, static_cast<std::uint32_t>(sorted_.size()), any); };
    constexpr std::size_t kFew = 24;  // as in most meetings of a pile
    if (sorted_.size() <= kFew) return walk();
    const Cell low = cell(box.min()), high = cell(box.max());
    if (by_rows()) {
      const Cell from = low.cwiseMax(low_), to = high.cwiseMin(high_);
      if (from[0] > to[0]) return;
      for (std::int32_t k = from[2]; k <= to[2]; ++k) {
        for (std::int32_t j = from[1]; j <= to[1]; ++j) {
          const std::size_t first = bucket({from[0], j, k});
          use_inside(begin_[first], begin_[first + static_cast<std::size_t>(to[0] - from[0]) + 1],
                     any);
        }
      }
      return;
    }
    const Eigen::Array3d cells = (high - low).template cast<double>().array() + 1.0;
    if (cells.prod() > 64.0 + 8.0 * static_cast<double>(entries_.size())) {
      return walk();
    }
    for (std::int32_t k = low[2]; k <= high[2]; ++k) {
      for (std::int32_t j = low[1]; j <= high[1]; ++j) {
        for (std::int32_t i = low[0]; i <= high[0]; ++i) {
          const Cell here(i, j, k);
          const std::size_t b = bucket(here);
          use_inside(begin_[b], begin_[b + 1],
                     [&](const Entry& entry) { return entry.cell == here; });
        }
      }
    }
  }

  bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    Vec3 x;
    Cell cell;
    std::int32_t point;
  };

  bool by_rows() const { return cells_ > 0; }

  // The box of the points' cells, and how many it has where they are few enough to be numbered.
  void number_cells() {
    cells_ = 0;
    if (entries_.empty()) return;
    low_ = high_ = entries_[0].cell;
    for (const Entry& entry : entries_) {
      low_ = low_.cwiseMin(entry.cell);
      high_ = high_.cwiseMax(entry.cell);
    }
    const Eigen::Array3d cells = high_.cast<double>().array() - low_.cast<double>().array() + 1.0;
    if (cells.prod() <= 8.0 * static_cast<double>(entries_.size()) + 64.0) {
      cells_ = static_cast<std::size_t>(cells.prod());
    }
  }

  std::size_t bucket(const Cell& c) const {
    if (by_rows()) {
      const auto at = (c - low_).cast<std::size_t>();
      const auto count = (high_ - low_).cast<std::size_t>();
      return (at[2] * (count[1] + 1) + at[1]) * (count[0] + 1) + at[0];
    }
    const auto u = c.cast<std::uint32_t>();
    return (73856093u * u[0] ^ 19349663u * u[1] ^ 83492791u * u[2]) & mask_;
  }

  Real inverse_cell_size_ = 1.0;
  std::uint32_t mask_ = 0;
  Cell low_ = Cell::Zero(), high_ = Cell::Zero();  // of the points' cells
  std::size_t cells_ = 0;                          // between those; 0: they are hashed
  std::vector<Entry> entries_;
  std::vector<Entry> sorted_;
  std::vector<std::uint32_t> begin_;
};

}  // namespace stiction
