// SPDX-License-Identifier: BSD-3-Clause
#include "solver/elasticity/corotational.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "solver/elasticity/rotation.h"
#include "solver/lanes/in_registers.h"
#include "solver/lanes/lane_matrix.h"
#include "solver/lanes/lane_records.h"
#include "solver/lanes/lane_width.h"
#include "solver/prefetch.h"

namespace stiction {

namespace {

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
  std::size_t first;
  // Of each corner, the first number of its record in a field of fewer than 2³⁰ vertices. Once for three
  // fields: the loads are so many that what finds their addresses counts.
  std::uint32_t corner[kCount][4];
  const Real* constants;  // ElementConstants, number by number; read again where they are asked for
  LaneMatrix<Number> f, cofactor;
  LaneSymmetric<Number> gram;
  Number det;
  StretchRoot<Number> root;

  STICTION_LANES_INLINE Number constant(std::size_t which) const {
    return Number::load(constants + which * BlocksOfConstants::kBlock);
  }
  STICTION_LANES_INLINE LaneMatrix<Number> inverse_rest_edges() const {
    static_assert(offsetof(ElementConstants, inverse_rest_edges) == 0);
    LaneMatrix<Number> inverse;
    for (std::size_t k = 0; k < 3; ++k) {
      inverse.column[k] = {constant(3 * k), constant(3 * k + 1), constant(3 * k + 2)};
    }
    return inverse;
  }
  STICTION_LANES_INLINE Number two_mu_volume() const {
    return Real(2) * constant(offsetof(ElementConstants, mu_volume) / sizeof(Real));
  }
  STICTION_LANES_INLINE Number lambda_volume() const {
    return constant(offsetof(ElementConstants, lambda_volume) / sizeof(Real));
  }
  STICTION_LANES_INLINE Number damping_time() const {
    return constant(offsetof(ElementConstants, damping_time) / sizeof(Real));
  }
};

// Differences of a field of vertices, records of four numbers, along the edges of a group.
template <int Bytes, class Record>
STICTION_LANES_INLINE LaneMatrix<Lanes<Bytes>> differences(const ElementGroup<Bytes>& group,
                                                           const std::vector<Record>& field) {
  constexpr int kCount = ElementGroup<Bytes>::kCount;
  const auto* const first = reinterpret_cast<const Real*>(field.data());
  const auto corner = [&](int k) __attribute__((always_inline)) {
    const Real* record[kCount];
    for (int lane = 0; lane < kCount; ++lane) record[lane] = first + group.corner[lane][k];
    return LaneRecords<Bytes>::load(record);
  };
  const LaneRecords<Bytes> origin = corner(0);
  LaneMatrix<Lanes<Bytes>> d;
  for (int k = 0; k < 3; ++k) {
    const auto numbers = (corner(k + 1) - origin).transposed();
    d.column[k] = {numbers.part[0], numbers.part[1], numbers.part[2]};
  }
  return d;
}

// Elements come one after the other, but the processor's own asking ahead falls behind: out of the
// cache this takes them from 23 to 17 ns each, and in it nothing.
constexpr std::size_t kElementsAhead = 32;

// Of so many vertices, the records of position, velocity and force, 3 MiB, don't stay in a second-level cache.
constexpr std::size_t kManyVertices = 32768;

// What elements read and write of their corners.
struct CornerRecords {
  const std::vector<Position>& position;
  const std::vector<Velocity>& velocity;
  const std::vector<Force>& force;

