// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/bullet/shapes.h"
#include "validation/engines/bullet/world.h"

namespace stiction::bullet {

namespace {

// Bullet's point between its bodies A and B, whose normal and impulses act on A.
stiction_contact contact_of(const btManifoldPoint& point, const btRigidBody& a,
                            const btRigidBody& b, btScalar time_step) {
  const btVector3 on_a = a.getWorldTransform() * point.m_localPointA;
  const btVector3 on_b = b.getWorldTransform() * point.m_localPointB;
  const btVector3& n = point.m_normalWorldOnB;
  const btVector3 over = a.getVelocityInLocalPoint(on_a - a.getWorldTransform().getOrigin()) -
                         b.getVelocityInLocalPoint(on_b - b.getWorldTransform().getOrigin());
  const btVector3 friction = (point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                              point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2) /
                             time_step;
  const btScalar normal_force = point.m_appliedImpulse / time_step;
  const bool of_b = a.getUserIndex() < 0;  // A is an obstacle: seen from B
  const btScalar sign = of_b ? btScalar(-1) : btScalar(1);
  const int body = of_b ? b.getUserIndex() : a.getUserIndex();
  const int other = of_b ? a.getUserIndex() : b.getUserIndex();
  stiction_contact contact{};
  contact.body = static_cast<size_t>(body);
  contact.against_body = other >= 0;
  contact.other = static_cast<size_t>(other >= 0 ? other : -1 - other);
  copy(sign * n, contact.normal);
  contact.gap = static_cast<double>((on_a - on_b).dot(n));
  contact.normal_force = static_cast<double>(normal_force);
  copy(sign * friction, contact.friction_force);
  copy(sign * (over - n * n.dot(over)), contact.slip);
  copy((on_a + on_b) / 2, contact.position);
  // Bullet has no word for it: strictly within the bound of its friction row, to single precision.
  contact.sticks = friction.length() < btScalar(1 - 1e-5) * point.m_combinedFriction * normal_force;
  return contact;
}

}  // namespace

std::vector<stiction_contact> World::contacts() const {
  std::vector<stiction_contact> all;
  for (int m = 0; m < dispatcher_->getNumManifolds(); ++m) {
    const btPersistentManifold& manifold = *dispatcher_->getManifoldByIndexInternal(m);
    const btRigidBody* a = btRigidBody::upcast(manifold.getBody0());
    const btRigidBody* b = btRigidBody::upcast(manifold.getBody1());
    if (!a || !b) continue;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const stiction_contact one =
          contact_of(manifold.getContactPoint(k), *a, *b, static_cast<btScalar>(time_step()));
      if (one.normal_force > 0.0 || one.gap <= 0.0) all.push_back(one);
    }
  }
  return all;
}

}  // namespace stiction::bullet
