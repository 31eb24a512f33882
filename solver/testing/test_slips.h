// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/friction/rule.h"

/// For the tests of friction rules.
namespace stiction::test {

inline constexpr double kInverseMass = 0.25;  ///< w of the contacts, m/s/N

/// A contact that stuck in the last step, with slips in m/s and a bound in N.
inline SlipProblem stuck(const Vec3& free_slip, const Vec3& start_slip, double bound = 1e150) {
  return {.free_slip = free_slip,
          .start_slip = start_slip,
          .inverse_mass = kInverseMass,
          .bound = bound,
          .was = ContactStatus::kStick};
}

}  // namespace stiction::test
