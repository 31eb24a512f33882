// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/bullet/world.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>

#include <algorithm>

#include "validation/engines/bullet/shapes.h"

extern btScalar gContactBreakingThreshold;

namespace stiction::bullet {

namespace {

// μ of a pair as the problem has it, in place of Bullet's product of two coefficients.
btScalar pair_friction(const btCollisionObject* a, const btCollisionObject* b) {
  const auto [least, most] = std::minmax({a->getUserIndex(), b->getUserIndex()});
  const auto& problem = *static_cast<const stiction_problem*>(a->getUserPointer());
  const bool against_body = least >= 0;
  const int other = against_body ? least : -1 - least;
  return static_cast<btScalar>(stiction_friction(&problem, static_cast<size_t>(most),
                                                 static_cast<size_t>(other), against_body));
}

btScalar restitution(const btCollisionObject* a, const btCollisionObject*) {
  return static_cast<btScalar>(
      static_cast<const stiction_problem*>(a->getUserPointer())->restitution);
}

int solver_mode(const Parameters& p) {
  int mode = SOLVER_SIMD;
  if (p.warm_start > 0.0) mode |= SOLVER_USE_WARMSTARTING;
  if (p.friction_directions == 2) mode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  if (!p.directions_along_slip) mode |= SOLVER_DISABLE_VELOCITY_DEPENDENT_FRICTION_DIRECTION;
  if (p.random_order) mode |= SOLVER_RANDMIZE_ORDER;
  if (p.interleaved) mode |= SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS;
  return mode;
}

btVector3 value_at(const stiction_keyframes& keyframes, double t) {
  double value[3];
  stiction_at(&keyframes, t, value);
  return vector(value);
}

}  // namespace

World::World(const stiction_problem& problem)
    : problem_(problem),
      parameters_(read_parameters(problem)),
      configuration_(std::make_unique<btDefaultCollisionConfiguration>()),
      dispatcher_(std::make_unique<btCollisionDispatcher>(configuration_.get())),
      broadphase_(std::make_unique<btDbvtBroadphase>()) {
  gContactBreakingThreshold = static_cast<btScalar>(parameters_.contact_breaking);
  gCalculateCombinedFrictionCallback = pair_friction;
  gCalculateCombinedRestitutionCallback = restitution;
  if (parameters_.plane_points > 0) {
    configuration_->setPlaneConvexMultipointIterations(parameters_.plane_points, 4);
  }
  set_solver();
  for (size_t b = 0; b < problem.body_count; ++b) add_body(problem.bodies[b]);
  for (size_t o = 0; o < problem.obstacle_count; ++o) add_obstacle(problem.obstacles[o]);
}

World::~World() = default;

void World::set_solver() {
  if (parameters_.solver == "sequential_impulse") {
    solver_ = std::make_unique<btSequentialImpulseConstraintSolver>();
  } else if (parameters_.solver == "nncg") {
    solver_ = std::make_unique<btNNCGConstraintSolver>();
  } else if (parameters_.solver == "dantzig") {
    complementarity_ = std::make_unique<btDantzigSolver>();
  } else if (parameters_.solver == "projected_gauss_seidel") {
    complementarity_ = std::make_unique<btSolveProjectedGaussSeidel>();
  } else {
    stiction_refuse("solver must be sequential_impulse, nncg, dantzig or projected_gauss_seidel");
  }
  if (complementarity_) solver_ = std::make_unique<btMLCPSolver>(complementarity_.get());
  world_ = std::make_unique<btDiscreteDynamicsWorld>(dispatcher_.get(), broadphase_.get(),
                                                     solver_.get(), configuration_.get());
  btContactSolverInfo& info = world_->getSolverInfo();
  info.m_numIterations = parameters_.iterations;
  info.m_erp2 = static_cast<btScalar>(parameters_.erp);
  info.m_frictionERP = static_cast<btScalar>(parameters_.friction_erp);
  info.m_globalCfm = static_cast<btScalar>(parameters_.cfm);
  info.m_splitImpulsePenetrationThreshold = static_cast<btScalar>(parameters_.split_threshold);
  info.m_warmstartingFactor = static_cast<btScalar>(parameters_.warm_start);
  info.m_solverMode = solver_mode(parameters_);
  // Complementarity solvers want the whole problem, not islands of at least so many rows.
  if (complementarity_) info.m_minimumSolverBatchSize = 1;
}

btRigidBody& World::add(std::unique_ptr<btCollisionShape> shape, btScalar mass,
                        const btVector3& inertia, const btTransform& pose) {
  auto& list = mass > 0 ? bodies_ : obstacles_;
  const btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get(), inertia);
  auto& body = *list.emplace_back(std::make_unique<btRigidBody>(info));
  shapes_.push_back(std::move(shape));
  const int index = static_cast<int>(list.size()) - 1;
  body.setUserIndex(mass > 0 ? index : -1 - index);
  body.setUserPointer(const_cast<stiction_problem*>(&problem_));
  body.setActivationState(DISABLE_DEACTIVATION);
  body.setDamping(0, 0);
  body.setCenterOfMassTransform(pose);
  body.setInterpolationWorldTransform(pose);
  if (parameters_.friction_anchors) {
    body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_HAS_FRICTION_ANCHOR);
  }
  return body;
}

