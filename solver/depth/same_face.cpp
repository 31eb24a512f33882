// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/same_face.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "solver/depth/nearest_face.h"
#include "solver/lanes/lane_width.h"

namespace stiction {

namespace {

struct Step {
  const Scene& scene;
  const PairOptions& options;
  const State& state;
  const Workspace& workspace;
};

// A field of the vertices at one vertex a lane.
template <class Number, class VertexOf>
STICTION_LANES_INLINE LaneVector<Number> at_vertices(const std::vector<Vec3>& field,
                                                     const VertexOf& vertex_of) {
  const Real* record[Number::kCount];
  for (int lane = 0; lane < Number::kCount; ++lane) {
    record[lane] = field[static_cast<std::size_t>(vertex_of(lane))].data();
  }
  Number columns[3];
  load_triples(record, columns);
  return {columns[0], columns[1], columns[2]};
}

// A scalar product that sums as Eigen does of three numbers: (x + y) + z in double precision, where
// two go in a register, else x + (y + z).
template <class Number>
STICTION_LANES_INLINE Number dot_as_eigen(const LaneVector<Number>& a,
                                          const LaneVector<Number>& b) {
  if constexpr (sizeof(Real) == sizeof(double)) return (a.x * b.x + a.y * b.y) + a.z * b.z;
  return dot(a, b);
}

// `barycentric` (detect_pairs.h), lane by lane, with its bits.
template <class Number>
struct LaneWeights {
  Number of[4];

  STICTION_LANES_INLINE LaneWeights(const LaneVector<Number>& point, const LaneVector<Number>& a,
                                    const LaneVector<Number>& b, const LaneVector<Number>& c,
                                    const LaneVector<Number>& d) {
    const LaneVector<Number> ab = b - a, ac = c - a, ad = d - a, ap = point - a;
    const LaneVector<Number> ac_ad = cross(ac, ad);
    const Number volume = dot_as_eigen(ab, ac_ad);
    of[1] = dot_as_eigen(ap, ac_ad) / volume;
    of[2] = dot_as_eigen(ab, cross(ap, ad)) / volume;
    of[3] = dot_as_eigen(ab, cross(ac, ap)) / volume;
    of[0] = Number(Real(1)) - of[1] - of[2] - of[3];
  }
};

// `nearest_on_triangle` (nearest.h) of points whose projection falls inside, and `outward_normal`.
template <class Number>
struct LaneProjection {
  typename Number::Mask inside;
  Number weight[3];
  Number distance2;
  LaneVector<Number> normal;

