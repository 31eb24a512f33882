// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "validation/engines/ode/world.h"

namespace stiction::ode {

namespace {

constexpr double kLeastSlip = 1e-12;  // m/s: below it a slip has no direction

}  // namespace

// In the order of their numbers: that in which a space comes upon its pairs depends on its history.
void World::find_contacts() {
  contacts_.clear();
  pairs_.clear();
  dSpaceCollide(space_, &pairs_, [](void* data, dGeomID a, dGeomID b) {
    const auto number = [](dGeomID geom) { return reinterpret_cast<size_t>(dGeomGetData(geom)); };
    static_cast<std::vector<std::pair<size_t, size_t>>*>(data)->push_back(
        std::minmax(number(a), number(b)));
  });
  std::sort(pairs_.begin(), pairs_.end());
  std::vector<dContactGeom> found(static_cast<size_t>(parameters_.max_contacts));
  for (const auto& [body, other] : pairs_) {
    if (body >= bodies_.size()) continue;
    const int count = dCollide(geoms_[body], geoms_[other], parameters_.max_contacts, found.data(),
                               sizeof(dContactGeom));
    const bool against_body = other < bodies_.size();
    for (int k = 0; k < count; ++k) {
      Contact contact{body, against_body ? other : other - bodies_.size(), against_body, {}, {}};
      contact.joint.geom = found[static_cast<size_t>(k)];
      set_surface(contact);
      contacts_.push_back(contact);
    }
  }
}

// Of a body's point at the step's start; predicted: at its end, were there no contact.
Vector3d World::velocity_at(size_t body, const Vector3d& point, bool predicted) const {
  const dBodyID own = bodies_[body];
  const Vector3d arm = point - Map<const Vector3d>(dBodyGetPosition(own));
  Vector3d v = Map<const Vector3d>(dBodyGetLinearVel(own));
  Vector3d w = Map<const Vector3d>(dBodyGetAngularVel(own));
  if (predicted) {
    const stiction_body& it = problem_.bodies[body];
    const dReal* q = dBodyGetQuaternion(own);
    const Eigen::Quaterniond rotation(q[0], q[1], q[2], q[3]);
    const Vector3d couple = rotation.conjugate() * Map<const Vector3d>(dBodyGetTorque(own));
    const Vector3d force = Map<const Vector3d>(dBodyGetForce(own));
    v += time_step() * (gravity_ + force / it.mass);
    const Eigen::Matrix3d inertia = Map<const Eigen::Matrix3d>(&it.inertia[0][0]);
    w += time_step() * (rotation * Vector3d(inertia.inverse() * couple));
  }
  return v + w.cross(arm);
}

void World::set_surface(Contact& contact) const {
  dSurfaceParameters& surface = contact.joint.surface;
  surface.mode = dContactApprox1;  // bounds follow the normal force; else μ would be a force
  surface.mu = stiction_friction(&problem_, contact.body, contact.other, contact.against_body);
  if (problem_.restitution > 0.0) {
    surface.mode |= dContactBounce;
    surface.bounce = problem_.restitution;
  }
  if (parameters_.soft_cfm >= 0.0) {
    surface.mode |= dContactSoftCFM;
    surface.soft_cfm = parameters_.soft_cfm;
  }
  const Vector3d n = Map<const Vector3d>(contact.joint.geom.normal);
  const Vector3d point = Map<const Vector3d>(contact.joint.geom.pos);
  const bool moved =
      !contact.against_body && stiction_moves(&problem_.obstacles[contact.other].motion);
  Vector3d direction = Vector3d::Zero();
  if (parameters_.friction_direction != FrictionDirection::kEngine) {
    const bool predicted = parameters_.friction_direction == FrictionDirection::kPredicted;
    const Vector3d other = contact.against_body ? velocity_at(contact.other, point, predicted)
                                                : obstacle_velocity_[contact.other];
    const Vector3d over = velocity_at(contact.body, point, predicted) - other;
    const Vector3d slip = over - n.dot(over) * n;
    if (slip.norm() > kLeastSlip) direction = slip.normalized();
  }
  if (direction.isZero(0.0) && moved) direction = n.unitOrthogonal();
  if (direction.isZero(0.0)) return;
  surface.mode |= dContactFDir1;
  Map<Vector3d>(contact.joint.fdir1) = direction;
  if (!moved) return;
  surface.mode |= dContactMotion1 | dContactMotion2 | dContactMotionN;
  const Vector3d& velocity = obstacle_velocity_[contact.other];
  surface.motion1 = direction.dot(velocity);
  surface.motion2 = n.cross(direction).dot(velocity);
  surface.motionN = n.dot(velocity);
}

void World::attach_contacts() {
  for (Contact& contact : contacts_) {
    const dJointID joint = dJointCreateContact(world_, joints_, &contact.joint);
    dJointAttach(joint, bodies_[contact.body],
                 contact.against_body ? bodies_[contact.other] : nullptr);
    dJointSetFeedback(joint, &contact.feedback);
  }
}

std::vector<stiction_contact> World::contacts() const {
  std::vector<stiction_contact> all;
  for (const Contact& one : contacts_) {
    const Vector3d n = Map<const Vector3d>(one.joint.geom.normal);
    const Vector3d point = Map<const Vector3d>(one.joint.geom.pos);
    const Vector3d velocity = velocity_at(one.body, point, false);
    const Vector3d over = velocity - (one.against_body ? velocity_at(one.other, point, false)
                                                       : obstacle_velocity_[one.other]);
    const Vector3d force = Map<const Vector3d>(one.feedback.f1);
    const Vector3d friction = force - n.dot(force) * n;
    stiction_contact told{};
    told.body = one.body;
    told.other = one.other;
    told.against_body = one.against_body;
    Map<Vector3d>(told.normal) = n;
    told.gap = time_step() * n.dot(over) - one.joint.geom.depth;
    told.normal_force = std::max(n.dot(force), 0.0);
    Map<Vector3d>(told.friction_force) = friction;
    Map<Vector3d>(told.slip) = over - n.dot(over) * n;
    Map<Vector3d>(told.position) = point + time_step() * velocity;
    // ODE has no word for it: strictly within the bounds of both friction rows.
    dVector3 first, second;
    dPlaneSpace(one.joint.geom.normal, first, second);
    const bool chosen = (one.joint.surface.mode & dContactFDir1) != 0;
    const Vector3d along = Map<const Vector3d>(chosen ? one.joint.fdir1 : first);
    const double most =
        std::max(std::abs(friction.dot(along)), std::abs(friction.dot(n.cross(along))));
    told.sticks = most < (1.0 - 1e-9) * one.joint.surface.mu * told.normal_force;
    all.push_back(told);
  }
  return all;
}

}  // namespace stiction::ode
