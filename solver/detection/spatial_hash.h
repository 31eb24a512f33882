// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/detection/boxes.h"
#include "solver/lanes/lanes.h"
#include "solver/lanes/packed_vec3.h"
#include "solver/real.h"

namespace stiction {

/// Points hashed by the cell of a uniform grid that they are in [Teschner2003]:
///
///   hash(i, j, k) = (73856093·i ⊕ 19349663·j ⊕ 83492791·k) mod n
///
/// Deviations: n is a power of two (twice the number of points or more); the modulus is taken of
/// the unsigned product, so negative cells need no guard; the table is built by counting, which
/// allocates nothing once it is warm; each point carries its cell, so that two cells with one hash are
/// told apart; cells begin where the points do. Where the points fill the box of their cells, as those of a
/// surface where it touches another do, the cells are numbered row by row instead, and a row is looked up at
/// once. Points of a cell or row are compared side by side.
class SpatialHash {
 public:
  using Cell = Eigen::Matrix<std::int32_t, 3, 1>;

  /// Forgets all points; `cell_size` > 0, m.
  void clear(Real cell_size) {
    inverse_cell_size_ = 1 / cell_size;
    entries_.clear();
  }

  void add(std::int32_t point, const Vec3& x) {
    entries_.push_back({{x[0], x[1], x[2], 0}, Cell::Zero(), point});
  }

  /// To be called once, when all points are in. Returns the box around them, m; what is no number is not in it.
  STICTION_LANES_INLINE Box3 build() {
    const std::size_t count = entries_.size();
    const Box3 around = box_around(
        0, count, [&](std::size_t k) __attribute__((always_inline)) {
          return PackedVec3::load(&entries_[k].x);
        });
    point_.resize(count);
    inside_.resize(count);
    // What the last register reads beyond the last point is a number, and not looked at.
    for (std::vector<Real>& x : x_) x.resize(count + static_cast<std::size_t>(kMostLanes));
    if (count <= kFew) {
      for (std::size_t k = 0; k < count; ++k) put(k, entries_[k]);
      return around;
    }
    number_cells(around.min());
    std::size_t size = cells_;
    if (!by_rows()) {
      size = 16;
      while (size < 2 * count) size *= 2;
      mask_ = static_cast<std::uint32_t>(size - 1);
      cell_.resize(count);
    }
    begin_.assign(size + 1, 0);
    for (const Point& entry : entries_) ++begin_[bucket(entry.cell) + 1];
    for (std::size_t k = 1; k <= size; ++k) begin_[k] += begin_[k - 1];
    for (const Point& entry : entries_) {
      // Each bucket's begin moves to its end here, and back below.
      const std::size_t place = begin_[bucket(entry.cell)]++;
      put(place, entry);
      if (!by_rows()) cell_[place] = entry.cell;
    }
    for (std::size_t k = size; k > 0; --k) begin_[k] = begin_[k - 1];
    begin_[0] = 0;
    return around;
  }

  /// Places beyond the range of the cells' numbers, and what is no number, are in the outermost
  /// cells: an exploding body is slow to look up, not undefined.
  Cell cell(const Vec3& x) const { return to_cell(cell_of(x)); }

  /// The places of the points in the box, each once, until the next call, by registers of `Bytes`. All are
  /// compared where they are few, and where the box has far more cells than there are points.
  template <int Bytes>
  STICTION_LANES_INLINE std::span<const std::uint32_t> places_in(const Box3& box) {
    const InBox<Bytes> in_box(box, *this);
    std::size_t found = 0;
    const auto note = [&](std::size_t begin, std::size_t end, const auto& also)
        __attribute__((always_inline)) {
      for (std::size_t first = begin; first < end; first += InBox<Bytes>::kCount) {
        for (unsigned bits = in_box.bits(first, end); bits != 0; bits &= bits - 1) {
          const std::size_t k = first + static_cast<std::size_t>(std::countr_zero(bits));
          if (also(k)) inside_[found++] = static_cast<std::uint32_t>(k);
        }
      }
    };
    const auto any = [](std::size_t) { return true; };
    const auto all = [&]() __attribute__((always_inline)) {
      note(0, point_.size(), any);
      return std::span<const std::uint32_t>(inside_.data(), found);
    };
    if (entries_.size() <= kFew) return all();
    const Cell low = cell(box.min()), high = cell(box.max());
    if (by_rows()) {
      const Cell from = low.cwiseMax(low_), to = high.cwiseMin(high_);
      if (from[0] > to[0]) return {};
      for (std::int32_t k = from[2]; k <= to[2]; ++k) {
        for (std::int32_t j = from[1]; j <= to[1]; ++j) {
          const std::size_t first = bucket({from[0], j, k});
          note(begin_[first], begin_[first + static_cast<std::size_t>(to[0] - from[0]) + 1], any);
        }
      }
    } else {
      const Eigen::Array3d cells = (high - low).template cast<double>().array() + 1.0;
      if (cells.prod() > 64.0 + 8.0 * static_cast<double>(entries_.size())) return all();
      for (std::int32_t k = low[2]; k <= high[2]; ++k) {
        for (std::int32_t j = low[1]; j <= high[1]; ++j) {
          for (std::int32_t i = low[0]; i <= high[0]; ++i) {
            const Cell here(i, j, k);
            const std::size_t b = bucket(here);
            note(begin_[b], begin_[b + 1], [&](std::size_t e) { return cell_[e] == here; });
          }
        }
      }
    }
    return {inside_.data(), found};
  }

