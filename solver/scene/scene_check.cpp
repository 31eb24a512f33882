// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/scene_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "solver/demand.h"

namespace stiction {

namespace {

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream sentence;
  sentence.precision(9);
  (sentence << ... << parts);
  throw InputError(sentence.str());
}

void check_material(const std::string& who, const Material& material) {
  const double nu = material.poisson_ratio;
  if (!(material.density > 0.0) || !std::isfinite(material.density)) {
    refuse(who, ": density must be positive and finite, not ", material.density, " kg/m³");
  }
  if (!(material.youngs_modulus > 0.0) || !std::isfinite(material.youngs_modulus)) {
    refuse(who, ": Young's modulus must be positive and finite, not ", material.youngs_modulus,
           " Pa");
  }
  if (!(nu > -1.0 && nu < 0.5)) {
    refuse(who, ": Poisson's ratio must lie between -1 and 0.5, not ", nu);
  }
  if (!(material.damping_time >= 0.0) || !std::isfinite(material.damping_time)) {
    refuse(who, ": damping time must be non-negative and finite, not ", material.damping_time,
           " s");
  }
}

void check_tetrahedra(const std::string& who, const TetMesh& mesh) {
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    for (int k = 0; k < 4; ++k) {
      const int v = mesh.tetrahedra(k, e);
      if (v < 0 || v >= mesh.vertices.cols()) {
        refuse(who, ": tetrahedron ", e, " refers to vertex ", v, ", but there are only ",
               mesh.vertices.cols(), " vertices");
      }
    }
    const double volume = signed_volume(mesh, e);
    double longest = 0.0;
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < a; ++b) {
        longest = std::max(longest, (mesh.vertices.col(mesh.tetrahedra(a, e)) -
                                     mesh.vertices.col(mesh.tetrahedra(b, e)))
                                        .norm());
      }
    }
    // Below 1e-12 of its longest edge cubed the sign of a volume is round-off.
    const double smallest = 1e-12 * longest * longest * longest;
    if (volume < -smallest) {
      refuse(who, ": tetrahedron ", e, " is inverted (volume ", volume, " m³)");
    }
    if (!(volume > smallest)) {
      refuse(who, ": tetrahedron ", e, " is flat (volume ", volume, " m³, longest edge ", longest,
             " m)");
    }
  }
}

// Given twice it would be as heavy and stiff as two, and none of its faces would belong to the surface.
void check_that_none_is_given_twice(const std::string& who, const TetMesh& mesh) {
  std::vector<std::pair<std::array<int, 4>, Eigen::Index>> all;
  all.reserve(static_cast<std::size_t>(mesh.tetrahedra.cols()));
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    std::array<int, 4> corner;
    std::copy_n(mesh.tetrahedra.col(e).data(), 4, corner.begin());
    std::sort(corner.begin(), corner.end());
    all.emplace_back(corner, e);
  }
  std::sort(all.begin(), all.end());
  const auto same = std::adjacent_find(
      all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  if (same == all.end()) return;
  refuse(who, ": tetrahedra ", same->second, " and ", std::next(same)->second,
         " have the same corners");
}

void check_keyframes(const std::string& who, const char* values, const std::vector<double>& time,
                     const std::vector<Eigen::Vector3d>& value) {
  if (time.size() != value.size()) {
    refuse(who, ": ", time.size(), " times for ", value.size(), " ", values);
  }
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (!std::isfinite(time[k]) || !value[k].allFinite()) {
      refuse(who, ": keyframe ", k, " is not a finite number");
    }
    if (k > 0 && !(time[k] > time[k - 1])) {
      refuse(who, ": keyframe ", k, " at ", time[k], " s does not follow ", time[k - 1], " s");
    }
  }
}

void check_oscillation(const std::string& who, const Oscillation& one) {
  const double numbers = one.frequency + one.phase + one.begins + one.full_from;
  if (!one.amplitude.allFinite() || !std::isfinite(numbers)) {
    refuse(who, ": a number of its oscillation is not finite");
  }
  if (one.frequency < 0.0) {
    refuse(who, ": the frequency must not be negative, not ", one.frequency, " Hz");
  }
  if (one.full_from < one.begins) {
    refuse(who, ": an oscillation that begins at ", one.begins, " s cannot be full from ",
           one.full_from, " s on");
  }
}

void check_motion(const std::string& who, const Motion& motion) {
  check_keyframes(who + ", its motion", "offsets", motion.time, motion.offset);
  check_oscillation(who + ", its motion", motion.oscillation);
  if (!motion.velocity.allFinite()) refuse(who, ", its motion: the velocity is not finite");
}

void check_body(const BodyDescription& body) {
  const std::string who = "body '" + body.name + "'";
  const TetMesh& mesh = body.mesh;
  if (mesh.vertices.cols() == 0) refuse(who, ": has no vertices");
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    if (!mesh.vertices.col(v).allFinite()) {
      refuse(who, ": vertex ", v, " has a coordinate that is not a finite number");
    }
  }
  if (body.initial_velocity.cols() != 0 && body.initial_velocity.cols() != mesh.vertices.cols()) {
    refuse(who, ": ", body.initial_velocity.cols(), " initial velocities for ",
           mesh.vertices.cols(), " vertices");
  }
  if (!body.initial_velocity.allFinite()) {
    refuse(who, ": an initial velocity is not a finite number");
  }
  check_motion(who, body.motion);
  if (mesh.tetrahedra.cols() > 0) check_material(who, body.material);
  check_tetrahedra(who, mesh);
  check_that_none_is_given_twice(who, mesh);
  std::vector<bool> carried(static_cast<std::size_t>(mesh.vertices.cols()), false);
  for (const int v : mesh.tetrahedra.reshaped()) carried[static_cast<std::size_t>(v)] = true;
  for (std::size_t v = 0; v < carried.size(); ++v) {
    if (!carried[v] && !(body.point_mass > 0.0 && std::isfinite(body.point_mass))) {
      refuse(who, ": vertex ", v,
             " belongs to no tetrahedron and needs a positive point mass, not ", body.point_mass,
             " kg");
    }
  }
  for (const int v : body.pinned) {
    if (v < 0 || v >= mesh.vertices.cols()) {
      refuse(who, ": pinned vertex ", v, " does not exist, there are ", mesh.vertices.cols(),
             " vertices");
    }
  }
}

