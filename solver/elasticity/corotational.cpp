// SPDX-License-Identifier: BSD-3-Clause
#include "solver/elasticity/corotational.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "solver/elasticity/rotation.h"
#include "solver/lanes/in_registers.h"
#include "solver/lanes/lane_matrix.h"
#include "solver/lanes/lane_width.h"
#include "solver/prefetch.h"

namespace stiction {

namespace {

Mat3 inverse_rest_edges(const Element& element) {
  return Eigen::Map<const Mat3>(element.inverse_rest_edges);
}

// Columns x₁ − x₀, x₂ − x₀, x₃ − x₀.
Mat3 edges(const Element& element, const std::vector<Position>& position) {
  const auto x = [&](int k) -> const Vec3& {
    return position[static_cast<std::size_t>(element.vertex[k])].x;
  };
  Mat3 d;
  for (int k = 0; k < 3; ++k) d.col(k) = x(k + 1) - x(0);
  return d;
}

// As many elements side by side as there are lanes, between the two halves of their work.
template <int Bytes>
struct ElementGroup {
  using Number = Lanes<Bytes>;
  static constexpr int kCount = Number::kCount;

  int count;  // of elements; lanes beyond it have the last again
  const Element* of[kCount];
  LaneMatrix<Number> inverse;  // of the rest edges
  Number two_mu_volume, lambda_volume, damping_time;
  LaneMatrix<Number> f, cofactor;
  LaneSymmetric<Number> gram;
  Number det;
  StretchRoot<Number> root;
};

// Differences of a field of vertices, records of four numbers, along the edges of a group.
template <int Bytes, class Record>
STICTION_LANES_INLINE LaneMatrix<Lanes<Bytes>> differences(const ElementGroup<Bytes>& group,
                                                           const std::vector<Record>& field) {
  constexpr int kCount = ElementGroup<Bytes>::kCount;
  Lanes<Bytes> corner[4][4];
  for (int k = 0; k < 4; ++k) {
    const Real* record[kCount];
    for (int lane = 0; lane < kCount; ++lane) {
      const auto vertex = static_cast<std::size_t>(group.of[lane]->vertex[k]);
      record[lane] = reinterpret_cast<const Real*>(&field[vertex]);
    }
    load_records(record, corner[k]);
  }
  LaneMatrix<Lanes<Bytes>> d;
  for (int k = 0; k < 3; ++k) {
    d.column[k] = {corner[k + 1][0] - corner[0][0], corner[k + 1][1] - corner[0][1],
                   corner[k + 1][2] - corner[0][2]};
  }
  return d;
}

// Elements come one after the other, but the processor's own asking ahead falls behind: out of the
// cache this takes them from 23 to 17 ns each, and in it nothing.
constexpr std::ptrdiff_t kElementsAhead = 32;
constexpr std::size_t kCacheLine = 64;  // bytes; an element has two of them

// Up to the root that is to be found.
template <int Bytes>
STICTION_LANES_INLINE void begin(const Element* first, std::size_t left,
                                 const std::vector<Position>& position,
                                 ElementGroup<Bytes>& group) {
  using Number = Lanes<Bytes>;
  constexpr int kCount = Number::kCount;
  group.count = static_cast<int>(std::min(left, std::size_t{kCount}));
  const Real* record[kCount];
  for (int lane = 0; lane < kCount; ++lane) {
    group.of[lane] = first + std::min(lane, group.count - 1);
    ask_for(group.of[lane] + kElementsAhead);
    ask_for(reinterpret_cast<const std::byte*>(group.of[lane] + kElementsAhead) + kCacheLine);
    record[lane] = group.of[lane]->inverse_rest_edges;
  }
  // Nine numbers of the inverse, then μV, λV, β.
  static_assert(offsetof(Element, damping_time) ==
                offsetof(Element, inverse_rest_edges) + 11 * sizeof(Real));
  Number constant[12];
  for (int k = 0; k < 12; k += 4) {
    load_records(record, constant + k);
    for (const Real*& numbers : record) numbers += 4;
  }
  for (int k = 0; k < 3; ++k) {
    group.inverse.column[k] = {constant[3 * k], constant[3 * k + 1], constant[3 * k + 2]};
  }
  group.two_mu_volume = Real(2) * constant[9];
  group.lambda_volume = constant[10];
  group.damping_time = constant[11];
  group.f = differences(group, position) * group.inverse;
  group.gram = gram(group.f);
  group.cofactor = cofactor(group.f);
  group.det = dot(group.f.column[0], group.cofactor.column[0]);
  group.root = {group.gram, group.det};
}

// `elastic_stress` of the flat elements of a group, by singular values. Out of the way, so that the
// others' stays in registers.
template <int Bytes>
[[gnu::noinline]] void replace_flat(const ElementGroup<Bytes>& group,
                                    LaneSymmetric<Lanes<Bytes>>& a, LaneMatrix<Lanes<Bytes>>& b) {
  for (int lane = 0; lane < Lanes<Bytes>::kCount; ++lane) {
    if (group.det[lane] > kFlattest) continue;  // no number is flat too
    const Element& element = *group.of[lane];
    const Mat3 f = one_of(group.f, lane);
    const Mat3 r = polar_rotation_by_svd(f);
    const Real stretch = r.cwiseProduct(f).sum();
    const Real two_mu = 2 * element.mu_volume;
    const Mat3 rest = (element.lambda_volume * (stretch - 3) - two_mu) * r;
    for (int k = 0; k < 3; ++k) {
      b.column[k].x.value[lane] = rest(0, k);
      b.column[k].y.value[lane] = rest(1, k);
      b.column[k].z.value[lane] = rest(2, k);
    }
    for (auto* diagonal : {&a.xx, &a.yy, &a.zz}) diagonal->value[lane] = two_mu;
    for (auto* other : {&a.xy, &a.yz, &a.zx}) other->value[lane] = 0;
  }
}

// V (2μ(F − R) + λ(tr S − 3)R), which is V R (2μ(S − I) + λ tr(S − I) I) without the product RᵀF,
// as F a + b with a symmetric.
template <int Bytes>
STICTION_LANES_INLINE void elastic_stress(const ElementGroup<Bytes>& group,
                                          LaneSymmetric<Lanes<Bytes>>& a,
                                          LaneMatrix<Lanes<Bytes>>& b) {
  using Number = Lanes<Bytes>;
  const PolarTerms<Number> r = group.root.terms();
  const Number k = group.lambda_volume * (r.stretch - Real(3)) - group.two_mu_volume;
  a = (k * r.gram) * group.gram;
  a.add_to_diagonal(group.two_mu_volume + k * r.f);
  const Number scale = k * r.cofactor;
  for (int m = 0; m < 3; ++m) b.column[m] = scale * group.cofactor.column[m];
  if (!all(Number(kFlattest) < group.det)) [[unlikely]] {
    LaneSymmetric<Number> a_of_all = a;
    LaneMatrix<Number> b_of_all = b;
    replace_flat(group, a_of_all, b_of_all);
    a = a_of_all;
    b = b_of_all;
  }
}

// β V (2μĖ + λ tr(Ė) I), and nothing where β is 0.
template <int Bytes>
STICTION_LANES_INLINE void add_viscous_stress(const ElementGroup<Bytes>& group,
                                              const std::vector<Velocity>& velocity,
                                              LaneSymmetric<Lanes<Bytes>>& a) {
  const auto damped = Lanes<Bytes>(Real(0)) < group.damping_time;
  if (none(damped)) return;
  const LaneSymmetric<Lanes<Bytes>> rate =
      symmetric_product(group.f, differences(group, velocity) * group.inverse);
  LaneSymmetric<Lanes<Bytes>> stress = group.two_mu_volume * rate;
  stress.add_to_diagonal(group.lambda_volume * rate.trace());
  a = choose_all<Bytes>(damped, a + group.damping_time * stress, a);
}

// Where the forces of a range of elements go: to their vertices, but for corners that an earlier range
// touches too.
struct ForceSink {
  ElementShare* share = nullptr;  // null: all go to their vertices
  std::size_t next_border = std::numeric_limits<std::size_t>::max();  // element
  std::size_t borders = 0, forces = 0;                                // that have passed

