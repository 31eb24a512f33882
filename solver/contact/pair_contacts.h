// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "solver/contact/contacts.h"

namespace stiction {

/// A two-sided contact: vertex i of one body inside a tetrahedron of another (or, where the scene
/// asks for it, of its own): what forces are made of, in two cache lines.
struct alignas(64) PairContact {
  std::int32_t vertex = -1;  ///< i
  std::int32_t partner[4] = {
      -1, -1, -1, -1};  ///< j: corners of Tᵢ (the fourth repeats the third) or of the tetrahedron
  std::int32_t other =
      -1;  ///< the penetrated body or its triangle, by which the key tells contacts of
           ///< a vertex apart: see PairKey in pair_options.h
  Real inverse_mass = 0.0;  ///< 1/mᵢ + Σⱼ hᵢⱼ²/mⱼ, 1/kg: of a force on i and its reaction on Tᵢ
  Real weight[4] = {0, 0, 0,
                    0};  ///< hᵢⱼ, dimensionless; they sum to 1 (the fourth is 0 for a triangle)
  Vec3 normal = Vec3::Zero();          ///< n, out of the penetrated body, unit
  Real depth = 0.0;                    ///< m, ≥ 0; 0 for a contact kept by hysteresis
  Vec3 friction_force = Vec3::Zero();  ///< f on i, N
  Real normal_force = 0.0;             ///< fⁿ: what the contact really puts on i, N

  ContactKey key() const { return contact_key(vertex, other); }
};
// A vector goes through a register with the number behind it (packed_vec3.h).
static_assert(offsetof(PairContact, depth) == offsetof(PairContact, normal) + sizeof(Vec3));
static_assert(offsetof(PairContact, normal_force) ==
              offsetof(PairContact, friction_force) + sizeof(Vec3));
static_assert(sizeof(PairContact) == 128);

/// What the partners of a contact were, to see whether they are others now.
class Partners {
 public:
  explicit Partners(const PairContact& contact) {
    std::memcpy(partner_, contact.partner, sizeof partner_);
  }
  bool are_of(const PairContact& contact) const {
    return std::memcmp(partner_, contact.partner, sizeof partner_) == 0;
  }

 private:
  std::int32_t partner_[4];
};

/// Where a two-sided contact stands: what detection and depth say of it, and no force asks for.
struct PairSite {
  std::int32_t element = -1;   ///< the tetrahedron that i is in, or was when it last was in one
  std::int32_t triangle = -1;  ///< nearest surface triangle Tᵢ of the penetrated body; that of
                               ///< the last step, −1 for none, before the depth phase
  bool open = false;           ///< outside every element: kept from the last step
  Real excess = 0.0;           ///< m, ≥ 0: how much deeper it stands, not answered yet
};

/// Pair contacts of one step, in the order of their keys, each with its site. These lie apart, since in
/// large scenes a step waits for the memory of the records, and passes over them some seven times.
class PairContacts {
 public:
  using value_type = PairContact;

  PairContacts() = default;
  explicit PairContacts(std::size_t count) : contact_(count), site_(count) {}

  std::size_t size() const { return contact_.size(); }
  bool empty() const { return contact_.empty(); }
  PairContact* data() { return contact_.data(); }
  const PairContact* data() const { return contact_.data(); }
  PairContact& operator[](std::size_t c) { return contact_[c]; }
  const PairContact& operator[](std::size_t c) const { return contact_[c]; }
  PairContact& front() { return contact_.front(); }
  const PairContact& front() const { return contact_.front(); }
  PairContact& back() { return contact_.back(); }
  auto begin() { return contact_.begin(); }
  auto begin() const { return contact_.begin(); }
  auto end() { return contact_.end(); }
  auto end() const { return contact_.end(); }

  PairSite& site(std::size_t c) { return site_[c]; }
  const PairSite& site(std::size_t c) const { return site_[c]; }
  /// Of a contact that is one of these.
  PairSite& site_of(const PairContact& contact) { return site_[place_of(contact)]; }
  const PairSite& site_of(const PairContact& contact) const { return site_[place_of(contact)]; }

  void clear() { resize(0); }
  void resize(std::size_t count) {
    if (count != size()) remembered = same_order = 0;
    contact_.resize(count);
    site_.resize(count);
  }
  /// Those that are `unwanted(contact)` go; the others keep their order.
  template <class Unwanted>
  void drop(const Unwanted& unwanted) {
    std::size_t left = 0;
    for (std::size_t c = 0; c < size(); ++c) {
      if (unwanted(contact_[c])) continue;
      contact_[left] = contact_[c];
      site_[left++] = site_[c];
    }
    resize(left);
  }

  /// The serial number of the PairGeometry that says of all these, and of no other, where they stand; 0:
  /// none, as when any is put in another's place.
  std::uint64_t remembered = 0;

  /// A number of its own in the process for the keys of these, in their order, and all that they act on, which
  /// copies share: lists of the same number need not be compared. 0: none, as when any is another now.
  std::uint64_t same_order = 0;

 private:
  std::size_t place_of(const PairContact& contact) const {
    return static_cast<std::size_t>(&contact - contact_.data());
  }

  std::vector<PairContact> contact_;
  std::vector<PairSite> site_;
};

}  // namespace stiction