void check_obstacle(const HalfSpace& obstacle) {
  const std::string who = "obstacle '" + obstacle.name + "'";
  if (!obstacle.point.allFinite()) refuse(who, ": its point is not a finite number");
  check_motion(who, obstacle.motion);
  // A normal whose length is off by more than round-off would scale every depth.
  if (!(std::abs(obstacle.normal.norm() - 1) < by_precision(1e-12, 1e-6))) {
    refuse(who, ": its normal must have length 1, not ", obstacle.normal.norm());
  }
  if (!(obstacle.friction >= 0.0) || !std::isfinite(obstacle.friction)) {
    refuse(who, ": the friction coefficient must be non-negative and finite, not ",
           obstacle.friction);
  }
}

void check_loads(const SceneDescription& description) {
  const auto check_body_of = [&](const char* who, std::size_t body) {
    if (body < description.bodies.size()) return;
    refuse(who, " acts on body ", body, ", but there are only ", description.bodies.size());
  };
  for (const Load& load : description.loads) {
    check_body_of("a load", load.body);
    check_keyframes("a load", "forces", load.force.time, load.force.value);
    check_keyframes("a load", "couples", load.couple.time, load.couple.value);
    check_oscillation("a load, its force", load.force.oscillation);
    check_oscillation("a load, its couple", load.couple.oscillation);
  }
  for (const Spring& spring : description.springs) {
    check_body_of("a spring", spring.body);
    if (!(spring.stiffness >= 0.0) || !std::isfinite(spring.stiffness)) {
      refuse("the stiffness of a spring must be non-negative and finite, not ", spring.stiffness,
             " N/m");
    }
    if (!spring.anchor.allFinite() || !spring.anchor_velocity.allFinite() ||
        !(std::abs(spring.axis.norm() - 1.0) < 1e-9)) {
      refuse("a spring needs an anchor of finite numbers and an axis of unit length");
    }
  }
}

void check_pair_friction(const SceneDescription& description) {
  std::set<std::array<std::size_t, 3>> seen;
  for (const PairFriction& pair : description.pair_friction) {
    const std::size_t others =
        pair.against_body ? description.bodies.size() : description.half_spaces.size();
    if (pair.body >= description.bodies.size() || pair.other >= others) {
      refuse("a pair with a friction coefficient of its own names what is not there");
    }
    if (!(pair.friction >= 0.0) || !std::isfinite(pair.friction)) {
      refuse("the friction coefficient of a pair must be non-negative and finite, not ",
             pair.friction);
    }
    const bool swapped = pair.against_body && pair.other < pair.body;
    const std::size_t first = swapped ? pair.other : pair.body;
    const std::size_t second = swapped ? pair.body : pair.other;
    if (!seen.insert({first, second, pair.against_body ? 1u : 0u}).second) {
      refuse("two friction coefficients are given for one pair");
    }
  }
}

}  // namespace

void check_description(const SceneDescription& description) {
  if (description.bodies.empty()) refuse("the scene has no bodies");
  for (const BodyDescription& body : description.bodies) check_body(body);
  for (const HalfSpace& obstacle : description.half_spaces) check_obstacle(obstacle);
  if (!(description.friction >= 0.0) || !std::isfinite(description.friction)) {
    refuse("the friction coefficient between bodies must be non-negative and finite, not ",
           description.friction);
  }
  check_keyframes("gravity", "accelerations", description.gravity.time,
                  description.gravity.acceleration);
  check_oscillation("gravity", description.gravity.oscillation);
  const Drag& drag = description.drag;
  if (!(drag.rate >= 0.0) || !std::isfinite(drag.rate)) {
    refuse("the drag must be non-negative and finite, not ", drag.rate, " 1/s");
  }
  if (drag.rate > 0.0 && !(drag.full_until < drag.ends && std::isfinite(drag.ends))) {
    refuse("the drag must fade out after ", drag.full_until, " s, not at ", drag.ends, " s");
  }
  check_loads(description);
  check_pair_friction(description);
}

void check_start(const Scene& scene, double rounding) {
  if (scene.vertex_count() == 0) return;
  const Real size = scene.rest_position.cwiseAbs().maxCoeff();
  // Round-off of a placed mesh: a depth d starts a vertex at d/Δt, so 1e-13 of a metre-sized scene
  // is below 1e-9 m/s at the usual steps; anything deeper was meant. In single precision
  // round-off itself is a thousand times what the usual steps forgive.
  const Real allowed = by_precision(1e-13, 1e-6) * std::max(size, Real(1)) + rounding;
  for (const Body& body : scene.bodies) {
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
      if (scene.inverse_mass[static_cast<std::size_t>(v)] == 0.0) continue;
      for (const HalfSpace& obstacle : scene.half_spaces) {
        const Real gap = obstacle.normal.dot(scene.rest_position.col(v) - obstacle.point);
        if (gap < -allowed) {
          refuse("body '", body.name, "': starts ", -gap, " m inside obstacle '", obstacle.name,
                 "'");
        }
      }
    }
  }
}

}  // namespace stiction
