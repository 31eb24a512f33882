// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "solver/lanes/lane_matrix.h"
#include "solver/lanes/lane_records.h"

namespace stiction {

/// A field of the vertices at one vertex a lane; of a State's positions as well.
template <class Number, class Record, class VertexOf>
STICTION_LANES_INLINE LaneVector<Number> at_vertices(const std::vector<Record>& field,
                                                     const VertexOf& vertex_of) {
  const Real* record[Number::kCount];
  for (int lane = 0; lane < Number::kCount; ++lane) {
    record[lane] = reinterpret_cast<const Real*>(&field[static_cast<std::size_t>(vertex_of(lane))]);
  }
  Number columns[4];
  if constexpr (sizeof(Record) == 4 * sizeof(Real)) {
    load_records(record, columns);
  } else {
    static_assert(sizeof(Record) == 3 * sizeof(Real));
    load_triples(record, columns);
  }
  return {columns[0], columns[1], columns[2]};
}

/// A scalar product that sums as Eigen does of three numbers: (x + y) + z in double precision, where
/// two go in a register, else x + (y + z).
template <class Number>
STICTION_LANES_INLINE Number dot_as_eigen(const LaneVector<Number>& a,
                                          const LaneVector<Number>& b) {
  if constexpr (sizeof(Real) == sizeof(double)) return (a.x * b.x + a.y * b.y) + a.z * b.z;
  return dot(a, b);
}

/// `normalized()` of Eigen, lane by lane, with its bits: a vector of no length stays as it is.
template <class Number>
STICTION_LANES_INLINE LaneVector<Number> normalized_as_eigen(const LaneVector<Number>& a) {
  const Number length2 = dot_as_eigen(a, a), zero(Real(0));
  return a / choose_below(zero, length2, sqrt(length2), Number(Real(1)));
}

/// `barycentric` (detection/holding.h), lane by lane, with its bits.
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

}  // namespace stiction
