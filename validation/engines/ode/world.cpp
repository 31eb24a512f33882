// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/ode/world.h"

namespace stiction::ode {

namespace {

dGeomID shape_of(const stiction_body& body, dSpaceID space) {
  switch (body.shape) {
    case STICTION_BOX:
      return dCreateBox(space, body.size[0], body.size[1], body.size[2]);
    case STICTION_BALL:
      return dCreateSphere(space, body.radius);
    case STICTION_MESH:
      stiction_lacks("meshes");
    case STICTION_POINT:
      break;
  }
  stiction_lacks("bodies without extension");
}

Vector3d value_at(const stiction_keyframes& keyframes, double t) {
  Vector3d value;
  stiction_at(&keyframes, t, value.data());
  return value;
}

}  // namespace

World::World(const stiction_problem& problem)
    : problem_(problem), parameters_(read_parameters(problem)) {
  dInitODE2(0);
  dRandSetSeed(0);
  world_ = dWorldCreate();
  space_ = dHashSpaceCreate(nullptr);
  joints_ = dJointGroupCreate(0);
  const Parameters& p = parameters_;
  dWorldSetERP(world_, p.erp);
  dWorldSetCFM(world_, p.cfm);
  dWorldSetQuickStepNumIterations(world_, p.iterations);
  dWorldSetQuickStepW(world_, p.over_relaxation);
  dWorldSetAutoDisableFlag(world_, 0);
  dWorldSetLinearDamping(world_, p.linear_damping);
  dWorldSetAngularDamping(world_, p.angular_damping);
  dWorldSetContactSurfaceLayer(world_, p.surface_layer);
  if (p.max_correcting_velocity > 0.0) {
    dWorldSetContactMaxCorrectingVel(world_, p.max_correcting_velocity);
  }
  for (size_t b = 0; b < problem.body_count; ++b) add_body(problem.bodies[b]);
  for (size_t o = 0; o < problem.obstacle_count; ++o) add_obstacle(problem.obstacles[o]);
  for (size_t k = 0; k < geoms_.size(); ++k) dGeomSetData(geoms_[k], reinterpret_cast<void*>(k));
}

World::~World() {
  dJointGroupDestroy(joints_);
  dSpaceDestroy(space_);
  dWorldDestroy(world_);
  dCloseODE();
}

void World::add_body(const stiction_body& body) {
  if (body.held) stiction_lacks("held parts");
  const dGeomID geom = geoms_.emplace_back(shape_of(body, space_));
  const dBodyID own = bodies_.emplace_back(dBodyCreate(world_));
  dMass mass;
  const auto& i = body.inertia;
  dMassSetParameters(&mass, body.mass, 0, 0, 0, i[0][0], i[1][1], i[2][2], i[0][1], i[0][2],
                     i[1][2]);
  dBodySetMass(own, &mass);
  dGeomSetBody(geom, own);
  const double *x = body.position, *v = body.velocity, *w = body.angular_velocity;
  dBodySetPosition(own, x[0], x[1], x[2]);
  dBodySetQuaternion(own, body.rotation);
  dBodySetLinearVel(own, v[0], v[1], v[2]);
  dBodySetAngularVel(own, w[0], w[1], w[2]);
  dBodySetFiniteRotationMode(own, parameters_.finite_rotation);
}

void World::add_obstacle(const stiction_obstacle& obstacle) {
  const Vector3d n(obstacle.normal), point(obstacle.point);
  geoms_.push_back(dCreatePlane(space_, n.x(), n.y(), n.z(), n.dot(point)));
  obstacle_velocity_.emplace_back(Vector3d::Zero());
}

// A plane stands where it is at t; contacts with it aim at its mean velocity in the coming step.
void World::move_obstacles(double t) {
  for (size_t o = 0; o < obstacle_velocity_.size(); ++o) {
    const stiction_obstacle& obstacle = problem_.obstacles[o];
    if (!stiction_moves(&obstacle.motion)) continue;
    const Vector3d now = value_at(obstacle.motion, t);
    obstacle_velocity_[o] = (value_at(obstacle.motion, t + time_step()) - now) / time_step();
    const Vector3d n(obstacle.normal), point = Vector3d(obstacle.point) + now;
    dGeomPlaneSetParams(geoms_[bodies_.size() + o], n.x(), n.y(), n.z(), n.dot(point));
  }
}

// Gravity, loads and the medium's drag, as they are at the beginning of a step.
void World::apply_loads(double t) {
  gravity_ = value_at(problem_.gravity, t);
  dWorldSetGravity(world_, gravity_.x(), gravity_.y(), gravity_.z());
  const double drag = stiction_drag(&problem_, t);
  for (size_t b = 0; b < bodies_.size(); ++b) {
    const dBodyID body = bodies_[b];
    if (stiction_has_loads(&problem_, b)) {
      double force[3], couple[3];
      stiction_load(&problem_, b, t, dBodyGetPosition(body), force, couple);
      dBodyAddForce(body, force[0], force[1], force[2]);
      dBodyAddTorque(body, couple[0], couple[1], couple[2]);
    }
    if (drag > 0.0) {
      const stiction_body& own = problem_.bodies[b];
      const Vector3d force = -drag * own.mass * Map<const Vector3d>(dBodyGetLinearVel(body));
      dBodyAddForce(body, force.x(), force.y(), force.z());
      dVector3 spin;
      dBodyVectorFromWorld(body, dBodyGetAngularVel(body)[0], dBodyGetAngularVel(body)[1],
                           dBodyGetAngularVel(body)[2], spin);
      const Vector3d couple =
          -drag * (Map<const Eigen::Matrix3d>(&own.inertia[0][0]) * Map<const Vector3d>(spin));
      dBodyAddRelTorque(body, couple.x(), couple.y(), couple.z());
    }
  }
}

void World::advance(std::uint64_t steps) {
  for (; steps > 0; --steps) {
    const double t = time();
    move_obstacles(t);
    apply_loads(t);
    find_contacts();
    attach_contacts();
    if (parameters_.exact) {
      dWorldStep(world_, time_step());
    } else {
      dWorldQuickStep(world_, time_step());
    }
    dJointGroupEmpty(joints_);
    ++steps_;
  }
}

void World::body(size_t index, stiction_body_state& state) const {
  const dBodyID body = bodies_[index];
  std::copy_n(dBodyGetPosition(body), 3, state.position);
  std::copy_n(dBodyGetLinearVel(body), 3, state.velocity);
  std::copy_n(dBodyGetQuaternion(body), 4, state.rotation);
  std::copy_n(dBodyGetAngularVel(body), 3, state.angular_velocity);
}

World::State World::save() const {
  State state{steps_, dRandGetSeed(), {}};
  for (const dBodyID body : bodies_) {
    const auto add = [&](const dReal* from, int count) {
      state.numbers.insert(state.numbers.end(), from, from + count);
    };
    add(dBodyGetPosition(body), 3);
    add(dBodyGetQuaternion(body), 4);
    add(dBodyGetRotation(body), 12);
    add(dBodyGetLinearVel(body), 3);
    add(dBodyGetAngularVel(body), 3);
  }
  return state;
}

void World::restore(const State& state) {
  steps_ = state.steps;
  dRandSetSeed(state.seed);
  const double* n = state.numbers.data();
  for (const dBodyID body : bodies_) {
    dBodySetPosition(body, n[0], n[1], n[2]);
    dBodySetQuaternion(body, n + 3);
    // ODE normalises what it is given, which may move its last bit: put back as it was.
    std::copy_n(n + 3, 4, const_cast<dReal*>(dBodyGetQuaternion(body)));
    std::copy_n(n + 7, 12, const_cast<dReal*>(dBodyGetRotation(body)));
    dBodySetLinearVel(body, n[19], n[20], n[21]);
    dBodySetAngularVel(body, n[22], n[23], n[24]);
    n += 25;
  }
  contacts_.clear();
}

}  // namespace stiction::ode
