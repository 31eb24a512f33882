// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/real.h"

namespace stiction {

/// How strongly a depth is answered.
enum class NormalGain {
  kPaper,  ///< γᵢ mᵢ/Δt², (3)–(5): what of the depth is closed (κ) depends on the contact set
  kHarmonic  ///< bounded: κ ≤ κ₀ for every contact set
};

/// Where the reaction of a contact goes.
enum class PairWeights {
  kTriangle,    ///< three barycentric weights of the projection on the nearest triangle [(1)]
  kTetrahedron  ///< four weights of xᵢ in the penetrated tetrahedron at the start of the step
};

/// Direction and size of the penetration depth.
enum class DepthRule {
  kProjection,  ///< orthogonal projection on the nearest surface triangle
  kConsistent   ///< [Heidelberger2004]: averaged over crossing edges, propagated inwards
};

/// Which surface triangle a vertex is pushed out through.
enum class PairFace {
  kNearest,  ///< the nearest, whatever the two surfaces look like there
  /// The nearest of those that the vertex can rest on: no edge of its own surface leads behind the
  /// triangle's plane. Where boxes are flush, a corner is nearest to the side wall of the other.
  kOpposed
};

/// By what a contact is recognised in the next step.
enum class PairKey {
  kBody,     ///< (vertex, body): survives the change to a neighbouring triangle
  kTriangle  ///< (vertex, triangle): the literal reading; memory is lost at each triangle's edge
};

/// Settings of two-sided contacts; the defaults are the quiet method. What old and paper are is said
/// once, by the adapter's presets (validation/engines/stiction/stiction_method.cpp).
struct PairOptions {
  NormalGain gain = NormalGain::kHarmonic;
  Real harmonic_gain = 1.0;  ///< κ₀, dimensionless, in (0, 4/3)
  PairWeights weights = PairWeights::kTetrahedron;
  DepthRule depth = DepthRule::kProjection;
  PairFace face = PairFace::kOpposed;
  PairKey key = PairKey::kBody;
  bool edges = true;              ///< crossing edges touch too, which no vertex sees
  bool post_correction = true;    ///< (6): half of F on the vertex, half on its partners
  bool friction_reaction = true;  ///< friction acts on the partners too
  bool literal_bound = false;  ///< μ|F| instead of μ × the transmitted force: sticks up to 2μ
  bool normals_first = true;   ///< all normal forces, then friction; else pair by pair
  /// Contacts are kept with F = 0 up to a gap of `hysteresis` · |g|Δt T, at most a hundredth of a
  /// mean edge (depth/open_limits.h); dimensionless.
  Real hysteresis = 1.0;
  /// A vertex that has slipped sideways over the border of the face that it lies on is kept up to
  /// this distance, in mean edges. Where borders coincide, rounding alone would choose.
  Real border_margin = 1e-3;
  bool count_hysteresis = true;  ///< such contacts count in the harmonic gain
  /// A contact stays with its triangle while that is at most this much farther than the nearest,
  /// relative to the depth. Where a vertex is as near to two faces, rounding alone would choose
  /// anew in each step, and the normal would jump. Not once it is no longer over that triangle.
  Real tie_margin = 1e-3;
  /// A depth is wrong by up to this share of it, evenly spread and anew in each step: what a coarse
  /// or approximate detection does to friction. 0 but in tests.
  Real depth_noise = 0.0;
};

}  // namespace stiction
