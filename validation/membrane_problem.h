// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/membrane.h"
#include "validation/problem.h"

namespace stiction {

/// A box on an inclined membrane that a dead weight keeps taut. x runs down the slope from the held
/// upper end, z out of it.
///
/// The strip's lower end is one with a heavy block that lies on a frictionless plane, so that the
/// tension is known without a fit: T = (block + half the strip) · g sin θ. The strip starts in the
/// shape that it has under its own load and the box's, which depends on their ratio to T only and
/// so stays while gravity grows.
struct MembraneSetup {
  double friction = 0.6;            ///< μ
  double tan_slope = 0.6;           ///< tan θ: 30.96°
  double length = 1.0;              ///< ℓ, m
  double width = 0.1;               ///< m
  double thickness = 0.01;          ///< m
  double block_length = 0.5;        ///< m
  double block_height = 0.2;        ///< m
  double density = 1000.0;          ///< of strip and block, kg/m³
  double modulus = 2e6;             ///< Pa
  double box_mass = 0.3;            ///< kg
  Vec3 box_size{0.08, 0.08, 0.05};  ///< m
  double start = 0.25;              ///< s₀, m
};

/// The string model of the set-up, at full load.
reference::MembraneProblem membrane_string(const MembraneSetup& setup);

/// When gravity has its full size, but a slope of tan θ = 0.5, on which the box sticks; and when it
/// has turned to the full slope, s.
inline constexpr double kMembraneLoaded = 0.6, kMembraneTilted = 1.0;

/// Bodies: the membrane (0) and the box (1).
Problem membrane_problem(const MembraneSetup& setup);

}  // namespace stiction
