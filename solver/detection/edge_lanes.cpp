// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/edge_lanes.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "solver/depth/nearest_face.h"
#include "solver/lanes/in_registers.h"
#include "solver/lanes/lane_geometry.h"

namespace stiction {

namespace {

// An edge a lane (`frame_of`).
template <class Number>
struct LaneEdge {
  LaneVector<Number> first, whole;  // m
  Number length;                    // m
  LaneVector<Number> into[2];

  STICTION_LANES_INLINE LaneEdge(const Topology& topology, const std::vector<Vec3>& x,
                                 const std::int32_t* edge) {
    const auto sharp = [&](int lane) -> const Topology::SharpEdge& {
      return topology.sharp_edge[static_cast<std::size_t>(edge[lane])];
    };
    const auto at = [&](const auto& vertex_of) __attribute__((always_inline)) {
      return at_vertices<Number>(x, [&](int lane) { return vertex_of(sharp(lane)); });
    };
    using SharpEdge = Topology::SharpEdge;
    first = at([](const SharpEdge& e) { return e.vertex[0]; });
    whole = at([](const SharpEdge& e) { return e.vertex[1]; }) - first;
    length = sqrt(dot_as_eigen(whole, whole));
    const LaneVector<Number> along = normalized_as_eigen(whole);
    for (int k = 0; k < 2; ++k) {
      const LaneVector<Number> to = at([k](const SharpEdge& e) { return e.opposite[k]; }) - first;
      into[k] = normalized_as_eigen(to - dot_as_eigen(along, to) * along);
    }
  }

