// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "solver/contact/edge_contacts.h"
#include "solver/contact/pair_contacts.h"
#include "solver/state.h"

namespace stiction {

/// v less its part along the unit vector n.
inline Vec3 tangential(const Vec3& v, const Vec3& n) { return v - n.dot(v) * n; }

/// Tangential slip velocity of a vertex over the body that it touches, m/s:
///
///   u = (1 − n nᵀ)(vᵢ − Σⱼ hᵢⱼ vⱼ)
inline Vec3 slip_of(const PairContact& contact, std::span<const Velocity> velocity) {
  Vec3 v = velocity[static_cast<std::size_t>(contact.vertex)].v;
  for (int k = 0; k < 4; ++k) {
    v -= contact.weight[k] * velocity[static_cast<std::size_t>(contact.partner[k])].v;
  }
  return tangential(v, contact.normal);
}

/// The same where edge a crosses edge b; vᵢ is that of a's point there.
inline Vec3 slip_of(const EdgeContact& contact, std::span<const Velocity> velocity) {
  Vec3 v = Vec3::Zero();
  for (int k = 0; k < 2; ++k) {
    v += contact.own_weight[k] * velocity[static_cast<std::size_t>(contact.vertex[k])].v;
  }
  for (int k = 0; k < 4; ++k) {
    v -= contact.weight[k] * velocity[static_cast<std::size_t>(contact.partner[k])].v;
  }
  return tangential(v, contact.normal);
}

}  // namespace stiction
