// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/contact_samples.h"

#include <algorithm>

#include "solver/contact/slip.h"

namespace stiction {

std::size_t body_of(const Scene& scene, std::int32_t vertex) {
  const auto after =
      std::upper_bound(scene.bodies.begin(), scene.bodies.end(), vertex,
                       [](int v, const Body& body) { return v < body.first_vertex; });
  return static_cast<std::size_t>(after - scene.bodies.begin()) - 1;
}

namespace {

ContactSample sample_of(const Scene& scene, const State& state, double time_step,
                        const PairContact& contact, const PairSite& site, ContactStatus status) {
  const auto i = static_cast<std::size_t>(contact.vertex);
  // In double, so that what is told does not add to the solver's round-off.
  const auto before = [&](std::size_t v) -> Eigen::Vector3d {
    return state.position[v].x.cast<double>() - time_step * state.velocity[v].v.cast<double>();
  };
  Eigen::Vector3d arm = before(i);
  for (int k = 0; k < 4; ++k) {
    const auto j = static_cast<std::size_t>(contact.partner[k]);
    arm -= contact.weight[k] * before(j);
  }
  return {.body = body_of(scene, contact.vertex),
          .obstacle = static_cast<std::size_t>(
              scene.topology.element_body[static_cast<std::size_t>(site.element)]),
          .against_body = true,
          .point = contact.vertex,
          .facet = site.triangle,
          .normal = contact.normal.cast<double>(),
          .gap = -(contact.depth + site.excess),
          .normal_force = contact.normal_force,
          .friction_force = contact.friction_force.cast<double>(),
          .slip = slip_of(contact, state.velocity).cast<double>(),
          .sticks = status == ContactStatus::kStick,
          .position = state.position[i].x.cast<double>(),
          .arm = arm};
}

ContactSample sample_of(const Scene& scene, const State& state, double time_step,
                        const EdgeContact& contact, ContactStatus status) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(), arm = Eigen::Vector3d::Zero();
  const auto add = [&](double weight, std::int32_t vertex) {
    const auto v = static_cast<std::size_t>(vertex);
    arm += weight *
           (state.position[v].x.cast<double>() - time_step * state.velocity[v].v.cast<double>());
  };
  for (int k = 0; k < 2; ++k) {
    position += contact.own_weight[k] *
                state.position[static_cast<std::size_t>(contact.vertex[k])].x.cast<double>();
    add(contact.own_weight[k], contact.vertex[k]);
  }
  for (int k = 0; k < 4; ++k) add(-contact.weight[k], contact.partner[k]);
  // Edges are numbered behind the vertices.
  const auto edge_a = static_cast<std::int64_t>(first_of(contact.key));
  const auto edge_b = static_cast<std::int64_t>(second_of(contact.key));
  return {.body = body_of(scene, contact.vertex[0]),
          .obstacle = static_cast<std::size_t>(
              scene.topology.element_body[static_cast<std::size_t>(contact.element)]),
          .against_body = true,
          .point = scene.vertex_count() + edge_a,
          .facet = static_cast<std::int64_t>(scene.topology.triangle.size()) + edge_b,
          .normal = contact.normal.cast<double>(),
          .gap = -contact.depth,
          .normal_force = contact.normal_force,
          .friction_force = contact.friction_force.cast<double>(),
          .slip = slip_of(contact, state.velocity).cast<double>(),
          .sticks = status == ContactStatus::kStick,
          .position = position,
          .arm = arm};
}

}  // namespace

std::vector<ContactSample> contact_samples(const Scene& scene, const State& state,
                                           const Workspace& workspace, double time_step) {
  std::vector<ContactSample> samples;
  const OneSidedContacts& contacts = workspace.contacts;
  const double time = static_cast<double>(state.step) * time_step;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto v = static_cast<std::size_t>(contacts.vertex[c]);
    const auto o = static_cast<std::size_t>(contacts.obstacle[c]);
    const HalfSpace& obstacle = scene.half_spaces[o];
    const Vec3 velocity = state.velocity[v].v - contacts.obstacle_velocity[c];
    samples.push_back({.body = body_of(scene, contacts.vertex[c]),
                       .obstacle = o,
                       .against_body = false,
                       .point = contacts.vertex[c],
                       .normal = obstacle.normal.cast<double>(),
                       .gap = obstacle.normal.cast<double>().dot(
                           state.position[v].x.cast<double>() - obstacle.point.cast<double>() -
                           obstacle.motion.at(time)),
                       .normal_force = contacts.normal_force[c],
                       .friction_force = contacts.friction_force[c].cast<double>(),
                       .slip = tangential(velocity, obstacle.normal).cast<double>(),
                       .sticks = state.obstacle_friction.status[c] == ContactStatus::kStick,
                       .position = state.position[v].x.cast<double>()});
  }
  for (std::size_t c = 0; c < workspace.pairs.size(); ++c) {
    samples.push_back(sample_of(scene, state, time_step, workspace.pairs[c],
                                workspace.pairs.site(c), state.pair_friction.status[c]));
  }
  for (std::size_t c = 0; c < workspace.edges.size(); ++c) {
    samples.push_back(
        sample_of(scene, state, time_step, workspace.edges[c], state.edge_friction.status[c]));
  }
  return samples;
}

}  // namespace stiction
