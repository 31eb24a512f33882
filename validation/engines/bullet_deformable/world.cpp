// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/bullet_deformable/world.h"

#include <Eigen/Geometry>
#include <cmath>
#include <set>

namespace stiction::bullet_deformable {

namespace {

btScalar scalar(double value) { return static_cast<btScalar>(value); }

btVector3 vector(const Vector3d& v) { return {scalar(v.x()), scalar(v.y()), scalar(v.z())}; }

Vector3d value_at(const stiction_keyframes& keyframes, double t) {
  Vector3d value;
  stiction_at(&keyframes, t, value.data());
  return value;
}

// Bullet multiplies two coefficients: √μ of bodies makes μ between them, and with an obstacle of
// μ' / √μ just μ'. A body alone, or smooth ones, may be anything but 0.
double body_friction(const stiction_problem& problem) {
  return problem.friction > 0.0 ? std::sqrt(problem.friction) : 1e-6;
}

Eigen::Quaterniond rotation_of(const stiction_body& body) {
  const double* q = body.rotation;
  return {q[0], q[1], q[2], q[3]};
}

std::set<std::pair<int, int>> edges(const SoftMesh& mesh) {
  std::set<std::pair<int, int>> all;
  for (const auto& t : mesh.tetrahedra) {
    for (size_t a = 0; a < 4; ++a) {
      for (size_t b = 0; b < a; ++b) all.insert(std::minmax(t[a], t[b]));
    }
  }
  return all;
}

btSoftBody::TetraScratch unstrained() {
  const btMatrix3x3 one = btMatrix3x3::getIdentity();
  return {.m_F = one, .m_trace = 3, .m_J = 1, .m_cofF = one, .m_corotation = one};
}

}  // namespace

World::World(const stiction_problem& problem)
    : problem_(problem),
      parameters_(read_parameters(problem)),
      configuration_(std::make_unique<btSoftBodyRigidBodyCollisionConfiguration>()),
      dispatcher_(std::make_unique<btCollisionDispatcher>(configuration_.get())),
      broadphase_(std::make_unique<btDbvtBroadphase>()),
      body_solver_(std::make_unique<btDeformableBodySolver>()),
      solver_(std::make_unique<btDeformableMultiBodyConstraintSolver>()) {
  const Parameters& p = parameters_;
  solver_->setDeformableSolver(body_solver_.get());
  world_ = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
      dispatcher_.get(), broadphase_.get(), solver_.get(), configuration_.get(),
      body_solver_.get());
  world_->setGravity(btVector3(0, 0, 0));  // each body's field has it
  world_->getWorldInfo().m_gravity.setZero();
  world_->getWorldInfo().air_density = 0;
  world_->getWorldInfo().m_sparsesdf.setDefaultVoxelsz(scalar(p.voxel));
  world_->getWorldInfo().m_sparsesdf.Reset();
  world_->setImplicit(p.implicit);
  world_->setLineSearch(p.line_search);
  world_->setUseProjection(p.projection);
  btContactSolverInfo& info = world_->getSolverInfo();
  info.m_numIterations = p.iterations;
  info.m_leastSquaresResidualThreshold = scalar(p.residual);
  info.m_deformable_erp = scalar(p.erp);
  info.m_deformable_maxErrorReduction = scalar(p.max_correction);
  for (size_t b = 0; b < problem.body_count; ++b) add_body(problem.bodies[b]);
  for (size_t o = 0; o < problem.obstacle_count; ++o) add_obstacle(problem.obstacles[o]);
}

World::~World() {
  for (auto& body : bodies_) world_->removeSoftBody(body.get());
}

void World::add_body(const stiction_body& body) {
  if (body.held) stiction_lacks("held parts");
  if (body.self_collision) stiction_lacks("bodies that touch themselves");
  const SoftMesh& mesh = meshes_.emplace_back(soft_mesh(body, parameters_));
  const Eigen::Quaterniond rotation = rotation_of(body);
  std::vector<btVector3> places;
  std::vector<btScalar> masses;
  for (size_t k = 0; k < mesh.nodes.size(); ++k) {
    places.push_back(vector(Vector3d(body.position) + rotation * mesh.nodes[k]));
    masses.push_back(scalar(mesh.masses[k]));
  }
  auto& own = *bodies_.emplace_back(std::make_unique<btSoftBody>(
      &world_->getWorldInfo(), static_cast<int>(places.size()), places.data(), masses.data()));
  for (const auto& t : mesh.tetrahedra) own.appendTetra(t[0], t[1], t[2], t[3]);
  for (const auto& f : mesh.surface) own.appendFace(f[0], f[1], f[2]);
  // Without force; but Bullet builds its tree of nodes along them, and without them never ends.
  for (const auto& [a, b] : edges(mesh)) own.appendLink(a, b);
  own.initializeDmInverse();
  own.m_tetraScratches.resize(own.m_tetras.size(), unstrained());
  own.m_tetraScratchesTn.resize(own.m_tetras.size(), unstrained());
  own.getCollisionShape()->setMargin(scalar(parameters_.margin));
  own.m_cfg.kDF = scalar(body_friction(problem_));
  own.m_cfg.kKHR = own.m_cfg.kCHR = 1;
  using Collision = btSoftBody::fCollision;
  own.m_cfg.collisions = Collision::SDF_RD | Collision::SDF_RDN | Collision::VF_DD;
  own.setSelfCollision(false);
  own.m_sleepingThreshold = 0;
  own.setActivationState(DISABLE_DEACTIVATION);
  const Vector3d spin(body.angular_velocity), v(body.velocity);
  for (size_t k = 0; k < mesh.nodes.size(); ++k) {
    btSoftBody::Node& node = own.m_nodes[static_cast<int>(k)];
    node.m_v = node.m_vn = vector(v + spin.cross(rotation * mesh.nodes[k]));
  }
  world_->addSoftBody(&own);
  auto& field = *fields_.emplace_back(std::make_unique<FieldForce>());
  field.addSoftBody(&own);
  add_force(field);
  add_elasticity(body);
}

