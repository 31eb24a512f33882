// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/dart/simulation.h"

#include <algorithm>
#include <dart/collision/CollisionObject.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <memory>
#include <string>

#include "validation/engines/dart/native.h"

namespace stiction_dart {

namespace {

using dart::dynamics::BodyNode, dart::dynamics::FreeJoint, dart::dynamics::Skeleton;
using Eigen::Map, Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d;
using ConstVector = Map<const Vector3d>;

// Of w, x, y, z.
Quaterniond rotation_of(const double* q) { return {q[0], q[1], q[2], q[3]}; }

dart::dynamics::ShapePtr shape_of(const stiction_body& body) {
  if (body.shape == STICTION_BALL)
    return std::make_shared<dart::dynamics::SphereShape>(body.radius);
  if (body.shape == STICTION_BOX) {
    return std::make_shared<dart::dynamics::BoxShape>(Vector3d(body.size));
  }
  stiction_lacks(body.shape == STICTION_MESH ? "bodies given as meshes" : "points");
}

void add_shape(BodyNode* node, const dart::dynamics::ShapePtr& shape, double friction,
               const std::string& name) {
  auto* const added =
      node->createShapeNodeWith<dart::dynamics::CollisionAspect, dart::dynamics::DynamicsAspect>(
          shape, name);
  added->getDynamicsAspect()->setFrictionCoeff(friction);
  added->getDynamicsAspect()->setRestitutionCoeff(0.0);
}

}  // namespace

Simulation::Simulation(const stiction_problem& problem)
    : problem_(problem), world_(make_world(problem)) {
  const double width = stiction_number("obstacle_width", 1000.0);
  double most = 0.0;  // μ with an obstacle
  for (std::size_t o = 0; o < problem.obstacle_count; ++o) {
    most = std::max(most, problem.obstacles[o].friction);
    add_obstacle(problem.obstacles[o], width);
  }
  const bool two_shapes = problem.body_count > 1 && problem.friction < most;
  if (two_shapes) {
    world_->getConstraintSolver()->getCollisionOption().collisionFilter =
        std::make_shared<TwoShapes>();
  }
  stiction_tell("shapes_per_body", two_shapes ? "2" : "1");
  for (std::size_t b = 0; b < problem.body_count; ++b) {
    add_body(problem.bodies[b], problem.body_count > 1 ? std::max(most, problem.friction) : most,
             two_shapes);
  }
}

void Simulation::add_obstacle(const stiction_obstacle& obstacle, double width) {
  if (stiction_moves(&obstacle.motion)) stiction_lacks("moving obstacles");
  constexpr double kDepth = 10.0;  // m
  const auto skeleton = Skeleton::create("obstacle " + std::to_string(things_.size()));
  const auto made = skeleton->createJointAndBodyNodePair<dart::dynamics::WeldJoint>();
  add_shape(made.second, std::make_shared<dart::dynamics::BoxShape>(Vector3d(width, width, kDepth)),
            obstacle.friction, "obstacle");
  const Vector3d normal(obstacle.normal);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Quaterniond::FromTwoVectors(Vector3d::UnitZ(), normal).toRotationMatrix();
  pose.translation() = Vector3d(obstacle.point) - 0.5 * kDepth * normal;
  made.first->setTransformFromParentBodyNode(pose);
  skeleton->setMobile(false);
  things_[made.second] = things_.size();
  world_->addSkeleton(skeleton);
}

void Simulation::add_body(const stiction_body& body, double friction_with_obstacles,
                          bool two_shapes) {
  if (body.held) stiction_lacks("held parts of bodies");
  const dart::dynamics::ShapePtr shape = shape_of(body);
  const auto skeleton = Skeleton::create("body " + std::to_string(bodies_.size()));
  const auto [joint, node] = skeleton->createJointAndBodyNodePair<FreeJoint>();
  Matrix3d inertia;
  for (int r = 0; r < 3; ++r) inertia.row(r) = ConstVector(body.inertia[r]).transpose();
  node->setInertia(dart::dynamics::Inertia(body.mass, Vector3d::Zero(), inertia));
  if (two_shapes) {
    add_shape(node, shape, friction_with_obstacles, "on obstacles");
    add_shape(node, shape, problem_.friction, "on bodies");
  } else {
    add_shape(node, shape, problem_.body_count > 1 ? problem_.friction : friction_with_obstacles,
              "body");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation_of(body.rotation).toRotationMatrix();
  pose.translation() = Vector3d(body.position);
  joint->setTransform(pose);
  joint->setAngularVelocity(Vector3d(body.angular_velocity));
  joint->setLinearVelocity(Vector3d(body.velocity));
  things_[node] = things_.size();
  bodies_.push_back(node);
  world_->addSkeleton(skeleton);
}

void Simulation::advance(std::uint64_t steps) {
  for (; steps > 0; --steps) {
    Vector3d gravity;
    stiction_at(&problem_.gravity, world_->getTime(), gravity.data());
    world_->setGravity(gravity);
    apply_loads();
    world_->step();
  }
}

void Simulation::apply_loads() {
  const double t = world_->getTime(), drag = stiction_drag(&problem_, t);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const bool loaded = stiction_has_loads(&problem_, b) != 0;
    if (!loaded && drag <= 0.0) continue;
    Vector3d force = Vector3d::Zero(), couple = Vector3d::Zero();
    if (loaded) {
      stiction_load(&problem_, b, t, bodies_[b]->getCOM().eval().data(), force.data(),
                    couple.data());
    }
    force -= problem_.bodies[b].mass * drag * bodies_[b]->getCOMLinearVelocity();
    bodies_[b]->addExtForce(force);
    bodies_[b]->addExtTorque(couple);
  }
}

void Simulation::body(std::size_t index, stiction_body_state& state) const {
  const BodyNode& node = *bodies_[index];
  const Quaterniond q(node.getWorldTransform().linear());
  Map<Vector3d>(state.position) = node.getWorldTransform().translation();
  Map<Vector3d>(state.velocity) = node.getLinearVelocity();
  Map<Vector3d>(state.angular_velocity) = node.getAngularVelocity();
  Map<Eigen::Vector4d>(state.rotation) << q.w(), q.x(), q.y(), q.z();
}

std::size_t Simulation::contacts(stiction_contact* contacts, std::size_t room) const {
  std::size_t count = 0;
  for (const auto& one : world_->getLastCollisionResult().getContacts()) {
    if (count < room) contacts[count] = told(one);
    ++count;
  }
  return count;
}

std::size_t Simulation::thing(const dart::collision::CollisionObject* object) const {
  return things_.at(object->getShapeFrame()->asShapeNode()->getBodyNodePtr().get());
}

stiction_contact Simulation::told(const dart::collision::Contact& contact) const {
  const std::size_t obstacles = problem_.obstacle_count;
  std::size_t on = thing(contact.collisionObject1), other = thing(contact.collisionObject2);
  // DART's normal points to the first; its force acts on that.
  const double side = on < obstacles ? -1.0 : 1.0;
  if (on < obstacles) std::swap(on, other);
  const Vector3d normal = side * contact.normal, force = side * contact.force;
  const auto velocity = [&](std::size_t which) -> Vector3d {  // of its material point there
    if (which < obstacles) return Vector3d::Zero();
    const BodyNode& node = *bodies_[which - obstacles];
    const Vector3d v = node.getLinearVelocity();
    const Vector3d then = node.getWorldTransform().translation() - time_step() * v;
    return v + node.getAngularVelocity().cross(contact.point - then);
  };
  const Vector3d slip = velocity(on) - velocity(other);
  const Vector3d friction = force - force.dot(normal) * normal;

  stiction_contact told{};
  told.body = on - obstacles;
  told.against_body = other >= obstacles ? 1 : 0;
  told.other = told.against_body ? other - obstacles : other;
  Map<Vector3d>(told.normal) = normal;
  told.gap = -contact.penetrationDepth;
  told.normal_force = std::max(force.dot(normal), 0.0);
  Map<Vector3d>(told.friction_force) = friction;
  Map<Vector3d>(told.slip) = slip - slip.dot(normal) * normal;
  Map<Vector3d>(told.position) = contact.point;
  const double mu = told.against_body ? problem_.friction : problem_.obstacles[told.other].friction;
  told.sticks = friction.norm() < (1.0 - 1e-9) * mu * told.normal_force ? 1 : 0;
  return told;
}

}  // namespace stiction_dart
