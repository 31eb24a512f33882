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
  const int end = body.first_element + body.element_count;
  std::size_t kept = 0;
  for (int first = body.first_element; first < end; first += kCount) {
    const auto corner = [&](int k) __attribute__((always_inline)) {
      return at_vertices<Number>(x, [&](int lane) {
        return scene.elements[static_cast<std::size_t>(std::min(first + lane, end - 1))].vertex[k];
      });
    };
    const LaneVector<Number> a = corner(0), b = corner(1), c = corner(2), d = corner(3);
    Real low[3][kCount], high[3][kCount];
    const auto along = [&](int axis, const Number& p, const Number& q, const Number& r,
                           const Number& s) __attribute__((always_inline)) {
      const Number least = lesser(lesser(p, q), lesser(r, s)) - Number(margin);
      const Number most = greater(greater(p, q), greater(r, s)) + Number(margin);
      store_numbers(least, low[axis]);
      store_numbers(most, high[axis]);
      return (least <= Number(within.max()[axis])) & (Number(within.min()[axis]) <= most);
    };
    const auto meets =
        along(0, a.x, b.x, c.x, d.x) & along(1, a.y, b.y, c.y, d.y) & along(2, a.z, b.z, c.z, d.z);
    unsigned bits = first_bits(meets, static_cast<std::size_t>(end - first));
    for (; bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low_[axis][kept] = low[axis][lane];
        high_[axis][kept] = high[axis][lane];
      }
      element_[kept++] = first + lane;
    }
  }
  element_.resize(kept);
}

void ElementBoxes::bound(const Scene& scene, const Body& body, const std::vector<Vec3>& x,
                         Real margin, const Box3& within, int width) {
  const auto count = static_cast<std::size_t>(body.element_count);
  for (auto* side : {&low_, &high_}) {
    for (std::vector<Real>& numbers : *side) {
      numbers.resize(std::max(numbers.size(), count + static_cast<std::size_t>(kMostLanes)));
    }
  }
  element_.resize(count);
  in_lanes(
      body.element_count, width, [&](auto bytes) __attribute__((always_inline)) {
        bound_side_by_side<bytes>(scene, body, x, margin, within);
      });
  block_.assign((size() + kBlock - 1) / kBlock, Box3());
  for (std::size_t k = 0; k < size(); ++k) block_[k / kBlock].extend(box(k));
}

}  // namespace stiction