  STICTION_LANES_INLINE LaneProjection(const LaneVector<Number>& p, const LaneVector<Number>& a,
                                       const LaneVector<Number>& b, const LaneVector<Number>& c) {
    const Number zero(Real(0)), one(Real(1));
    const LaneVector<Number> ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const Number d1 = dot_as_eigen(ab, ap), d2 = dot_as_eigen(ac, ap), d3 = dot_as_eigen(ab, bp),
                 d4 = dot_as_eigen(ac, bp), d5 = dot_as_eigen(ab, cp), d6 = dot_as_eigen(ac, cp);
    const Number vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    const LaneVector<Number> across = cross(ab, ac);
    const Number length2 = dot_as_eigen(across, across);
    // Of none of the corners, of none of the edges; and a number.
    inside = ((zero < d1) | (zero < d2)) & ((d3 < zero) | (d3 < d4)) & ((d6 < zero) | (d6 < d5)) &
             (zero < va) & (zero < vb) & (zero < vc) & (zero < length2);
    const Number sum = va + vb + vc;
    weight[1] = vb / sum;
    weight[2] = vc / sum;
    weight[0] = one - weight[1] - weight[2];
    const LaneVector<Number> off = weight[0] * a + weight[1] * b + weight[2] * c - p;
    distance2 = dot_as_eigen(off, off);
    normal = across / sqrt(length2);
  }
};

// Whether no triangle of the list but its own can be as near as `reach`, m; `moved` is what vertex and
// triangles have moved since the list was made (project_by_list in nearest_face.cpp).
bool is_nearest(const PairSearch& search, const PairSearch::Group& group, std::int32_t own,
                Real reach, Real moved) {
  for (std::int32_t k = group.near_begin; k < group.near_end; ++k) {
    const PairSearch::Near& near = search.near[static_cast<std::size_t>(k)];
    if (near.distance - moved > reach) return true;
    if (near.triangle != own) return false;
  }
  return true;
}

// Of the vertices of a batch, or of their partner of a number, 1/kg.
template <int Bytes>
STICTION_LANES_INLINE Lanes<Bytes> inverse_masses(const std::vector<Velocity>& velocity,
                                                  const FaceBatch& batch, int partner = -1) {
  const Real* of[Lanes<Bytes>::kCount];
  for (int lane = 0; lane < Lanes<Bytes>::kCount; ++lane) {
    const PairContact& contact = *batch.contact[lane];
    const std::int32_t v = partner < 0 ? contact.vertex : contact.partner[partner];
    of[lane] = &velocity[static_cast<std::size_t>(v)].inverse_mass;
  }
  return load_numbers<Bytes>(of);
}

template <int Bytes>
STICTION_LANES_INLINE unsigned measure(const Step& step, const FaceBatch& batch) {
  using Number = Lanes<Bytes>;
  constexpr int kCount = Number::kCount;
  const Topology& topology = step.scene.topology;
  const PairOptions& options = step.options;
  const std::vector<Velocity>& velocity = step.workspace.velocity;
  const PairSearch& search = step.workspace.search;
  const auto& triangles = topology.triangle;
  const int count = std::min(batch.count, kCount);
  const auto of_triangle = [&](int k) __attribute__((always_inline)) {
    return at_vertices<Number>(search.predicted, [&](int lane) {
      return triangles[static_cast<std::size_t>(batch.contact[lane]->triangle)].vertex[k];
    });
  };
  const auto vertex = [&](int lane) { return batch.contact[lane]->vertex; };
  const LaneVector<Number> point = at_vertices<Number>(search.predicted, vertex);
  const LaneVector<Number> moved = point - at_vertices<Number>(search.reference, vertex);
  const LaneProjection<Number> projection(point, of_triangle(0), of_triangle(1), of_triangle(2));
  const Number distance = sqrt(projection.distance2), moved_by = sqrt(dot_as_eigen(moved, moved)),
               far = sqrt(dot_as_eigen(point, point));
  unsigned left = 0;
  for (int lane = 0; lane < count; ++lane) {
    const PairContact& contact = *batch.contact[lane];
    const auto body = static_cast<std::size_t>(contact.other);
    const Real deepest = kSqueezed * topology.least_width[body];
    const bool stays =
        projection.inside[lane] && projection.distance2[lane] < deepest * deepest &&
        is_nearest(search, *batch.group[lane], contact.triangle, distance[lane],
                   moved_by[lane] + search.moved[body] + list_rounding(search, far[lane]));
    if (!stays) left |= 1U << lane;
  }
  if (left + 1 == 1U << count) return left;

  Number weight[4];
  const bool of_faces = options.weights == PairWeights::kTriangle;
  if (of_faces) {
    for (int k = 0; k < 3; ++k) weight[k] = projection.weight[k];
    weight[3] = Number(Real(0));
    for (int lane = 0; lane < count; ++lane) {
      if ((left >> lane & 1U) != 0) continue;
      PairContact& contact = *batch.contact[lane];
      const auto& corner = triangles[static_cast<std::size_t>(contact.triangle)].vertex;
      for (int k = 0; k < 4; ++k) contact.partner[k] = corner[std::min(k, 2)];
    }
  } else {
    const auto x = [&](const auto& vertex_of) __attribute__((always_inline)) {
      const Real* record[kCount];
      for (int lane = 0; lane < kCount; ++lane) {
        const auto v = static_cast<std::size_t>(vertex_of(*batch.contact[lane]));
        record[lane] = reinterpret_cast<const Real*>(&step.state.position[v]);
      }
      Number columns[4];
      load_records(record, columns);
      return LaneVector<Number>{columns[0], columns[1], columns[2]};
    };
    const auto corner = [&](int k) __attribute__((always_inline)) {
      return x([k](const PairContact& contact) { return contact.partner[k]; });
    };
    const LaneWeights<Number> weights(x([](const PairContact& contact) { return contact.vertex; }),
                                      corner(0), corner(1), corner(2), corner(3));
    for (int k = 0; k < 4; ++k) weight[k] = weights.of[k];
  }
  Number inverse_mass = inverse_masses<Bytes>(velocity, batch);
  for (int k = 0; options.friction_reaction && k < 4; ++k) {
    inverse_mass += weight[k] * weight[k] * inverse_masses<Bytes>(velocity, batch, k);
  }

  FourNumbers plane[kCount], weights[kCount];
  store_records(projection.normal.x, projection.normal.y, projection.normal.z, distance, plane);
  store_records(weight[0], weight[1], weight[2], weight[3], weights);
  static_assert(offsetof(PairContact, depth) == offsetof(PairContact, normal) + 3 * sizeof(Real));
  for (int lane = 0; lane < count; ++lane) {
    if ((left >> lane & 1U) != 0) continue;
    PairContact& contact = *batch.contact[lane];
    std::memcpy(contact.normal.data(), &plane[lane], sizeof plane[lane]);  // and depth
    std::memcpy(contact.weight, &weights[lane], sizeof weights[lane]);
    contact.inverse_mass = inverse_mass[lane];
    contact.excess = 0.0;
  }
  return left;
}

unsigned measure_2(const Step& step, const FaceBatch& batch) { return measure<16>(step, batch); }
STICTION_TARGET_4 unsigned measure_4(const Step& step, const FaceBatch& batch) {
  return measure<32>(step, batch);
}
STICTION_TARGET_8 unsigned measure_8(const Step& step, const FaceBatch& batch) {
  return measure<64>(step, batch);
}

}  // namespace

unsigned measure_on_same_face(const Scene& scene, const PairOptions& options, const State& state,
                              const Workspace& workspace, int width, FaceBatch& batch) {
  std::fill(batch.contact + batch.count, batch.contact + kMostLanes, batch.contact[0]);
  std::fill(batch.group + batch.count, batch.group + kMostLanes, batch.group[0]);
  const Step step{scene, options, state, workspace};
  return width == 8   ? measure_8(step, batch)
         : width == 4 ? measure_4(step, batch)
                      : measure_2(step, batch);
}

}  // namespace stiction