  // Whether a place 0 … 1 along it is no farther beyond an end than so much (`inside_ends`).
  STICTION_LANES_INLINE typename Number::Mask reaches(const Number& along,
                                                      const Number& beyond) const {
    const Number zero(Real(0)), one(Real(1));
    return (zero <= along * length + beyond) & (zero <= (one - along) * length + beyond);
  }
};

// `meet`, `inside_ends` and `face`, with their bits.
template <int Bytes>
STICTION_LANES_INLINE unsigned can_touch(const Topology& topology, const std::vector<Vec3>& x,
                                         Real most_beyond, EdgeBatch& batch) {
  using Number = Lanes<Bytes>;
  const Number zero(Real(0)), one(Real(1)), half(Real(0.5)), behind(kBehind), beyond(most_beyond);
  const LaneEdge<Number> a(topology, x, batch.a), b(topology, x, batch.b);
  const LaneVector<Number> across = cross(a.whole, b.whole);
  const Number across2 = dot_as_eigen(across, across);
  const Number parallel2 = Number(kParallel * kParallel) * dot_as_eigen(a.whole, a.whole) *
                           dot_as_eigen(b.whole, b.whole);
  const auto crossed = parallel2 < across2;
  // Of those that aren't, a number that nothing is made of.
  const Number divisor = choose(crossed, across2, one);
  const LaneVector<Number> between = b.first - a.first;
  const Number along_a = dot_as_eigen(cross(between, b.whole), across) / divisor;
  const Number along_b = dot_as_eigen(cross(between, a.whole), across) / divisor;
  const auto far = [&](const Number& along) __attribute__((always_inline)) {
    return (one < along - half) | (one < half - along);
  };
  const auto meet = crossed & ~(far(along_a) | far(along_b));
  const auto held = a.reaches(along_a, beyond) & b.reaches(along_b, beyond);
  const LaneVector<Number> one_way = across / sqrt(divisor);
  const auto turned = zero < dot_as_eigen(one_way, b.into[0] + b.into[1]);
  const LaneVector<Number> normal{choose(turned, -one_way.x, one_way.x),
                                  choose(turned, -one_way.y, one_way.y),
                                  choose(turned, -one_way.z, one_way.z)};
  const auto before = [&](const LaneEdge<Number>& edge, int k) __attribute__((always_inline)) {
    return dot_as_eigen(normal, edge.into[k]);
  };
  const auto hidden = (behind < before(b, 0)) | (behind < before(b, 1)) |
                      (dot_as_eigen(normal, a.into[0] + a.into[1]) <= zero) |
                      (before(a, 0) < -behind) | (before(a, 1) < -behind);
  store_numbers(a.length, batch.length_a);
  store_numbers(b.length, batch.length_b);
  Real found_a[Number::kCount], found_b[Number::kCount];
  FourNumbers plane[Number::kCount];
  store_numbers(along_a, found_a);
  store_numbers(along_b, found_b);
  store_records(normal.x, normal.y, normal.z, -dot_as_eigen(normal, between), plane);
  static_assert(offsetof(EdgeCrossing, gap) == offsetof(EdgeCrossing, normal) + 3 * sizeof(Real));
  for (int lane = 0; lane < Number::kCount; ++lane) {
    EdgeCrossing& crossing = batch.crossing[lane];
    crossing.along_a = found_a[lane];
    crossing.along_b = found_b[lane];
    std::memcpy(crossing.normal.data(), &plane[lane], sizeof plane[lane]);  // and gap
  }
  return (meet & held & ~hidden).bits();
}

// Some contacts, the last of them for the lanes that are left.
template <int Bytes>
STICTION_LANES_INLINE void weigh(const State& state, const std::vector<Velocity>& velocity,
                                 EdgeContact* contact, int count) {
  using Number = Lanes<Bytes>;
  const auto of = [&](int lane) -> EdgeContact& { return contact[std::min(lane, count - 1)]; };
  const auto x = [&](const auto& vertex_of) __attribute__((always_inline)) {
    return at_vertices<Number>(state.position, [&](int lane) { return vertex_of(of(lane)); });
  };
  const auto numbers = [&](const auto& number_of) __attribute__((always_inline)) {
    const Real* number[Number::kCount];
    for (int lane = 0; lane < Number::kCount; ++lane) number[lane] = &number_of(of(lane));
    return load_numbers<Bytes>(number);
  };
  const Number zero(Real(0));
  LaneVector<Number> point{zero, zero, zero};
  Number inverse_mass = zero;
  const auto add_mass = [&](const Number& weight, const auto& vertex_of)
      __attribute__((always_inline)) {
    inverse_mass += weight * weight * numbers([&](const EdgeContact& c) -> const Real& {
                      return velocity[static_cast<std::size_t>(vertex_of(c))].inverse_mass;
                    });
  };
  for (int k = 0; k < 2; ++k) {
    const auto vertex = [k](const EdgeContact& c) { return c.vertex[k]; };
    const Number weight =
        numbers([k](const EdgeContact& c) -> const Real& { return c.own_weight[k]; });
    point = point + weight * x(vertex);
    add_mass(weight, vertex);
  }
  const LaneWeights<Number> weights(point, x([](const EdgeContact& c) { return c.partner[0]; }),
                                    x([](const EdgeContact& c) { return c.partner[1]; }),
                                    x([](const EdgeContact& c) { return c.partner[2]; }),
                                    x([](const EdgeContact& c) { return c.partner[3]; }));
  for (int k = 0; k < 4; ++k) {
    add_mass(weights.of[k], [k](const EdgeContact& c) { return c.partner[k]; });
  }
  FourNumbers weight[Number::kCount];
  store_records(weights.of[0], weights.of[1], weights.of[2], weights.of[3], weight);
  Real masses[Number::kCount];
  store_numbers(inverse_mass, masses);
  for (int lane = 0; lane < count; ++lane) {
    std::memcpy(contact[lane].weight, &weight[lane], sizeof weight[lane]);
    contact[lane].inverse_mass = masses[lane];
  }
}

}  // namespace

unsigned cross_side_by_side(const Topology& topology, const std::vector<Vec3>& x, Real beyond,
                            int width, EdgeBatch& batch) {
  std::fill(batch.a + batch.count, batch.a + kMostLanes, batch.a[0]);
  std::fill(batch.b + batch.count, batch.b + kMostLanes, batch.b[0]);
  unsigned can = 0;
  in_lanes(
      batch.count, width, [&](auto bytes) __attribute__((always_inline)) {
        can = can_touch<bytes>(topology, x, beyond, batch);
      });
  return can & ((1U << batch.count) - 1);
}

void set_partners(const Scene& scene, const State& state, const std::vector<Velocity>& velocity,
                  int width, std::span<EdgeContact> contacts) {
  for (EdgeContact& contact : contacts) {
    const auto& corner = scene.elements[static_cast<std::size_t>(contact.element)].vertex;
    std::copy(std::begin(corner), std::end(corner), contact.partner);
  }
  const auto most = static_cast<std::size_t>(lanes_of(width));
  for (std::size_t done = 0; done < contacts.size(); done += most) {
    const auto count = static_cast<int>(std::min(contacts.size() - done, most));
    in_lanes(
        count, width, [&](auto bytes) __attribute__((always_inline)) {
          weigh<bytes>(state, velocity, &contacts[done], count);
        });
  }
}

}  // namespace stiction
