// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/dart/native.h"

#include <algorithm>
#include <dart/collision/CollisionObject.hpp>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/collision/fcl/FCLCollisionDetector.hpp>
#include <dart/constraint/BoxedLcpConstraintSolver.hpp>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/constraint/DantzigBoxedLcpSolver.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <dart/dynamics/ShapeNode.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <memory>
#include <stdexcept>
#include <string>

namespace stiction_dart {

namespace {

using dart::constraint::ContactConstraint;

std::shared_ptr<dart::collision::CollisionDetector> detector(const std::string& name) {
  if (name == "dart") return dart::collision::DARTCollisionDetector::create();
  const auto fcl = dart::collision::FCLCollisionDetector::create();
  if (name == "fcl-primitive") {
    fcl->setPrimitiveShapeType(dart::collision::FCLCollisionDetector::PRIMITIVE);
  } else if (name == "fcl") {  // as DART's worlds have it: shapes are meshes
    fcl->setPrimitiveShapeType(dart::collision::FCLCollisionDetector::MESH);
  } else {
    throw std::runtime_error("setting 'detector' is fcl, fcl-primitive or dart, not '" + name +
                             "'");
  }
  return fcl;
}

dart::constraint::BoxedLcpSolverPtr pgs() {
  dart::constraint::PgsBoxedLcpSolver::Option option;
  option.mMaxIteration = static_cast<int>(stiction_number("iterations", option.mMaxIteration));
  option.mDeltaXThreshold = stiction_number("tolerance", option.mDeltaXThreshold);
  option.mRelativeDeltaXTolerance =
      stiction_number("relative_tolerance", option.mRelativeDeltaXTolerance);
  const auto solver = std::make_shared<dart::constraint::PgsBoxedLcpSolver>();
  solver->setOption(option);
  return solver;
}

// Where Dantzig's method fails, PGS takes over, as in DART's worlds.
std::unique_ptr<dart::constraint::ConstraintSolver> solver(const std::string& name) {
  using dart::constraint::BoxedLcpConstraintSolver;
  if (name == "pgs") return std::make_unique<BoxedLcpConstraintSolver>(pgs(), nullptr);
  if (name == "dantzig") {
    return std::make_unique<BoxedLcpConstraintSolver>(
        std::make_shared<dart::constraint::DantzigBoxedLcpSolver>(), pgs());
  }
  throw std::runtime_error("setting 'solver' is dantzig or pgs, not '" + name + "'");
}

bool against_obstacle(const dart::collision::CollisionObject* object) {
  return !object->getShapeFrame()->asShapeNode()->getBodyNodePtr()->getSkeleton()->isMobile();
}

}  // namespace

dart::simulation::WorldPtr make_world(const stiction_problem& problem) {
  auto world = dart::simulation::World::create();
  double dt = world->getTimeStep();
  if (problem.time > 0.0) dt = std::min(dt, problem.time);
  dt = stiction_number("dt", dt) / problem.finer;
  if (!(dt > 0.0)) stiction_refuse("setting 'dt' must be above 0");
  stiction_tell_number("dt", dt);
  world->setConstraintSolver(solver(stiction_text("solver", "dantzig")));
  world->getConstraintSolver()->setCollisionDetector(detector(stiction_text("detector", "fcl")));
  auto& collisions = world->getConstraintSolver()->getCollisionOption();
  collisions.maxNumContacts =
      std::max(collisions.maxNumContacts, 100 * (problem.body_count + problem.obstacle_count));
  world->setTimeStep(dt);
  ContactConstraint::setErrorReductionParameter(
      stiction_number("erp", ContactConstraint::getErrorReductionParameter()));
  ContactConstraint::setErrorAllowance(
      stiction_number("error_allowance", ContactConstraint::getErrorAllowance()));
  ContactConstraint::setMaxErrorReductionVelocity(
      stiction_number("max_erv", ContactConstraint::getMaxErrorReductionVelocity()));
  ContactConstraint::setConstraintForceMixing(
      stiction_number("cfm", ContactConstraint::getConstraintForceMixing()));
  return world;
}

bool TwoShapes::ignoresCollision(const dart::collision::CollisionObject* one,
                                 const dart::collision::CollisionObject* other) const {
  const bool obstacle = against_obstacle(one) || against_obstacle(other);
  const std::string wrong = obstacle ? "on bodies" : "on obstacles";
  return one->getShapeFrame()->getName() == wrong || other->getShapeFrame()->getName() == wrong ||
         BodyNodeCollisionFilter::ignoresCollision(one, other);
}

}  // namespace stiction_dart
