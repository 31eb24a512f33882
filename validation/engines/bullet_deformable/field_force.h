// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engines/bullet_deformable/bullet_soft.h"

namespace stiction::bullet_deformable {

/// Gravity, drag and loads of one body in one of Bullet's forces: each node is pulled by its mass
/// times g − c v + a + α × (x − centre). So a load acts through the centre, and a couple turns the
/// body about it without straining it more than its inertia does.
class FieldForce : public btDeformableGravityForce {
 public:
  FieldForce() : btDeformableGravityForce(btVector3(0, 0, 0)) {}

  btScalar drag = 0;                        ///< c, 1/s
  btVector3 acceleration{0, 0, 0};          ///< a, m/s²
  btVector3 angular_acceleration{0, 0, 0};  ///< α, 1/s²
  btVector3 centre{0, 0, 0};                ///< m

  void addScaledGravityForce(btScalar scale, TVStack& force) override {
    for (int b = 0; b < m_softBodies.size(); ++b) {
      const auto& nodes = m_softBodies[b]->m_nodes;
      for (int k = 0; k < nodes.size(); ++k) {
        const btSoftBody::Node& node = nodes[k];
        if (node.m_im == 0) continue;
        const btVector3 field = m_gravity - drag * node.m_v + acceleration +
                                angular_acceleration.cross(node.m_x - centre);
        force[node.index] += scale / node.m_im * field;
      }
    }
  }
};

}  // namespace stiction::bullet_deformable
