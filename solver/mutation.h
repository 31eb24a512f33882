// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Planted faults, to prove that the validation cases bite. A build plants at most one, for the
// mutation test; every other build compiles to the correct code alone.
#ifndef STICTION_MUTATION
#define STICTION_MUTATION kNone
#endif

namespace stiction {

enum class Mutation {
  kNone,
  kFrictionScaled,    ///< μ scaled by 1.02
  kFrictionSign,      ///< friction pushes along the slip
  kStaleMemory,       ///< friction memory and stick flag outlive slip
  kGainReversed,      ///< rules learn, or correct what they store, with the wrong sign
  kStalePairMemory,   ///< between bodies: renewed only in steps that change the contacts
  kFrictionReaction,  ///< friction's reaction on the partners 2 % too small
  kNormalReaction,    ///< the normal force's reaction on the partners 2 % too small
  kHalfLeftOut,       ///< the paper's normal force transmitted whole, without the ½ of (6)
  kLoadUncounted,     ///< (5) deleted, c = 1; harmonic gain: every load is 1
  kWeightSum,         ///< weights of the partners sum to 1.02
  kLeverArm,          ///< 2 % of the reaction moved from one partner to another
  kLostContact,       ///< one contact between bodies is lost every 100 steps
  kDepthFlipped,      ///< the depths of one triangle point into the body
  kEdgeReaction,      ///< reaction of crossing edges 2 % too small
};

inline constexpr Mutation kMutation = Mutation::STICTION_MUTATION;

}  // namespace stiction
