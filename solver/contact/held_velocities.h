// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

#include "solver/contact/pair_contacts.h"
#include "solver/contact/slip.h"
#include "solver/lanes/packed_vec3.h"
#include "solver/state.h"

namespace stiction {

/// `tangential` in one register.
STICTION_LANES_INLINE PackedVec3 tangential(const PackedVec3& v, const PackedVec3& n) {
  return v - n.dot(v) * n;
}

/// The velocities that a contact between bodies acts on, in registers from when they are read until
/// they have changed. With the bits of `slip_of` and of sums vertex by vertex.
class HeldVelocities {
 public:
  STICTION_LANES_INLINE HeldVelocities(const PairContact& contact, std::span<Velocity> velocity)
      : contact_(contact), velocity_(velocity.data()), own_(PackedVec3::load(at(contact.vertex))) {
    of_partners([&](auto k) __attribute__((always_inline)) {
      partner_[k] = PackedVec3::load(at(contact_.partner[k]));
    });
  }

  /// Of the vertex over its partners, tangential, m/s.
  STICTION_LANES_INLINE PackedVec3 slip() const {
    PackedVec3 v = own_;
    of_partners([&](auto k)
                    __attribute__((always_inline)) { v -= contact_.weight[k] * partner_[k]; });
    return tangential(v, PackedVec3::load(contact_.normal.data()));
  }

  /// Puts an impulse, N s, on the vertex and, where bodies react, the opposite one on its partners.
  STICTION_LANES_INLINE void push(const PackedVec3& impulse, bool react) {
    const PackedVec3 change = impulse.with_fourth(PackedVec3::Zero());  // inverse masses stay
    own_ += own_.fourths() * change;
    own_.store(at(contact_.vertex));
    if (!react) return;
    // Of a triangle the fourth repeats the third with a weight of 0: the third's is written last.
    of_partners([&](auto k) __attribute__((always_inline)) {
      partner_[3 - k] -= contact_.weight[3 - k] * partner_[3 - k].fourths() * change;
      partner_[3 - k].store(at(contact_.partner[3 - k]));
    });
  }

 private:
  STICTION_LANES_INLINE Velocity* at(std::int32_t v) const {
    return velocity_ + static_cast<std::size_t>(v);
  }

  // work(k) for k = 0 … 3, constants: what a loop indexes goes by way of memory.
  template <class Work>
  STICTION_LANES_INLINE static void of_partners(const Work& work) {
    [&]<std::size_t... k>(std::index_sequence<k...>) __attribute__((always_inline)) {
      (work(std::integral_constant<std::size_t, k>()), ...);
    }
    (std::make_index_sequence<4>());
  }

  const PairContact& contact_;
  Velocity* velocity_;
  PackedVec3 own_, partner_[4];
};

}  // namespace stiction
