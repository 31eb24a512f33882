// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "validation/engines/ode/parameters.h"

namespace stiction::ode {

using Eigen::Map, Eigen::Vector3d;

/// A contact of the present step and what ODE found it to carry. `body` is ODE's first.
struct Contact {
  size_t body;
  size_t other;  ///< body or obstacle
  bool against_body;
  dContact joint;  ///< its normal points towards `body`
  dJointFeedback feedback;
};

/// One problem in ODE, which is double precision.
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
  /// Those of the last step; places and slips are of its end.
  std::vector<stiction_contact> contacts() const;

  /// All that the future depends on.
  struct State {
    std::uint64_t steps;
    unsigned long seed;           ///< of the order in which the quick step takes constraints
    std::vector<double> numbers;  ///< of each body: pose and velocities
  };
  State save() const;
  void restore(const State& state);

 private:
  void add_body(const stiction_body& body);
  void add_obstacle(const stiction_obstacle& obstacle);
  void apply_loads(double t);
  void move_obstacles(double t);
  void find_contacts();
  void add_contacts(size_t body, dGeomID with);
  void set_surface(Contact& contact) const;
  Vector3d velocity_at(size_t body, const Vector3d& point, bool predicted) const;
  void attach_contacts();

  const stiction_problem& problem_;
  Parameters parameters_;
  std::uint64_t steps_ = 0;
  Vector3d gravity_ = Vector3d::Zero();
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID joints_;
  std::vector<dBodyID> bodies_{};
  std::vector<dGeomID> geoms_{};                    ///< of bodies, then of obstacles
  std::vector<Vector3d> obstacle_velocity_{};       ///< in the coming step, m/s
  std::vector<std::pair<size_t, size_t>> pairs_{};  ///< of geoms that may touch
  std::vector<Contact> contacts_{};
};

}  // namespace stiction::ode
