// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/stiction_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "reference/meshes/ball_mesh.h"
#include "reference/meshes/box_mesh.h"
#include "reference/meshes/mesh_quality.h"
#include "solver/demand.h"

namespace stiction {

namespace {

struct MeshMaker {
  const Discretisation& how;
  TetMesh operator()(const BoxShape& box) const {
    return reference::box_mesh(box.size, reference::box_cells(box.size, how.cells));
  }
  TetMesh operator()(const BallShape& ball) const {
    return reference::ball_mesh({.radius = ball.radius, .frequency = how.ball});
  }
  TetMesh operator()(const MeshShape& shape) const { return shape.mesh; }
  TetMesh operator()(const PointShape&) const {
    TetMesh mesh;
    mesh.vertices = Eigen::Matrix3Xd::Zero(3, 1);
    return mesh;
  }
};

// m³. A mesh that names vertices it doesn't have is refused with the scene; it must not be read
// here, and has no volume.
double volume_of(const TetMesh& mesh) {
  const Eigen::Matrix4Xi& tetrahedra = mesh.tetrahedra;
  if (tetrahedra.size() == 0 || tetrahedra.minCoeff() < 0 ||
      tetrahedra.maxCoeff() >= mesh.vertices.cols()) {
    return 0.0;
  }
  double volume = 0.0;
  for (Eigen::Index e = 0; e < tetrahedra.cols(); ++e) volume += signed_volume(mesh, e);
  return volume;
}

// The vertices (3 × count, m, in the body's own frame) that the body's held part holds.
std::vector<int> held_vertices(const ProblemBody& body, const Eigen::Matrix3Xd& vertices) {
  std::vector<int> held;
  for (Eigen::Index v = 0; v < vertices.cols(); ++v) {
    // A face that was meant to be held stays so when its coordinates are rounded.
    const double above = body.held->normal.normalized().dot(vertices.col(v) - body.held->point);
    if (above <= 1e-12) held.push_back(static_cast<int>(v));
  }
  if (held.empty()) {
    throw InputError(fmt::format("body '{}': its held part holds no vertex", body.name));
  }
  return held;
}

BodyDescription describe(const ProblemBody& body, const Discretisation& how) {
  if (!(body.mass > 0.0) || !std::isfinite(body.mass)) {
    throw InputError(fmt::format("body '{}': mass must be positive and finite, not {} kg",
                                 body.name, body.mass));
  }
  BodyDescription description;
  description.name = body.name;
  description.mesh = std::visit(MeshMaker{how}, body.shape);
  const double volume = volume_of(description.mesh);
  if (volume > 0.0) {
    description.material = {.density = body.mass / volume,
                            .youngs_modulus = body.elasticity.youngs_modulus,
                            .poisson_ratio = body.elasticity.poisson_ratio,
                            .damping_time = body.elasticity.damping_time};
  } else {
    description.point_mass = body.mass;
  }
  Eigen::Matrix3Xd& vertices = description.mesh.vertices;
  if (body.held) description.pinned = held_vertices(body, vertices);
  description.motion = body.motion;
  description.self_collision = body.self_collision;
  description.axes = body.rotation.toRotationMatrix();
  vertices = (body.rotation.toRotationMatrix() * vertices).colwise() + body.position;
  description.initial_velocity = body.velocity.replicate(1, vertices.cols());
  if (!body.angular_velocity.isZero(0.0)) {
    for (Eigen::Index v = 0; v < vertices.cols(); ++v) {
      description.initial_velocity.col(v) +=
          body.angular_velocity.cross(vertices.col(v) - body.position);
    }
  }
  return description;
}

// Told apart by their counts and shortest altitude.
bool same_mesh(const Mesh& a, const Mesh& b) {
  return a.vertices == b.vertices && a.tetrahedra == b.tetrahedra &&
         std::abs(a.min_altitude / b.min_altitude - 1.0) < 1e-9;
}

}  // namespace

SceneDescription scene_description(const Problem& problem, const Discretisation& how) {
  SceneDescription description;
  for (const ProblemBody& body : problem.bodies) description.bodies.push_back(describe(body, how));
  for (const Obstacle& obstacle : problem.obstacles) {
    description.half_spaces.push_back({obstacle.name, obstacle.point.cast<Real>(),
                                       obstacle.normal.cast<Real>(),
                                       static_cast<Real>(obstacle.friction), obstacle.motion});
  }
  description.friction = static_cast<Real>(problem.friction);
  description.gravity = problem.gravity;
  description.drag = problem.drag;
  description.loads = problem.loads;
  description.springs = problem.springs;
  description.pair_friction = problem.pair_friction;
  return description;
}

Eigen::Vector3d own_origin(const Problem& problem) {
  constexpr double kFar = 8.0;  // three bits of a coordinate
  if (problem.bodies.empty()) return Eigen::Vector3d::Zero();
  const Eigen::AlignedBox3d bounds = bounds_of(problem);
  const Eigen::Vector3d middle = bounds.center();
  const double width = std::max(bounds.diagonal().norm(), 1.0);  // a point has none
  // What is not finite is refused where it is checked.
  return middle.allFinite() && middle.norm() > kFar * width
             ? middle
             : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

Problem seen_from(const Eigen::Vector3d& origin, Problem problem) {
  for (ProblemBody& body : problem.bodies) body.position -= origin;
  for (Obstacle& obstacle : problem.obstacles) obstacle.point -= origin;
  for (Spring& spring : problem.springs) spring.anchor -= origin;
  return problem;
}

std::vector<Mesh> distinct_meshes(const SceneDescription& scene) {
  std::vector<Mesh> meshes;
  std::vector<int> sharing;  // how many more bodies have each
  for (const BodyDescription& body : scene.bodies) {
    if (body.mesh.tetrahedra.cols() == 0) continue;
    const reference::MeshQuality quality = reference::mesh_quality(body.mesh);
    const Mesh mesh{body.name,
                    static_cast<std::uint64_t>(body.mesh.vertices.cols()),
                    static_cast<std::uint64_t>(body.mesh.tetrahedra.cols()),
                    quality.min_dihedral_angle,
                    quality.max_dihedral_angle,
                    quality.min_altitude};
    std::size_t k = 0;
    while (k < meshes.size() && !same_mesh(meshes[k], mesh)) ++k;
    if (k < meshes.size()) {
      ++sharing[k];
      continue;
    }
    meshes.push_back(mesh);
    sharing.push_back(0);
  }
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    if (sharing[k] > 0) meshes[k].bodies += fmt::format(" and {} more", sharing[k]);
  }
  return meshes;
}

}  // namespace stiction