  // By two of them: neighbours have the others, and to ask for all takes more than it gives (0.93 of the time
  // of 10⁵ contacts on plates, 0.91 with two; in a wall 0.82 and 0.78).
  void ask_for_corners(const Element& element) const {
    for (const int k : {0, 3}) {
      const auto v = static_cast<std::size_t>(element.vertex[k]);
      ask_for(&position[v]);
      ask_for(&velocity[v]);
      ask_for(&force[v]);
    }
  }
};

// Up to the root that is to be found.
template <int Bytes>
STICTION_LANES_INLINE void begin(const Scene& scene, std::size_t first, std::size_t left,
                                 const CornerRecords& corners, ElementGroup<Bytes>& group) {
  using Number = Lanes<Bytes>;
  constexpr int kCount = Number::kCount;
  static_assert(BlocksOfConstants::kBlock % kCount == 0);
  group.count = static_cast<int>(std::min(left, std::size_t{kCount}));
  group.first = first;
  unrolled<kCount>([&](auto lane) __attribute__((always_inline)) {
    const Element& element = *(&scene.elements[first] + std::min<int>(lane, group.count - 1));
    FourInts corner;
    std::memcpy(&corner, element.vertex, sizeof corner);
    corner *= 4;
    std::memcpy(group.corner[lane], &corner, sizeof corner);
  });
  group.constants = scene.constants.first(first);
  constexpr std::size_t kNumbers = BlocksOfConstants::kNumbers;
  unrolled<kNumbers>([&](auto k) __attribute__((always_inline)) {
    ask_for(group.constants + k * BlocksOfConstants::kBlock + kElementsAhead * kNumbers);
  });
  if (corners.position.size() >= kManyVertices && left >= kElementsAhead + kCount) {
    const Element* const ahead = &scene.elements[first + kElementsAhead];
    for (int lane = 0; lane < kCount; ++lane) corners.ask_for_corners(ahead[lane]);
  }
  group.f = differences(group, corners.position) * group.inverse_rest_edges();
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
  const Lanes<Bytes> two_mu_volume = group.two_mu_volume(), lambda_volume = group.lambda_volume();
  for (int lane = 0; lane < Lanes<Bytes>::kCount; ++lane) {
    if (group.det[lane] > kFlattest) continue;  // no number is flat too
    const Mat3 f = one_of(group.f, lane);
    const Mat3 r = polar_rotation_by_svd(f);
    const Real stretch = r.cwiseProduct(f).sum();
    const Real two_mu = two_mu_volume[lane];
    const Mat3 rest = (lambda_volume[lane] * (stretch - 3) - two_mu) * r;
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
  const Number two_mu_volume = group.two_mu_volume();
  const Number k = group.lambda_volume() * (r.stretch - Real(3)) - two_mu_volume;
  a = (k * r.gram) * group.gram;
  a.add_to_diagonal(two_mu_volume + k * r.f);
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
  const Lanes<Bytes> damping_time = group.damping_time();
  const auto damped = Lanes<Bytes>(Real(0)) < damping_time;
  if (none(damped)) return;
  const LaneSymmetric<Lanes<Bytes>> rate =
      symmetric_product(group.f, differences(group, velocity) * group.inverse_rest_edges());
  LaneSymmetric<Lanes<Bytes>> stress = group.two_mu_volume() * rate;
  stress.add_to_diagonal(group.lambda_volume() * rate.trace());
  const LaneSymmetric<Lanes<Bytes>> sum = a + damping_time * stress;
  if (all(damped)) [[likely]] {
    a = sum;
  } else {
    a = choose_all<Bytes>(damped, sum, a);
  }
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
template <int Bytes>
[[gnu::noinline]] void leave_aside(const ElementGroup<Bytes>& group,
                                   const LaneRecords<Bytes>* corner, ForceSink& sink,
                                   std::vector<Force>& force) {
  FourNumbers forces[4][ElementGroup<Bytes>::kCount];
  for (int k = 0; k < 4; ++k) corner[k].store(forces[k]);
  for (int lane = 0; lane < group.count; ++lane) {
    const bool* const shared = sink.shared_of(group.first + static_cast<std::size_t>(lane));
    for (int k = 0; k < 4; ++k) {
      const FourNumbers f = k == 0 ? forces[k][lane] : -forces[k][lane];
      const auto vertex = static_cast<std::size_t>(group.corner[lane][k] / 4);
      if (shared != nullptr && shared[k]) {
        reinterpret_cast<FourNumbers&>(sink.share->force[sink.forces++]) = f;
      } else {
        reinterpret_cast<FourNumbers&>(force[vertex]) += f;
      }
    }
  }
}

// Adds the forces of the corners, an element after the other.
template <int Bytes>
STICTION_LANES_INLINE void end(const ElementGroup<Bytes>& group,
                               const std::vector<Velocity>& velocity, ForceSink& sink,
                               std::vector<Force>& force) {
  using Number = Lanes<Bytes>;
  LaneSymmetric<Number> a;
  LaneMatrix<Number> b;
  elastic_stress(group, a, b);
  add_viscous_stress(group, velocity, a);
  LaneMatrix<Number> stress = group.f * a.whole();
  for (int m = 0; m < 3; ++m) stress.column[m] = stress.column[m] + b.column[m];
  const LaneMatrix<Number> minus_corner = stress * group.inverse_rest_edges().transpose();
  const auto& [f1, f2, f3] = minus_corner.column;
  const auto records = [](const LaneVector<Number>& f) __attribute__((always_inline)) {
    return LaneRecords<Bytes>{{f.x, f.y, f.z, Number(Real(0))}}.transposed();
  };
  // Of corner 0 as it is, of others their opposites.
  const LaneRecords<Bytes> of_corner[4] = {records(f1 + (f2 + f3)), records(f1), records(f2),
                                           records(f3)};
  if (group.first + static_cast<std::size_t>(group.count) > sink.next_border) [[unlikely]] {
    leave_aside(group, of_corner, sink, force);
    return;
  }
  auto* const numbers = reinterpret_cast<Real*>(force.data());
  unrolled<Number::kCount>([&](auto lane) __attribute__((always_inline)) {
    if (lane >= group.count) return;
    const auto at = [&](int k) __attribute__((always_inline)) {
      return reinterpret_cast<FourNumbers*>(numbers + group.corner[lane][k]);
    };
    for (int k = 1; k < 4; ++k) *at(k) -= of_corner[k].template of_lane<lane>().value;
    *at(0) += of_corner[0].template of_lane<lane>().value;
  });
}

struct ElementRange {
  const Scene& scene;
  std::size_t begin, end;  // begins a block of constants
  ElementShare* share;     // null: all elements
};

// Groups at a time: the roots of several are found side by side, for each step waits for a division.
constexpr int kGroups = 4;

template <int Bytes>
STICTION_LANES_INLINE void add_forces(const ElementRange& range, const State& state,
                                      std::vector<Force>& force) {
  constexpr std::size_t kLanes = Lanes<Bytes>::kCount;
  ForceSink sink(range.share);
  const CornerRecords corners{state.position, state.velocity, force};
  for (std::size_t e = range.begin; e < range.end;) {
    ElementGroup<Bytes> group[kGroups];
    int groups = 0;
    for (; groups < kGroups && e < range.end; ++groups, e += kLanes) {
      begin(range.scene, e, range.end - e, corners, group[groups]);
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
      end(group[g], state.velocity, sink, force);
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

void add_corotational_forces(const Scene& scene, const State& state, std::vector<Force>& force,
                             int width) {
  add_forces_at(width, {scene, 0, scene.elements.size(), nullptr}, state, force);
}

void add_corotational_forces(const Scene& scene, const State& state, std::vector<Force>& force) {
  add_corotational_forces(scene, state, force, lane_width());
}

void add_corotational_forces(const Scene& scene, const State& state, const Team& team,
                             ElementShares& shares, std::vector<Force>& force) {
  // With fewer in a share, what it takes to wake a thread is more than it does; and what lies at the border
  // of shares is done twice, so that each thread has two.
  constexpr std::size_t kFewest = 2048;
  const auto threads = static_cast<std::size_t>(team.size());
  std::size_t count = std::min(ranges_of(&team, scene.elements.size(), kFewest), 2 * threads);
  if (count > threads) count -= count % threads;
  if (count == 1) {
    add_corotational_forces(scene, state, force);
    return;
  }
  share_elements(scene, count, shares);
  const int width = lane_width();
  for_each(&team, count, [&](std::size_t s) {
    ElementShare& share = shares.share[s];
    add_forces_at(width, {scene, share.begin, share.end, &share}, state, force);
  });
  add_forces_left_aside(shares, force);
}

double elastic_energy(const Scene& scene, const std::vector<Position>& position) {
  double energy = 0.0;
  for (std::size_t e = 0; e < scene.elements.size(); ++e) {
    const ElementConstants constants = scene.constants[e];
    const Mat3 f =
        edges(scene.elements[e], position) * Eigen::Map<const Mat3>(constants.inverse_rest_edges);
    const Mat3 strain = polar_rotation(f).transpose() * f - Mat3::Identity();
    energy += constants.mu_volume * strain.squaredNorm() +
              Real(0.5) * constants.lambda_volume * strain.trace() * strain.trace();
  }
  return energy;
}

}  // namespace stiction