// The world's addForce would give all bodies the elasticity of the first.
void World::add_force(btDeformableLagrangianForce& force) {
  force.setIndices(body_solver_->m_objective->getIndices());
  body_solver_->m_objective->m_lf.push_back(&force);
}

void World::add_elasticity(const stiction_body& body) {
  const double nu = body.poisson_ratio, modulus = body.youngs_modulus;
  const btScalar mu = scalar(modulus / (2.0 * (1.0 + nu)));
  const btScalar lambda = scalar(modulus * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)));
  const btScalar alpha = scalar(parameters_.mass_damping), beta = scalar(body.damping_time);
  if (parameters_.neo_hookean) {
    elasticity_.push_back(std::make_unique<btDeformableNeoHookeanForce>(mu, lambda, beta));
  } else {
    elasticity_.push_back(
        std::make_unique<btDeformableLinearElasticityForce>(mu, lambda, alpha, beta));
  }
  elasticity_.back()->addSoftBody(bodies_.back().get());
  add_force(*elasticity_.back());
}

void World::add_obstacle(const stiction_obstacle& obstacle) {
  const Vector3d n(obstacle.normal);
  // Nodes stop a margin above what they touch: the box stands so much lower.
  const double half = 0.5 * parameters_.ground_size, low = half + parameters_.margin;
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), n);
  btTransform pose;
  pose.setOrigin(obstacle_origins_.emplace_back(vector(Vector3d(obstacle.point) - low * n)));
  pose.setRotation({scalar(turn.x()), scalar(turn.y()), scalar(turn.z()), scalar(turn.w())});
  const btScalar edge = scalar(half);
  shapes_.push_back(std::make_unique<btBoxShape>(btVector3(edge, edge, edge)));
  const btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shapes_.back().get());
  btRigidBody& own = *obstacles_.emplace_back(std::make_unique<btRigidBody>(info));
  own.setCenterOfMassTransform(pose);
  own.setInterpolationWorldTransform(pose);
  own.setFriction(scalar(obstacle.friction / body_friction(problem_)));
  own.setActivationState(DISABLE_DEACTIVATION);
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
    const btVector3 now = vector(value_at(motion, t));
    const btVector3 step = vector(value_at(motion, t + time_step()) - value_at(motion, t));
    btTransform pose = obstacles_[o]->getWorldTransform();
    pose.setOrigin(obstacle_origins_[o] + now - step);
    obstacles_[o]->setInterpolationWorldTransform(pose);
    pose.setOrigin(obstacle_origins_[o] + now);
    obstacles_[o]->setWorldTransform(pose);
  }
}

// Gravity, loads and the medium's drag, as they are at the beginning of a step.
void World::apply_loads(double t) {
  const Vector3d gravity = value_at(problem_.gravity, t);
  for (size_t b = 0; b < fields_.size(); ++b) {
    FieldForce& field = *fields_[b];
    field.m_gravity = vector(gravity);
    field.drag = scalar(stiction_drag(&problem_, t));
    if (!stiction_has_loads(&problem_, b)) continue;
    stiction_body_state state;
    body(b, state);
    double force[3], couple[3];
    stiction_load(&problem_, b, t, state.position, force, couple);
    const double* q = state.rotation;
    const Eigen::Quaterniond rotation(q[0], q[1], q[2], q[3]);
    const auto inertia = Eigen::Map<const Eigen::Matrix3d>(&problem_.bodies[b].inertia[0][0]);
    field.centre = vector(Vector3d(state.position));
    field.acceleration = vector(Vector3d(force) / problem_.bodies[b].mass);
    field.angular_acceleration =
        vector(rotation * (inertia.inverse() * (rotation.conjugate() * Vector3d(couple))));
  }
}

void World::advance(std::uint64_t steps) {
  for (; steps > 0; --steps) {
    const double t = time();
    move_obstacles(t);
    apply_loads(t);
    world_->stepSimulation(scalar(time_step()), 0);  // 0: one step of just this Δt
    ++steps_;
  }
}

}  // namespace stiction::bullet_deformable
