// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The contacts of a step, kind by kind, as the friction phase sees them.

#include <cstddef>
#include <span>
#include <vector>

#include "solver/contact/contact_order.h"
#include "solver/contact/held_velocities.h"
#include "solver/contact/slip.h"
#include "solver/options.h"
#include "solver/scene/scene.h"

namespace stiction::friction_phase {

// A side gives access to the contacts of one kind. It has
//   order, size()             of its contacts, and how many they are
//   Vector                    what its forces and slips are reckoned in
//   kInOrder                  whether its contacts come in the order of their keys
//   contact(place)            which stands there, and ask_ahead(place, velocity) for what comes later
//   keys()                    of all, in their order
//   normal(c), bound(c), inverse_mass(c, velocity): Δt w
//   force(c), set_force(c, f) friction, N
//   held(c, velocity)         the velocities that a contact acts on, and their slip()
//   push(force, held)         a force that is held for the step, on them
//   slip(c, velocity)         where they are only looked at

// What holds one contact's velocities where they are: in memory.
template <class Side>
struct InMemory {
  const Side& side;
  std::size_t c;
  std::span<Velocity> velocity;

  Vec3 slip() const { return side.slip(c, velocity); }
};

// The contacts with obstacles, as the sweep sees them.
template <class Friction>
struct ObstacleSide {
  const Scene& scene;
  Friction mu;
  Real dt;
  OneSidedContacts& contacts;
  const ContactOrder& order;

  using Vector = Vec3;
  static constexpr bool kInOrder = true;
  std::size_t size() const { return contacts.size(); }
  std::size_t contact(std::size_t place) const { return place; }
  void ask_ahead(std::size_t, std::span<const Velocity>) const {}
  const std::vector<ContactKey>& keys() const { return contacts.key; }
  Vec3 force(std::size_t c) const { return contacts.friction_force[c]; }
  void set_force(std::size_t c, const Vec3& force) const { contacts.friction_force[c] = force; }
  const HalfSpace& obstacle(std::size_t c) const {
    return scene.half_spaces[static_cast<std::size_t>(contacts.obstacle[c])];
  }
  const Vec3& normal(std::size_t c) const { return obstacle(c).normal; }
  Real bound(std::size_t c) const {
    return mu.against(obstacle(c), contacts.vertex[c], contacts.obstacle[c]) *
           contacts.normal_force[c];
  }
  Real inverse_mass(std::size_t c, std::span<const Velocity> velocity) const {
    return dt * velocity[static_cast<std::size_t>(contacts.vertex[c])].inverse_mass;
  }
  Vec3 slip(std::size_t c, std::span<const Velocity> velocity) const {
    const Vec3& v = velocity[static_cast<std::size_t>(contacts.vertex[c])].v;
    return tangential(v - contacts.obstacle_velocity[c], normal(c));
  }
  void push(const Vec3& force, const InMemory<ObstacleSide>& held) const {
    Velocity& own = held.velocity[static_cast<std::size_t>(contacts.vertex[held.c])];
    own.v += dt * own.inverse_mass * force;
  }
  InMemory<ObstacleSide> held(std::size_t c, std::span<Velocity> velocity) const {
    return {*this, c, velocity};
  }
};

// What contacts between bodies and of edges have in common: records whose vectors go through a register
// whole. All that a contact needs is in a copy of the side: what is written to records could be anything
// else as well, for all that the compiler knows.
template <class Contact>
class RecordSide {
 public:
  using Vector = PackedVec3;

  RecordSide(Real dt, std::span<Contact> contacts, const ContactOrder& contacts_order)
      : order(contacts_order), dt_(dt), contacts_(contacts.data()), size_(contacts.size()) {}

  std::size_t size() const { return size_; }
  const std::vector<ContactKey>& keys() const { return order.keys(); }
  STICTION_LANES_INLINE PackedVec3 force(std::size_t c) const {
    return PackedVec3::load(contacts_[c].friction_force.data());
  }
  STICTION_LANES_INLINE void set_force(std::size_t c, const PackedVec3& force) const {
    Real* const place = contacts_[c].friction_force.data();
    force.with_fourth(PackedVec3::load(place)).store(place);
  }
  STICTION_LANES_INLINE PackedVec3 normal(std::size_t c) const {
    return PackedVec3::load(contacts_[c].normal.data());
  }
  Real inverse_mass(std::size_t c, std::span<const Velocity>) const {
    return dt_ * contacts_[c].inverse_mass;
  }
  Vec3 slip(std::size_t c, std::span<const Velocity> velocity) const {
    return slip_of(contacts_[c], velocity);
  }

  const ContactOrder& order;

 protected:
  Real dt_;
  Contact* contacts_;
  std::size_t size_;
};

// The contacts between bodies.
template <class Friction>
class PairSide : public RecordSide<PairContact> {
 public:
  static constexpr bool kInOrder = false;

  PairSide(const Options& options, const Friction& mu, PairContacts& pairs,
           const ContactOrder& contacts_order)
      : RecordSide(options.dt(), pairs, contacts_order),
        mu_(mu),
        sequence_(contacts_order.sequence()),
        react_(options.pairs.friction_reaction),
        bounds_(options.pairs.literal_bound && options.pairs.gain == NormalGain::kPaper &&
                        options.pairs.post_correction
                    ? 2
                    : 1) {}

  std::size_t contact(std::size_t place) const { return sequence_.contact(place); }
  void ask_ahead(std::size_t place, std::span<const Velocity> velocity) const {
    sequence_.ask_ahead(contacts_, place, velocity.data());
  }
  Real bound(std::size_t c) const {
    const PairContact& contact = contacts_[c];
    return mu_.between(contact.vertex, contact.partner[0]) * bounds_ * contact.normal_force;
  }
  STICTION_LANES_INLINE HeldVelocities held(std::size_t c, std::span<Velocity> velocity) const {
    return HeldVelocities(contacts_[c], velocity);
  }
  STICTION_LANES_INLINE void push(const PackedVec3& force, HeldVelocities& held) const {
    held.push(dt_ * force, react_);
  }

 private:
  Friction mu_;
  ContactOrder::Sequence sequence_;
  bool react_;
  Real bounds_;  // of friction, in μ fⁿ
};

// The contacts of crossing edges.
template <class Friction>
class EdgeSide : public RecordSide<EdgeContact> {
 public:
  static constexpr bool kInOrder = false;

  EdgeSide(Real dt, const Friction& mu, EdgeContacts& edges, const ContactOrder& contacts_order)
      : RecordSide(dt, edges, contacts_order), mu_(mu), sequence_(contacts_order.sequence()) {}

  std::size_t contact(std::size_t place) const { return sequence_.contact(place); }
  void ask_ahead(std::size_t, std::span<const Velocity>) const {}
  Real bound(std::size_t c) const {
    const EdgeContact& contact = contacts_[c];
    return mu_.between(contact.vertex[0], contact.partner[0]) * contact.normal_force;
  }
  STICTION_LANES_INLINE HeldEdgeVelocities held(std::size_t c, std::span<Velocity> velocity) const {
    return HeldEdgeVelocities(contacts_[c], velocity);
  }
  STICTION_LANES_INLINE void push(const PackedVec3& force, HeldEdgeVelocities& held) const {
    held.push(dt_ * force);
  }

 private:
  Friction mu_;
  ContactOrder::Sequence sequence_;
};

}  // namespace stiction::friction_phase
