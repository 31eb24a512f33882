// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "solver/contact/edge_contacts.h"
#include "solver/contact/pair_contacts.h"
#include "solver/contact/slip.h"
#include "solver/lanes/packed_vec3.h"
#include "solver/state.h"

namespace stiction {

/// `tangential` in one register.
STICTION_LANES_INLINE PackedVec3 tangential(const PackedVec3& v, const PackedVec3& n) {
  return v - n.dot(v) * n;
}

/// Calls work(k) for k = 0 … kCount − 1 as constants: what a loop indexes goes by way of memory.
template <std::size_t kCount, class Work>
STICTION_LANES_INLINE void for_constants(const Work& work) {
  [&]<std::size_t... k>(std::index_sequence<k...>) __attribute__((always_inline)) {
    (work(std::integral_constant<std::size_t, k>()), ...);
  }
  (std::make_index_sequence<kCount>());
}

/// A vertex whose velocity is in a register from when it is read until it has changed.
struct HeldVelocity {
  Velocity* place;
  PackedVec3 v;

  HeldVelocity() = default;
  STICTION_LANES_INLINE HeldVelocity(std::span<Velocity> velocity, std::int32_t vertex)
      : place(velocity.data() + static_cast<std::size_t>(vertex)), v(PackedVec3::load(place)) {}

  /// The inverse mass in all places, 1/kg.
  STICTION_LANES_INLINE PackedVec3 inverse_mass() const { return v.fourths(); }
  STICTION_LANES_INLINE void set(const PackedVec3& to) {
    v = to;
    v.store(place);
  }
};

/// The partners of a contact between bodies or of edges.
template <class Contact>
class HeldPartners {
 public:
  STICTION_LANES_INLINE HeldPartners(const Contact& contact, std::span<Velocity> velocity)
      : contact_(contact) {
    for_constants<4>([&](auto k) __attribute__((always_inline)) {
      partner_[k] = HeldVelocity(velocity, contact_.partner[k]);
    });
  }

  /// Slip of what moves with v over them, tangential, m/s.
  STICTION_LANES_INLINE PackedVec3 slip(PackedVec3 v) const {
    for_constants<4>([&](auto k) __attribute__((always_inline)) {
      v -= contact_.weight[k] * partner_[k].v;
    });
    return tangential(v, PackedVec3::load(contact_.normal.data()));
  }

  /// Puts the opposite of an impulse on them, N s; its fourth number is 0.
  STICTION_LANES_INLINE void push(const PackedVec3& impulse) {
    // Of a triangle the fourth repeats the third with a weight of 0: the third's is written last.
    for_constants<4>([&](auto k) __attribute__((always_inline)) {
      HeldVelocity& partner = partner_[3 - k];
      partner.set(partner.v - contact_.weight[3 - k] * partner.inverse_mass() * impulse);
    });
  }

 private:
  const Contact& contact_;
  HeldVelocity partner_[4];
};

/// The velocities that a contact acts on; its vertex is none of its partners. With the bits of `slip_of` and of sums vertex by vertex.
class HeldVelocities {
 public:
  STICTION_LANES_INLINE HeldVelocities(const PairContact& contact, std::span<Velocity> velocity)
      : own_(velocity, contact.vertex), partners_(contact, velocity) {}

  STICTION_LANES_INLINE PackedVec3 slip() const { return partners_.slip(own_.v); }

  /// Puts an impulse, N s, on the vertex and, where bodies react, the opposite one on its partners.
  STICTION_LANES_INLINE void push(const PackedVec3& impulse, bool react) {
    const PackedVec3 only = impulse.without_fourth();  // inverse masses stay
    own_.set(own_.v + own_.inverse_mass() * only);
    if (react) partners_.push(only);
  }

 private:
  HeldVelocity own_;
  HeldPartners<PairContact> partners_;
};

/// The same of a contact of edges.
class HeldEdgeVelocities {
 public:
  STICTION_LANES_INLINE HeldEdgeVelocities(const EdgeContact& contact, std::span<Velocity> velocity)
      : contact_(contact),
        first_(velocity, contact.vertex[0]),
        second_(velocity, contact.vertex[1]),
        partners_(contact, velocity) {}

  STICTION_LANES_INLINE PackedVec3 slip() const {
    return partners_.slip(PackedVec3::Zero() + contact_.own_weight[0] * first_.v +
                          contact_.own_weight[1] * second_.v);
  }

  STICTION_LANES_INLINE void push(const PackedVec3& impulse) {
    const PackedVec3 only = impulse.without_fourth();
    first_.set(first_.v + contact_.own_weight[0] * first_.inverse_mass() * only);
    second_.set(second_.v + contact_.own_weight[1] * second_.inverse_mass() * only);
    partners_.push(only);
  }

 private:
  const EdgeContact& contact_;
  HeldVelocity first_, second_;
  HeldPartners<EdgeContact> partners_;
};

}  // namespace stiction