  explicit ForceSink(ElementShare* of) : share(of) {
    if (share != nullptr && !share->border.empty()) next_border = share->border[0].element;
  }
  // Of an element's corners those that are to be left aside; null for none.
  const bool* shared_of(std::size_t element) {
    if (element < next_border) return nullptr;
    const bool* const shared = share->border[borders++].shared;
    next_border = borders < share->border.size() ? share->border[borders].element
                                                 : std::numeric_limits<std::size_t>::max();
    return shared;
  }
};

// Of a group that has such corners. Out of the way, so that the others' stay in registers.
[[gnu::noinline]] void leave_aside(const Element* const* of, int count, std::size_t first,
                                   const FourNumbers* forces, int lanes, ForceSink& sink,
                                   std::vector<Force>& force) {
  for (int lane = 0; lane < count; ++lane) {
    const bool* const shared = sink.shared_of(first + static_cast<std::size_t>(lane));
    for (int k = 0; k < 4; ++k) {
      const FourNumbers of_corner = forces[k * lanes + lane];
      const FourNumbers f = k == 0 ? -of_corner : of_corner;
      if (shared != nullptr && shared[k]) {
        reinterpret_cast<FourNumbers&>(sink.share->force[sink.forces++]) = f;
      } else {
        reinterpret_cast<FourNumbers&>(force[static_cast<std::size_t>(of[lane]->vertex[k])]) += f;
      }
    }
  }
}

// Adds the forces of the corners, an element after the other.
template <int Bytes>
STICTION_LANES_INLINE void end(const ElementGroup<Bytes>& group, std::size_t first,
                               const std::vector<Velocity>& velocity, ForceSink& sink,
                               std::vector<Force>& force) {
  using Number = Lanes<Bytes>;
  LaneSymmetric<Number> a;
  LaneMatrix<Number> b;
  elastic_stress(group, a, b);
  add_viscous_stress(group, velocity, a);
  LaneMatrix<Number> minus_stress = group.f * a.whole();
  for (int m = 0; m < 3; ++m) minus_stress.column[m] = -(minus_stress.column[m] + b.column[m]);
  const LaneMatrix<Number> corner = minus_stress * group.inverse.transpose();
  const auto& [f1, f2, f3] = corner.column;
  const LaneVector<Number> minus_f0 = f1 + (f2 + f3);
  FourNumbers forces[4][Number::kCount];
  store_records(minus_f0.x, minus_f0.y, minus_f0.z, forces[0]);
  store_records(f1.x, f1.y, f1.z, forces[1]);
  store_records(f2.x, f2.y, f2.z, forces[2]);
  store_records(f3.x, f3.y, f3.z, forces[3]);
  const auto at = [&](int lane, int k) -> FourNumbers& {
    const auto vertex = static_cast<std::size_t>(group.of[lane]->vertex[k]);
    return reinterpret_cast<FourNumbers&>(force[vertex]);
  };
  if (first + static_cast<std::size_t>(group.count) <= sink.next_border) [[likely]] {
    for (int lane = 0; lane < group.count; ++lane) {
      for (int k = 1; k < 4; ++k) at(lane, k) += forces[k][lane];
      at(lane, 0) -= forces[0][lane];
    }
    return;
  }
  leave_aside(group.of, group.count, first, &forces[0][0], Number::kCount, sink, force);
}

struct ElementRange {
  const std::vector<Element>& elements;
  std::size_t begin, end;
  ElementShare* share;  // null: all elements
};

// Groups at a time: the roots of several are found side by side, for each step waits for a division.
constexpr int kGroups = 4;

template <int Bytes>
STICTION_LANES_INLINE void add_forces(const ElementRange& range, const State& state,
                                      std::vector<Force>& force) {
  constexpr std::size_t kLanes = Lanes<Bytes>::kCount;
  ForceSink sink(range.share);
  for (std::size_t e = range.begin; e < range.end;) {
    ElementGroup<Bytes> group[kGroups];
    const std::size_t first = e;
    int groups = 0;
    for (; groups < kGroups && e < range.end; ++groups, e += kLanes) {
      begin(&range.elements[e], range.end - e, state.position, group[groups]);
    }
    using Number = Lanes<Bytes>;
    for (int step = 0; step < StretchRoot<Number>::kMostSteps; ++step) {
      Number running(Real(0));
      for (int g = 0; g < groups; ++g) {
        group[g].root.improve();
        running += group[g].root.running;
      }
      if (all_zero(running)) break;
    }
    for (int g = 0; g < groups; ++g) {
      end(group[g], first + static_cast<std::size_t>(g) * kLanes, state.velocity, sink, force);
    }
  }
}

void add_forces_at(int width, const ElementRange& range, const State& state,
                   std::vector<Force>& force) {
  const auto count = static_cast<int>(range.end - range.begin);
  in_lanes(
      count, width, [&](auto bytes) __attribute__((always_inline)) {
        add_forces<bytes>(range, state, force);
      });
}

}  // namespace

void add_corotational_forces(const std::vector<Element>& elements, const State& state,
                             std::vector<Force>& force, int width) {
  add_forces_at(width, {elements, 0, elements.size(), nullptr}, state, force);
}

void add_corotational_forces(const std::vector<Element>& elements, const State& state,
                             std::vector<Force>& force) {
  add_corotational_forces(elements, state, force, lane_width());
}

void add_corotational_forces(const Scene& scene, const State& state, const Team& team,
                             ElementShares& shares, std::vector<Force>& force) {
  // With fewer in a range, what it takes to wake a thread is more than it does.
  constexpr std::size_t kFewest = 2048;
  const std::size_t count = ranges_of(&team, scene.elements.size(), kFewest);
  if (count == 1) {
    add_corotational_forces(scene.elements, state, force);
    return;
  }
  share_elements(scene, count, shares);
  const int width = lane_width();
  for_each(&team, count, [&](std::size_t s) {
    ElementShare& share = shares.share[s];
    add_forces_at(width, {scene.elements, share.begin, share.end, &share}, state, force);
  });
  add_forces_left_aside(shares, force);
}

double elastic_energy(const std::vector<Element>& elements, const std::vector<Position>& position) {
  double energy = 0.0;
  for (const Element& element : elements) {
    const Mat3 f = edges(element, position) * inverse_rest_edges(element);
    const Mat3 strain = polar_rotation(f).transpose() * f - Mat3::Identity();
    energy += element.mu_volume * strain.squaredNorm() +
              Real(0.5) * element.lambda_volume * strain.trace() * strain.trace();
  }
  return energy;
}

}  // namespace stiction
