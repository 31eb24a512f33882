// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/consistent_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "reference/exact/exact_consistent_depth.h"
#include "reference/exact/exact_detection.h"
#include "solver/depth/consistent_depth.h"
#include "solver/depth/depth.h"
#include "solver/detection/detect_pairs.h"
#include "validation/engines/stiction/detection_comparison.h"
#include "validation/engines/stiction/stiction_method.h"

namespace stiction {

namespace {

using reference::ConsistentDepth;

struct Answer {
  int level;
  double depth;
  Vec3 normal;
};

// By body and vertex, as described.
using Answers = std::map<std::pair<int, Eigen::Index>, Answer>;

Answers ask_solver(const TetMesh& a, const TetMesh& b, Settings settings) {
  SceneDescription description;
  description.bodies.resize(2);
  description.bodies[0].mesh = a;
  description.bodies[1].mesh = b;
  const Scene scene = build_scene(description);
  const State state = initial_state(scene);
  Workspace workspace;
  workspace.velocity = state.velocity;
  settings["depth"] = "consistent";
  Options options;
  SettingsReader reader(settings);
  read_method(reader, options);
  options.pairs.hysteresis = 0.0;
  detect_pairs(scene, options, state, workspace);
  depths(scene, options, state, workspace);
  std::map<std::int32_t, std::pair<int, Eigen::Index>> described;
  for (std::size_t k = 0; k < scene.scene_vertex.size(); ++k) {
    const auto v = static_cast<Eigen::Index>(k);
    const Eigen::Index first = a.vertices.cols();
    described[scene.scene_vertex[k]] = v < first ? std::pair(0, v) : std::pair(1, v - first);
  }
  Answers answers;
  for (std::size_t c = 0; c < workspace.pairs.size(); ++c) {
    const PairContact& contact = workspace.pairs[c];
    answers[described.at(contact.vertex)] = {workspace.consistent.level[c], contact.depth,
                                             contact.normal};
  }
  return answers;
}

double extent(const TetMesh& mesh) {
  return (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff()).maxCoeff();
}

double longest_edge(const TetMesh& mesh) {
  double longest = 0.0;
  for (const auto& corners : mesh.tetrahedra.colwise()) {
    for (const int v : corners) {
      for (const int w : corners) {
        longest = std::max(longest, (mesh.vertices.col(v) - mesh.vertices.col(w)).norm());
      }
    }
  }
  return longest;
}

void compare(const ConsistentDepth& expected, const Answer& answer, double rounding, double size,
             bool moved, ConsistentComparison& seen) {
  const bool reached = answer.level > 0;
  seen.other_level += moved ? reached != (expected.level > 0) : answer.level != expected.level;
  if (!reached || expected.level == 0) return;
  const double depth_error = std::abs(answer.depth - expected.depth);
  const double direction_error = (answer.normal - expected.normal).norm();
  const double height = rounding * size;
  seen.depth_error = std::max(seen.depth_error, depth_error);
  seen.direction_error = std::max(seen.direction_error, direction_error);
  seen.depth_excess = std::max(seen.depth_excess, depth_error / (expected.moved * height));
  seen.direction_excess =
      std::max(seen.direction_excess,
               direction_error / (expected.turned * height + rounding / expected.agreement));
}

}  // namespace

void ConsistentComparison::add(const ConsistentComparison& other) {
  vertices += other.vertices;
  border += other.border;
  inner += other.inner;
  deepest = std::max(deepest, other.deepest);
  lost += other.lost;
  other_level += other.other_level;
  depth_error = std::max(depth_error, other.depth_error);
  direction_error = std::max(direction_error, other.direction_error);
  depth_excess = std::max(depth_excess, other.depth_excess);
  direction_excess = std::max(direction_excess, other.direction_excess);
}

ConsistentComparison compare_consistent(const TetMesh& exact_a, const TetMesh& exact_b,
                                        const TetMesh& asked_a, const TetMesh& asked_b,
                                        const Settings& settings) {
  const Answers answers = ask_solver(asked_a, asked_b, settings);
  const double size = std::max(extent(exact_a), extent(exact_b));
  const bool moved = &asked_a != &exact_a;
  ConsistentComparison seen;
  std::size_t used = 0;
  for (const int body : {0, 1}) {
    const TetMesh& own = body == 0 ? exact_a : exact_b;
    const TetMesh& other = body == 0 ? exact_b : exact_a;
    const reference::ExactBody penetrated(other);
    for (const ConsistentDepth& expected :
         reference::exact_consistent_depths(own, other, kConsistentThin * longest_edge(other))) {
      ++seen.vertices;
      seen.border += expected.level == 1;
      seen.inner += expected.level > 1;
      seen.deepest = std::max(seen.deepest, expected.level);
      const auto answer = answers.find({body, expected.vertex});
      if (answer == answers.end()) {
        const Vec3 x = own.vertices.col(expected.vertex);
        seen.lost += !(moved && penetrated.side(x) == reference::Side::boundary);
        continue;
      }
      ++used;
      compare(expected, answer->second, kDetectionRounding, size, moved, seen);
    }
  }
  seen.lost += static_cast<int>(answers.size() - used);
  return seen;
}

}  // namespace stiction
