// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reports/record/record.h"
#include "solver/scene/scene.h"
#include "validation/engine/problem.h"

namespace stiction {

/// How finely the solver resolves shapes that bring no mesh of their own.
struct Discretisation {
  int cells = 2;  ///< along a box's longest edge, ≥ 1
  int ball = 8;   ///< frequency n of a ball's triangulation: 10 n² + 2 surface vertices
};

/// The problem as the solver takes it: meshes for shapes, densities for masses, pinned vertices for
/// held parts; bodies and obstacles in the problem's order. Throws InputError for a mass that is
/// not positive and finite, and for a held part that holds no vertex.
SceneDescription scene_description(const Problem& problem, const Discretisation& how);

/// Where the solver's coordinates count from, m: the middle of a scene that is farther from the origin
/// than it is wide, by more than a few times, so that its coordinates keep their digits; else zero.
Eigen::Vector3d own_origin(const Problem& problem);

/// The scene as it is seen from there.
Problem seen_from(const Eigen::Vector3d& origin, Problem problem);

/// The meshes of the bodies, one entry for all bodies that share one; point masses have none.
std::vector<Mesh> distinct_meshes(const SceneDescription& scene);

}  // namespace stiction
