// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/limit/limit_analysis.h"
#include "validation/engine/problem.h"

namespace stiction {

/// A semicircular arch of equal, straight-edged voussoirs without mortar, whose two ends stand on
/// level ground. Each is the hexahedron between two joints; the corners lie on circles of radius
/// R ± t/2. Friction is more than it needs, so that it can only fall by hinges.
struct ArchSetup {
  int blocks = 13;
  double radius = 1.0;      ///< R of the centreline at the joints, m
  double thickness = 0.12;  ///< t, m
  double depth = 0.3;       ///< across, m
  double friction = 0.8;    ///< μ of all contacts
  double density = 2000.0;  ///< kg/m³
  double full = 0.3;        ///< gravity has grown to full, s
  double drag_ends = 0.0;   ///< 0.2 s after a medium fades, in which the arch settles, s; 0: none
  Elasticity elasticity{.youngs_modulus = 1e8, .poisson_ratio = 0.0, .damping_time = 1e-4};
};

/// Bodies: the blocks from the end at −R to that at R, x along the span.
Problem arch_problem(const ArchSetup& setup);

/// Rigid blocks that touch at the four corners of each joint.
reference::LimitProblem arch_limit(const ArchSetup& setup);

/// Least thickness, m, at which the arch of so many blocks stands: bracketed by limit analysis to
/// 1e-6 of R. Its share of R for 13 blocks is 0.102527.
double least_thickness(ArchSetup setup);

}  // namespace stiction
