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
  constexpr std::size_t kBoxes = BoxBlock::kBoxes;
  const BoxLanes<Bytes> wanted(within);
  const int end = body.first_element + body.element_count;
  std::size_t count = 0, kept = 0;  // of all, and of those not yet in a block
  const auto end_block = [&](std::size_t boxes) __attribute__((always_inline)) {
    BoxBlock& block = block_.emplace_back();
    around_.set(block_.size() - 1, block.take<Bytes>(box_, boxes));
  };
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
      // Of two the other way round: of the same comparison the compiler would make a mask, and choose by it.
      boxes.high[axis] = greater(greater(q, p), greater(s, r)) + Number(margin);
    };
    bound_along(0, a.x, b.x, c.x, d.x);
    bound_along(1, a.y, b.y, c.y, d.y);
    bound_along(2, a.z, b.z, c.z, d.z);
    unsigned bits = boxes.meeting(wanted);
    if (end - first < kCount) bits &= (1U << (end - first)) - 1;
    // Where all are wanted, as in the midst of a pile, they are there already.
    box_.set_lanes(kept, boxes);
    if (bits == kAll) {
      for (int lane = 0; lane < kCount; ++lane) element_[count++] = first + lane;
      kept += static_cast<std::size_t>(kCount);
    } else {
      const std::size_t from = kept;
      for (; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits);
        box_.set(kept++, box_, from + static_cast<std::size_t>(lane));
        element_[count++] = first + lane;
      }
    }
    if (kept < kBoxes) continue;
    end_block(kBoxes);
    kept -= kBoxes;
    for (std::size_t k = 0; k < kept; ++k) box_.set(k, box_, kBoxes + k);
  }
  if (kept > 0) end_block(kept);
  element_.resize(count);
}

void ElementBoxes::bound(const Scene& scene, const Body& body, const std::vector<Vec3>& x,
                         Real margin, const Box3& within, int width) {
  const auto count = static_cast<std::size_t>(body.element_count);
  const std::size_t blocks = count / BoxBlock::kBoxes + 1;  // at most
  box_.reserve(2 * BoxBlock::kBoxes);  // a block, and what a register has beyond
  around_.reserve(blocks);
  block_.clear();
  block_.reserve(blocks);
  element_.resize(count);
  in_lanes(
      body.element_count, width, [&](auto bytes) __attribute__((always_inline)) {
        bound_side_by_side<bytes>(scene, body, x, margin, within);
      });
}

}  // namespace stiction
