// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace stiction::reference {

/// Σ mₖ (nowₖ − beforeₖ), kg m/s: reckoned in rational numbers from the doubles as they are, then the
/// nearest double of each component. Masses in kg, velocities in m/s, as many of each. Throws
/// std::invalid_argument for unequal counts and for what is not finite.
Eigen::Vector3d exact_momentum_change(const std::vector<double>& mass,
                                      const std::vector<Eigen::Vector3d>& before,
                                      const std::vector<Eigen::Vector3d>& now);

}  // namespace stiction::reference
