// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/element_boxes.h"

#include "solver/lanes/in_registers.h"
#include "solver/lanes/lane_geometry.h"

namespace stiction {

template <int Bytes>
STICTION_LANES_INLINE void ElementBoxes::bound_side_by_side(const Scene& scene, const Body& body,
                                                            const std::vector<Vec3>& x, Real margin,
                                                            const Box3& within) {
  using Number = Lanes<Bytes>;
  constexpr int kCount = Number::kCount;
  constexpr unsigned kAll = (1U << kCount) - 1;
  const BoxLanes<Bytes> wanted(within);
  const int end = body.first_element + body.element_count;
  std::size_t kept = 0;
  for (int first = body.first_element; first < end; first += kCount) {
    const auto corner = [&](int k) __attribute__((always_inline)) {
      return at_vertices<Number>(x, [&](int lane) {
        return scene.elements[static_cast<std::size_t>(std::min(first + lane, end - 1))].vertex[k];
      });
    };
    const LaneVector<Number> a = corner(0), b = corner(1), c = corner(2), d = corner(3);
    BoxLanes<Bytes> boxes;
    const auto bound_along = [&](int axis, const Number& p, const Number& q, const Number& r,
                                 const Number& s) __attribute__((always_inline)) {
      boxes.low[axis] = lesser(lesser(p, q), lesser(r, s)) - Number(margin);
      boxes.high[axis] = greater(greater(p, q), greater(r, s)) + Number(margin);
    };
    bound_along(0, a.x, b.x, c.x, d.x);
    bound_along(1, a.y, b.y, c.y, d.y);
    bound_along(2, a.z, b.z, c.z, d.z);
    unsigned bits = boxes.meeting(wanted);
    if (end - first < kCount) bits &= (1U << (end - first)) - 1;
    // Where all are wanted, as in the midst of a pile, they are there already.
    box_.set_lanes(kept, boxes);
    if (bits == kAll) {
      for (int lane = 0; lane < kCount; ++lane) element_[kept++] = first + lane;
      continue;
    }
    const std::size_t from = kept;
    for (; bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      box_.set(kept, box_, from + static_cast<std::size_t>(lane));
      element_[kept++] = first + lane;
    }
  }
  element_.resize(kept);
}

void ElementBoxes::bound(const Scene& scene, const Body& body, const std::vector<Vec3>& x,
                         Real margin, const Box3& within, int width) {
  const auto count = static_cast<std::size_t>(body.element_count);
  box_.reserve(count);
  element_.resize(count);
  in_lanes(
      body.element_count, width, [&](auto bytes) __attribute__((always_inline)) {
        bound_side_by_side<bytes>(scene, body, x, margin, within);
      });
  block_.reserve(blocks());
  for (std::size_t begin = 0; begin < size(); begin += kBlock) {
    Box3 block;
    for (std::size_t k = begin; k < std::min(begin + kBlock, size()); ++k) block.extend(box_[k]);
    block_.set(begin / kBlock, block);
  }
}

}  // namespace stiction
