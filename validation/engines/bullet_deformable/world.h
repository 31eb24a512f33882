// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "validation/engines/bullet_deformable/field_force.h"
#include "validation/engines/bullet_deformable/soft_mesh.h"

namespace stiction::bullet_deformable {

using Eigen::Vector3d;

/// One problem in Bullet's deformable world.
class World {
 public:
  explicit World(const stiction_problem& problem);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  double time_step() const { return parameters_.time_step; }
  double time() const { return static_cast<double>(steps_) * parameters_.time_step; }
  void advance(std::uint64_t steps);
  void body(size_t index, stiction_body_state& state) const;
  void momenta(Vector3d& linear, Vector3d& angular) const;
  const SoftMesh& mesh(size_t body) const { return meshes_[body]; }
  Vector3d node(size_t body, size_t index) const;

 private:
  void add_body(const stiction_body& body);
  void add_elasticity(const stiction_body& body);
  void add_force(btDeformableLagrangianForce& force);
  void add_obstacle(const stiction_obstacle& obstacle);
  void apply_loads(double t);
  void move_obstacles(double t);
  Vector3d velocity(size_t body, size_t index) const;

  const stiction_problem& problem_;
  Parameters parameters_;
  std::uint64_t steps_ = 0;
  std::vector<SoftMesh> meshes_{};
  std::vector<btVector3> obstacle_origins_{};  ///< of Bullet's bodies at rest
  // Bullet's: what a later one points to is destroyed after it.
  std::vector<std::unique_ptr<btCollisionShape>> shapes_{};
  std::vector<std::unique_ptr<btRigidBody>> obstacles_{};
  std::vector<std::unique_ptr<FieldForce>> fields_{};
  std::vector<std::unique_ptr<btDeformableLagrangianForce>> elasticity_{};
  std::unique_ptr<btCollisionConfiguration> configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  std::unique_ptr<btBroadphaseInterface> broadphase_;
  std::unique_ptr<btDeformableBodySolver> body_solver_;
  std::unique_ptr<btDeformableMultiBodyConstraintSolver> solver_;
  std::vector<std::unique_ptr<btSoftBody>> bodies_{};
  std::unique_ptr<btDeformableMultiBodyDynamicsWorld> world_;
};

}  // namespace stiction::bullet_deformable
