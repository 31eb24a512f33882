// SPDX-License-Identifier: BSD-3-Clause
#include "solver/response/pair_normal_force.h"

#include <algorithm>
#include <span>

#include "solver/contact/held_velocities.h"
#include "solver/lanes/lane_width.h"
#include "solver/response/contact_load.h"

namespace stiction {

namespace {

bool corrects(const PairOptions& options) {
  return STICTION_HAS_POST_CORRECTION && options.post_correction;
}

// So many contacts have their forces reckoned before any is put on its vertices: each reads inverse masses
// beside the velocities, and after a write it would wait for that.
constexpr std::size_t kAtOnce = 32;

// What the vertices tell of themselves.
struct Vertices {
  const Real* load;
  const Velocity* velocity;

  Real load_of(std::int32_t v) const { return load[static_cast<std::size_t>(v)]; }
  Real inverse_mass(std::int32_t v) const {
    return velocity[static_cast<std::size_t>(v)].inverse_mass;
  }
  // N/m, 1/kg.
  Real share(std::int32_t v) const { return load_of(v) * inverse_mass(v); }
};

Real own_share(const Vertices& vertices, const PairContact& contact) {
  return vertices.share(contact.vertex);
}

Real own_share(const Vertices& vertices, const EdgeContact& contact) {
  return contact.own_weight[0] * vertices.share(contact.vertex[0]) +
         contact.own_weight[1] * vertices.share(contact.vertex[1]);
}

template <class Contact>
Real harmonic_force(Real gain, Real dt, const Vertices& vertices, const Contact& contact) {
  Real inverse_mass = own_share(vertices, contact);
  for (int k = 0; k < 4; ++k) {
    inverse_mass += contact.weight[k] * vertices.share(contact.partner[k]);
  }
  return gain * contact.depth / (dt * dt * inverse_mass);
}

Real paper_force(Real dt, const Vertices& vertices, const PairContact& contact) {
  const auto c = [&](std::int32_t v) { return 1 / (1 + vertices.load_of(v)); };
  const auto inverse_mass = [&](std::int32_t v) { return vertices.inverse_mass(v); };
  Real partner_mass = 0.0;  // M
  bool partner_fixed = false;
  for (int k = 0; k < 4; ++k) {
    if (contact.weight[k] == 0.0) continue;
    const Real w = inverse_mass(contact.partner[k]);
    if (w == 0.0) {
      partner_fixed = true;
    } else {
      partner_mass += c(contact.partner[k]) * contact.weight[k] / w;
    }
  }
  const Real own = inverse_mass(contact.vertex);
  // γ m, with the limits of an infinite mass on either side.
  Real effective_mass = 0.0;
  if (own == 0.0) {
    effective_mass = partner_fixed ? 0 : partner_mass / c(contact.vertex);
  } else if (partner_fixed) {
    effective_mass = 1 / own;
  } else {
    const Real mass = 1 / own;
    effective_mass = mass * partner_mass / (c(contact.vertex) * mass + partner_mass);
  }
  return effective_mass * contact.depth / (dt * dt);
}

// fⁿ of a contact.
class PairForce {
 public:
  PairForce(const Options& options, const Vertices& vertices)
      : vertices_(vertices),
        dt_(options.dt()),
        gain_(options.pairs.harmonic_gain),
        harmonic_(options.pairs.gain == NormalGain::kHarmonic),
        transmitted_(corrects(options.pairs) ? Real(0.5) : Real(1)) {}

  Real operator()(const EdgeContact& contact) const {
    return contact.depth > 0.0 ? harmonic_force(gain_, dt_, vertices_, contact) : 0;
  }
  Real operator()(const PairContact& contact) const {
    if (contact.depth == 0.0) return 0.0;
    if (harmonic_) return harmonic_force(gain_, dt_, vertices_, contact);
    return transmitted_ * paper_force(dt_, vertices_, contact);
  }
  const Vertices& vertices() const { return vertices_; }

