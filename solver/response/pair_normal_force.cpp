// SPDX-License-Identifier: BSD-3-Clause
#include "solver/response/pair_normal_force.h"

#include "solver/response/contact_load.h"

namespace stiction {

namespace {

bool corrects(const PairOptions& options) {
  return STICTION_HAS_POST_CORRECTION && options.post_correction;
}

// N/m of a vertex, 1/kg.
Real share(const Workspace& workspace, std::int32_t v) {
  const auto p = static_cast<std::size_t>(v);
  return workspace.load[p] * workspace.velocity[p].inverse_mass;
}

Real own_share(const Workspace& workspace, const PairContact& contact) {
  return share(workspace, contact.vertex);
}

Real own_share(const Workspace& workspace, const EdgeContact& contact) {
  return contact.own_weight[0] * share(workspace, contact.vertex[0]) +
         contact.own_weight[1] * share(workspace, contact.vertex[1]);
}

template <class Contact>
Real harmonic_force(const PairOptions& options, Real dt, const Workspace& workspace,
                    const Contact& contact) {
  Real inverse_mass = own_share(workspace, contact);
  for (int k = 0; k < 4; ++k) {
    inverse_mass += contact.weight[k] * share(workspace, contact.partner[k]);
  }
  return options.harmonic_gain * contact.depth / (dt * dt * inverse_mass);
}

Real paper_force(Real dt, const Workspace& workspace, const PairContact& contact) {
  const auto c = [&](std::int32_t v) {
    return 1 / (1 + workspace.load[static_cast<std::size_t>(v)]);
  };
  const auto inverse_mass = [&](std::int32_t v) {
    return workspace.velocity[static_cast<std::size_t>(v)].inverse_mass;
  };
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

}  // namespace

void pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                        const FrictionMemory& last_obstacles) {
  const bool harmonic = options.pairs.gain == NormalGain::kHarmonic;
  workspace.pair_order.make(workspace.pairs, static_cast<std::size_t>(scene.vertex_count()));
  contact_loads(scene, options, last_obstacles, workspace);
  const auto set_force = [&](PairContact& contact) {
    if (contact.depth == 0.0) {
      contact.normal_force = 0.0;
    } else if (harmonic) {
      contact.normal_force = harmonic_force(options.pairs, options.dt(), workspace, contact);
    } else {
      const Real force = paper_force(options.dt(), workspace, contact);
      contact.normal_force = corrects(options.pairs) ? Real(0.5) * force : force;
    }
  };
  for_ranges(workspace.team, workspace.pairs.size(), kContactsToShare,
             [&](std::size_t begin, std::size_t end) {
               for (std::size_t c = begin; c < end; ++c) set_force(workspace.pairs[c]);
             });
  for (EdgeContact& contact : workspace.edges) {
    contact.normal_force =
        contact.depth > 0.0 ? harmonic_force(options.pairs, options.dt(), workspace, contact) : 0;
    apply_impulse(options.dt() * contact.normal_force * contact.normal, contact,
                  workspace.velocity);
  }
  if (!options.pairs.normals_first) return;
  workspace.pair_order.for_each_contact(workspace.team, [&](std::size_t c) {
    apply_normal_force(options, workspace.pairs[c], workspace.velocity);
  });
}

void apply_impulse(const Vec3& impulse, const EdgeContact& contact,
                   std::vector<Velocity>& velocity) {
  for (int k = 0; k < 2; ++k) {
    Velocity& own = velocity[static_cast<std::size_t>(contact.vertex[k])];
    own.v += contact.own_weight[k] * own.inverse_mass * impulse;
  }
  for (int k = 0; k < 4; ++k) {
    Velocity& other = velocity[static_cast<std::size_t>(contact.partner[k])];
    other.v -= contact.weight[k] * other.inverse_mass * impulse;
  }
}

void apply_normal_force(const Options& options, const PairContact& contact,
                        std::vector<Velocity>& velocity) {
  const Vec3 impulse = options.dt() * contact.normal_force * contact.normal;
  Velocity& own = velocity[static_cast<std::size_t>(contact.vertex)];
  own.v += own.inverse_mass * impulse;
  if (!corrects(options.pairs)) return;
  for (int k = 0; k < 4; ++k) {
    Velocity& other = velocity[static_cast<std::size_t>(contact.partner[k])];
    other.v -= contact.weight[k] * other.inverse_mass * impulse;
  }
}

}  // namespace stiction