void World::add_body(const stiction_body& body) {
  if (body.held) stiction_lacks("held parts");
  BodyShape made = body_shape(body, parameters_);
  const double* q = body.rotation;
  const btQuaternion rotation(static_cast<btScalar>(q[1]), static_cast<btScalar>(q[2]),
                              static_cast<btScalar>(q[3]), static_cast<btScalar>(q[0]));
  const btTransform pose(rotation * made.principal, vector(body.position));
  principal_axes_.push_back(made.principal);
  btRigidBody& own =
      add(std::move(made.shape), static_cast<btScalar>(body.mass), made.inertia, pose);
  own.setLinearVelocity(vector(body.velocity));
  own.setAngularVelocity(vector(body.angular_velocity));
  own.updateInertiaTensor();
  world_->addRigidBody(&own);
}

void World::add_obstacle(const stiction_obstacle& obstacle) {
  ObstacleShape made = obstacle_shape(obstacle, parameters_);
  obstacle_origins_.push_back(made.pose.getOrigin());
  btRigidBody& own = add(std::move(made.shape), 0, btVector3(0, 0, 0), made.pose);
  if (stiction_moves(&obstacle.motion)) {
    own.setCollisionFlags(own.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  }
  world_->addRigidBody(&own);
}

// A kinematic body's velocity is, to Bullet, that from its interpolation transform to its world
// transform within a step. It stands where it is at t, with the velocity of the coming step.
void World::move_obstacles(double t) {
  for (size_t o = 0; o < obstacles_.size(); ++o) {
    const stiction_keyframes& motion = problem_.obstacles[o].motion;
    if (!stiction_moves(&motion)) continue;
    const btVector3 now = value_at(motion, t), next = value_at(motion, t + time_step());
    btTransform pose = obstacles_[o]->getWorldTransform();
    pose.setOrigin(obstacle_origins_[o] + now - (next - now));
    obstacles_[o]->setInterpolationWorldTransform(pose);
    pose.setOrigin(obstacle_origins_[o] + now);
    obstacles_[o]->setWorldTransform(pose);
  }
}

// Gravity, loads and the medium's drag, as they are at the beginning of a step.
void World::apply_loads(double t) {
  if (steps_ == 0 || stiction_varies(&problem_.gravity))
    world_->setGravity(value_at(problem_.gravity, t));
  const auto drag = static_cast<btScalar>(stiction_drag(&problem_, t));
  for (size_t b = 0; b < bodies_.size(); ++b) {
    btRigidBody& body = *bodies_[b];
    if (stiction_has_loads(&problem_, b)) {
      double position[3], force[3], couple[3];
      copy(body.getCenterOfMassPosition(), position);
      stiction_load(&problem_, b, t, position, force, couple);
      body.applyCentralForce(vector(force));
      body.applyTorque(vector(couple));
    }
    if (drag > 0) {
      body.applyCentralForce(-drag * body.getMass() * body.getLinearVelocity());
      body.applyTorque(-drag *
                       (body.getInvInertiaTensorWorld().inverse() * body.getAngularVelocity()));
    }
  }
}

void World::advance(std::uint64_t steps) {
  for (; steps > 0; --steps) {
    const double t = time();
    move_obstacles(t);
    apply_loads(t);
    world_->stepSimulation(static_cast<btScalar>(time_step()), 0);  // 0: one step of just this Δt
    ++steps_;
  }
}

void World::body(size_t index, stiction_body_state& state) const {
  const btRigidBody& body = *bodies_[index];
  copy(body.getCenterOfMassPosition(), state.position);
  copy(body.getLinearVelocity(), state.velocity);
  copy(body.getAngularVelocity(), state.angular_velocity);
  const btQuaternion q =
      body.getCenterOfMassTransform().getRotation() * principal_axes_[index].inverse();
  const btScalar wxyz[] = {q.w(), q.x(), q.y(), q.z()};
  for (int i = 0; i < 4; ++i) state.rotation[i] = static_cast<double>(wxyz[i]);
}

}  // namespace stiction::bullet