 private:
  Vertices vertices_;
  Real dt_, gain_;
  bool harmonic_;
  Real transmitted_;  // of the paper's force
};

// Puts the normal force of a contact on its vertex and, where bodies react, on its partners.
STICTION_LANES_INLINE void transmit(Real dt, bool react, const PairContact& contact,
                                    std::span<Velocity> velocity) {
  const PackedVec3 normal = PackedVec3::load(contact.normal.data());
  HeldVelocities(contact, velocity).push(dt * contact.normal_force * normal, react);
}

// Reckons the forces of contacts, and puts none on anything.
template <class Contacts>
void reckon(const PairForce& force, const Team* team, Contacts& contacts) {
  for_ranges(team, contacts.size(), kContactsToShare, [&](std::size_t begin, std::size_t end) {
    const PairForce own_force = force;
    for (std::size_t c = begin; c < end; ++c) contacts[c].normal_force = own_force(contacts[c]);
  });
}

// Puts forces that are reckoned on the vertices of contacts.
void transmit_all(const Options& options, Workspace& workspace, EdgeContacts& edges) {
  const int width = lane_width();
  workspace.edge_order.for_each_chunk(workspace.team, [&](std::size_t, const auto& chunk) {
    in_registers(
        width, [&]() __attribute__((always_inline)) {
          const std::span<Velocity> velocity = workspace.velocity;
          const ContactOrder::Sequence sequence = workspace.edge_order.sequence();
          const Real dt = options.dt();
          const EdgeContact* const contacts = edges.data();
          const auto [begin, end] = chunk;
          for (std::size_t place = begin; place < end; ++place) {
            const EdgeContact& contact = contacts[sequence.contact(place)];
            const PackedVec3 normal = PackedVec3::load(contact.normal.data());
            HeldEdgeVelocities(contact, velocity).push(dt * contact.normal_force * normal);
          }
        });
  });
}

// Reckons forces and puts them on the vertices while the records are near.
void reckon_and_transmit(const PairForce& force, const Options& options, Workspace& workspace,
                         PairContacts& pairs) {
  const int width = lane_width();
  workspace.pair_order.for_each_chunk(workspace.team, [&](std::size_t, const auto& chunk) {
    in_registers(
        width, [&]() __attribute__((always_inline)) {
          // Copies, of which the compiler knows that nothing else changes them.
          const PairForce own_force = force;
          const std::span<Velocity> velocity = workspace.velocity;
          const ContactOrder::Sequence sequence = workspace.pair_order.sequence();
          const Real dt = options.dt();
          const bool react = corrects(options.pairs);
          PairContact* const contacts = pairs.data();
          const auto [begin, end] = chunk;
          for (std::size_t next = begin; next < end;) {
            const std::size_t first = next;
            next = std::min(next + kAtOnce, end);
            for (std::size_t place = first; place < next; ++place) {
              sequence.ask_ahead(contacts, place, velocity.data(), own_force.vertices().load);
              PairContact& contact = contacts[sequence.contact(place)];
              contact.normal_force = own_force(contact);
            }
            for (std::size_t place = first; place < next; ++place) {
              transmit(dt, react, contacts[sequence.contact(place)], velocity);
            }
          }
        });
  });
}

}  // namespace

void pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                        const FrictionMemory& last_obstacles) {
  PairContacts& pairs = workspace.pairs;
  workspace.edge_order.make(workspace.edges, scene.topology.vertex_place);
  contact_loads(scene, options, last_obstacles, workspace);
  const Vertices vertices{workspace.load.data(), workspace.velocity.data()};
  const PairForce force(options, vertices);
  reckon(force, workspace.team, workspace.edges);
  transmit_all(options, workspace, workspace.edges);
  if (options.pairs.normals_first) {
    reckon_and_transmit(force, options, workspace, pairs);
  } else {
    reckon(force, workspace.team, pairs);
  }
}

void apply_normal_force(const Options& options, const PairContact& contact,
                        std::vector<Velocity>& velocity) {
  transmit(options.dt(), corrects(options.pairs), contact, velocity);
}

}  // namespace stiction
