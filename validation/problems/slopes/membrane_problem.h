// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/motion/membrane.h"
#include "validation/engine/problem.h"

namespace stiction {

/// A box on an inclined membrane that a dead weight keeps taut. x runs down the slope from the held
/// upper end, z out of it.
///
/// The strip's lower end is one with a heavy block that lies on a frictionless plane, so that the
/// tension is known without a fit: T = (block + half the strip) · g sin θ. The strip starts in the
/// shape that it has under its own load and the box's, which depends on their ratio to T only and
/// so stays while gravity grows. It must grow slowly: the block hangs on an elastic strip, and
/// until it has caught up (√6/ω = 0.2 s, ω² = g sin θ/(strain · ℓ)) the strip sags more than it
/// should; nothing damps that later.
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
  double box_mass = 0.15;           ///< kg
  Vec3 box_size{0.08, 0.04, 0.05};  ///< m
  double start = 0.25;              ///< s₀, m
  /// Takes away what loading has set swinging, and is gone before the slope turns: the start of the
  /// slide is then the string's, not a matter of the swing's phase.
  Drag drag{.rate = 20.0, .full_until = 1.8, .ends = 2.0};
  int cells_along = 40;  ///< of the strip
  int cells_across = 3;  ///< of strip and block
};

/// The string model of the set-up, at full load.
reference::MembraneProblem membrane_string(const MembraneSetup& setup);

/// Of the slope on which gravity grows; flat enough for the box to stick.
inline constexpr double kMembraneFirstTangent = 0.5;

/// When gravity has its full size on that slope; and when it has turned to the full slope, s.
inline constexpr double kMembraneLoaded = 2.0, kMembraneTilted = 2.8;

/// Bodies: the membrane (0) and the box (1).
Problem membrane_problem(const MembraneSetup& setup);

}  // namespace stiction
