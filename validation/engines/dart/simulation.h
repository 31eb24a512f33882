// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <dart/collision/Contact.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/simulation/World.hpp>
#include <unordered_map>
#include <vector>

#include "validation/engine/kit/stiction_engine.h"

namespace stiction_dart {

/// One problem in DART: a skeleton with a free joint for each body, one that cannot move for each
/// obstacle: a great box, because DART's own collision detector knows no half-spaces.
class Simulation {
 public:
  /// Reads settings; throws, or ends the call by stiction_lacks.
  explicit Simulation(const stiction_problem& problem);

  double time_step() const { return world_->getTimeStep(); }  ///< s
  double time() const { return world_->getTime(); }           ///< s
  void advance(std::uint64_t steps);
  void body(std::size_t index, stiction_body_state& state) const;
  /// Those of the last step: found at its start, with the forces over it and the slip at its end.
  std::size_t contacts(stiction_contact* contacts, std::size_t room) const;

 private:
  void add_obstacle(const stiction_obstacle& obstacle, double width);
  void add_body(const stiction_body& body, double friction_with_obstacles, bool two_shapes);
  void apply_loads();
  stiction_contact told(const dart::collision::Contact& contact) const;
  std::size_t thing(const dart::collision::CollisionObject* object) const;

  const stiction_problem& problem_;
  dart::simulation::WorldPtr world_;
  std::vector<dart::dynamics::BodyNode*> bodies_;
  /// Obstacle o is o, body b is obstacle_count + b.
  std::unordered_map<const dart::dynamics::BodyNode*, std::size_t> things_;
};

}  // namespace stiction_dart
