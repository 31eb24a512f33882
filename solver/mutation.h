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
  kFrictionScaled,  ///< μ scaled by 1.02
  kFrictionSign,    ///< friction pushes along the slip
  kStaleMemory,     ///< friction memory and stick flag outlive slip
};

inline constexpr Mutation kMutation = Mutation::STICTION_MUTATION;

}  // namespace stiction
