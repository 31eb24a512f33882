// SPDX-License-Identifier: BSD-3-Clause
#include "solver/contact/contacts.h"

namespace stiction {

void OneSidedContacts::clear() {
  key.clear();
  vertex.clear();
  obstacle.clear();
  depth.clear();
  obstacle_velocity.clear();
  normal_force.clear();
  friction_force.clear();
}

void OneSidedContacts::add(ContactKey contact, std::int32_t vertex_number,
                           std::int32_t obstacle_number, Real penetration_depth,
                           const Vec3& velocity_of_obstacle) {
  key.push_back(contact);
  vertex.push_back(vertex_number);
  obstacle.push_back(obstacle_number);
  depth.push_back(penetration_depth);
  obstacle_velocity.push_back(velocity_of_obstacle);
  normal_force.push_back(0.0);
  friction_force.emplace_back(Vec3::Zero());
}

}  // namespace stiction
