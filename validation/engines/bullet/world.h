// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletDynamics/MLCPSolvers/btMLCPSolverInterface.h>
#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "validation/engines/bullet/parameters.h"

namespace stiction::bullet {

/// One problem in Bullet. Bodies are the problem's; those of half-spaces come after them in
/// `obstacles`. The user index of a Bullet body is its body's, or −1 − that of its obstacle.
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
  /// Those of the last step, with the impulses of its end over Δt.
  std::vector<stiction_contact> contacts() const;

 private:
  void add_body(const stiction_body& body);
  void add_obstacle(const stiction_obstacle& obstacle);
  btRigidBody& add(std::unique_ptr<btCollisionShape> shape, btScalar mass, const btVector3& inertia,
                   const btTransform& pose);
  void set_solver();
  void apply_loads(double t);
  void move_obstacles(double t);

  const stiction_problem& problem_;
  Parameters parameters_;
  std::uint64_t steps_ = 0;
  std::vector<btQuaternion> principal_axes_{};  ///< of each body, in its own frame
  std::vector<btVector3> obstacle_origins_{};   ///< of Bullet's bodies at rest
  // Bullet's: what a later one points to is destroyed after it.
  std::vector<std::unique_ptr<btCollisionShape>> shapes_{};
  std::vector<std::unique_ptr<btRigidBody>> bodies_{}, obstacles_{};
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  std::unique_ptr<btBroadphaseInterface> broadphase_;
  std::unique_ptr<btMLCPSolverInterface> complementarity_{};
  std::unique_ptr<btConstraintSolver> solver_{};
  std::unique_ptr<btDiscreteDynamicsWorld> world_{};
};

}  // namespace stiction::bullet