  /// The point in a place, as it was added.
  std::int32_t number(std::uint32_t place) const { return point_[place]; }
  STICTION_LANES_INLINE PackedVec3 at(std::uint32_t place) const {
    return PackedVec3(FourNumbers{x_[0][place], x_[1][place], x_[2][place], 0});
  }

  bool empty() const { return entries_.empty(); }

 private:
  struct Point {
    std::array<Real, 4> x;  // m, and a zero
    Cell cell;              // once the table is built, where points have cells
    std::int32_t number;
  };

  // Which of the points side by side are in a box.
  template <int Bytes>
  struct InBox {
    using Number = Lanes<Bytes>;
    static constexpr std::size_t kCount = Number::kCount;
    const SpatialHash& of;
    Number low[3], high[3];

    STICTION_LANES_INLINE InBox(const Box3& box, const SpatialHash& points) : of(points) {
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = Number(box.min()[axis]);
        high[axis] = Number(box.max()[axis]);
      }
    }
    // Of the points from `first` on, below `end`: a bit each.
    STICTION_LANES_INLINE unsigned bits(std::size_t first, std::size_t end) const {
      const auto along = [&](std::size_t axis) __attribute__((always_inline)) {
        const Number x = Number::load(&of.x_[axis][first]);
        return (low[axis] <= x) & (x <= high[axis]);
      };
      return first_bits(along(0) & along(1) & along(2), end - first);
    }
  };

  // So few have no cells.
  static constexpr std::size_t kFew = 24;

  void put(std::size_t place, const Point& entry) {
    for (int axis = 0; axis < 3; ++axis) {
      x_[static_cast<std::size_t>(axis)][place] = entry.x[axis];
    }
    point_[place] = entry.number;
  }

  // The numbers of its cell, as Real.
  STICTION_LANES_INLINE PackedVec3 cell_of(const PackedVec3& x) const {
    const FourNumbers farthest = FourNumbers{} + Real(1e9), one = FourNumbers{} + Real(1);
    const FourNumbers place = (x - PackedVec3::load(&origin_)).value * inverse_cell_size_;
    const FourNumbers above = -farthest < place ? place : -farthest;
    const FourNumbers near = above < farthest ? above : farthest;
    // Rounded down: without SSE 4.1, `std::floor` is a call.
    const FourNumbers whole =
        __builtin_convertvector(__builtin_convertvector(near, FourInts), FourNumbers);
    return PackedVec3(near < whole ? whole - one : whole);
  }
  STICTION_LANES_INLINE static Cell to_cell(const PackedVec3& of) {
    const FourInts numbers = __builtin_convertvector(of.value, FourInts);
    return {numbers[0], numbers[1], numbers[2]};
  }

  bool by_rows() const { return cells_ > 0; }

  // The box of the points' cells, and how many it has where they are few enough to be numbered. They begin
  // where points do: a sheet along axes is in one layer of them, wherever it is.
  STICTION_LANES_INLINE void number_cells(const Vec3& first) {
    cells_ = 0;
    origin_ = {};
    if (first.allFinite()) origin_ = {first[0], first[1], first[2], 0};
    PackedVec3 low = cell_of(PackedVec3::load(&entries_[0].x)), high = low;
    for (Point& entry : entries_) {
      const PackedVec3 at = cell_of(PackedVec3::load(&entry.x));
      entry.cell = to_cell(at);
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    low_ = to_cell(low);
    high_ = to_cell(high);
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
  std::array<Real, 4> origin_{};  // of the cells, m, and a zero
  std::uint32_t mask_ = 0;
  Cell low_ = Cell::Zero(), high_ = Cell::Zero();  // of the points' cells
  std::size_t cells_ = 0;                          // between those; 0: they are hashed
  std::vector<Point> entries_;
  std::vector<std::uint32_t> begin_;
  // Bucket by bucket:
  std::array<std::vector<Real>, 3> x_;
  std::vector<std::int32_t> point_;
  std::vector<Cell> cell_;  // where they are hashed
  std::vector<std::uint32_t> inside_;
};

}  // namespace stiction
