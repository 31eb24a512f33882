// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a scene may do without. A build leaves out at most one, to measure what that feature costs
// those who don't use it (benchmarks/bench/features.h); every other build has all of them.

namespace stiction {

enum class Feature {
  kNone,
  kPostCorrection,  ///< reaction of the normal force on the partners [Lazarevych2009, (6)]
  kFrictionMemory,  ///< carried from step to step
  kSelfCollision,   ///< contacts of a body with itself
  kEdgeContacts,    ///< of edges that cross
  kElasticity,      ///< forces of the tetrahedra
  kTiming,          ///< of the phases
};

#ifdef STICTION_WITHOUT
inline constexpr Feature kLeftOut = Feature::STICTION_WITHOUT;
#else
inline constexpr Feature kLeftOut = Feature::kNone;
#endif

/// Whether this build has the feature.
constexpr bool built_in(Feature feature) { return feature != kLeftOut; }

}  // namespace stiction
