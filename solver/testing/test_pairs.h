// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Two-sided contacts for the unit tests of the solver.

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>
#include <utility>

#include "solver/depth/depth.h"
#include "solver/detection/detect_pairs.h"
#include "solver/motion/predict.h"
#include "solver/options.h"
#include "solver/testing/test_scenes.h"

namespace stiction::test {

/// A cube of 3³ cells and edge 1 at the origin, and one of 2³ cells above it that reaches `depth`
/// into it, shifted by `shift` along x and y. μ = 0.5.
inline SceneDescription stacked_cubes(double depth, const Vec3& shift = Vec3(0.21, 0.13, 0.0)) {
  SceneDescription description;
  description.bodies = {elastic_body(cube_mesh(3)), elastic_body(cube_mesh(2))};
  description.bodies[0].name = "lower";
  description.bodies[1].name = "upper";
  description.bodies[1].mesh.vertices.colwise() += shift + Vec3(0.0, 0.0, 1.0 - depth);
  description.friction = 0.5;
  return description;
}

/// What `depths` finds when every vertex goes on with its present velocity.
struct Found {
  State state;
  Workspace workspace;

  Found(const Scene& scene, const Options& options, State start) : state(std::move(start)) {
    workspace.velocity = state.velocity;
    detect_pairs(scene, options, state, workspace);
    depths(scene, options, state, workspace);
  }
};

/// The contacts by `depths`, measured side by side or one at a time: a depth that is not answered yet, of a
/// contact that there is not, has it look each up.
inline PairContacts measured_by_depths(const Scene& scene, const Options& options, State state,
                                       Workspace workspace, bool one_at_a_time) {
  state.pair_geometry.excess.clear();
  if (one_at_a_time) state.pair_geometry.excess.push_back({contact_key(1 << 20, 1 << 20), 0.0});
  depths(scene, options, state, workspace);
  return workspace.pairs;
}

/// What the search knows of a key; null if it has no candidates.
inline PairSearch::Group* group_of(PairSearch& search, ContactKey key) {
  const auto found = std::find_if(search.group.begin(), search.group.end(),
                                  [key](const PairSearch::Group& one) { return one.key == key; });
  return found == search.group.end() ? nullptr : &*found;
}

/// Σ m v of the velocities in a workspace, and the same about the origin at the state's positions.
inline Vec3 momentum(const Scene& scene, const std::vector<Velocity>& velocity) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < velocity.size(); ++k) sum += scene.mass[k] * velocity[k].v;
  return sum;
}

/// At rest in a step of a motion: the last body has gone `each_step` (m) so many times, and all vertices
/// tremble by as much as `tremble` (m).
inline State on_its_way(const Scene& scene, unsigned step, const Vec3& each_step, double tremble) {
  const Body& body = scene.bodies.back();
  Eigen::Matrix3Xd position =
      scene.rest_position.template cast<double>() + noise(scene.vertex_count(), tremble, 77 + step);
  position.middleCols(body.first_vertex, body.vertex_count).colwise() +=
      Eigen::Vector3d(static_cast<double>(step) * each_step.cast<double>());
  return state_at(scene, position, Eigen::Matrix3Xd::Zero(3, scene.vertex_count()));
}

/// Two blocks of unequal cells, the one beside the other and turned about a random axis: by nothing, by
/// little, or by any angle; their vertices are off by as much as `rough` (m).
inline Scene rough_blocks(unsigned seed, double rough = 0.01) {
  SceneDescription description;
  description.bodies = {elastic_body(grid_mesh({2, 1, 1}, 0.1)),
                        elastic_body(grid_mesh({1, 1, 2}, 0.07))};
  const Eigen::Matrix3Xd random = noise(3, 1.0, seed);
  const double angle = seed % 3 == 0 ? 0.0 : (seed % 3 == 1 ? 0.1 : 3.14) * random(0, 0);
  Eigen::Matrix3Xd& other = description.bodies[1].mesh.vertices;
  other = (Eigen::AngleAxisd(angle, random.col(1).normalized()).toRotationMatrix() * other).eval();
  other.colwise() += (Eigen::Vector3d(0.1, 0.05, 0.1) + 0.06 * random.col(2)).eval();
  for (BodyDescription& body : description.bodies) {
    body.mesh.vertices += noise(body.mesh.vertices.cols(), rough, 5000 + seed);
  }
  return build_scene(description);
}

/// All that `depths` says of one of the contacts, to compare.
inline auto numbers_of(const PairContacts& contacts, const PairContact& c) {
  const PairSite& site = contacts.site_of(c);
  const auto& [p, w, n] = std::tie(c.partner, c.weight, c.normal);
  return std::tuple(std::tuple(c.vertex, site.triangle, site.element, p[0], p[1], p[2], p[3]),
                    std::tuple(w[0], w[1], w[2], w[3], c.inverse_mass, site.excess),
                    std::tuple(n.x(), n.y(), n.z(), c.depth));
}

}  // namespace stiction::test
