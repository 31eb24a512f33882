// SPDX-License-Identifier: BSD-3-Clause
#include "solver/response/pair_normal_force.h"

#include "solver/feature.h"
#include "solver/mutation.h"

namespace stiction {

namespace {

bool corrects(const PairOptions& options) {
  return built_in(Feature::kPostCorrection) && options.post_correction;
}

// Σ over contacts of what each asks of its vertex and of its partners, per vertex.
void accumulate(const Workspace& workspace, bool count_vertex, bool count_kept,
                std::vector<double>& load) {
  for (const PairContact& contact : workspace.pairs) {
    if (contact.depth == 0.0 && !count_kept) continue;
    if (count_vertex) load[static_cast<std::size_t>(contact.vertex)] += 1.0;
    for (int k = 0; k < 4; ++k) {
      load[static_cast<std::size_t>(contact.partner[k])] += contact.weight[k];
    }
  }
}

void accumulate(const EdgeContacts& edges, bool count_kept, std::vector<double>& load) {
  for (const EdgeContact& contact : edges) {
    if (contact.depth == 0.0 && !count_kept) continue;
    for (int k = 0; k < 2; ++k) {
      load[static_cast<std::size_t>(contact.vertex[k])] += contact.own_weight[k];
    }
    for (int k = 0; k < 4; ++k) {
      load[static_cast<std::size_t>(contact.partner[k])] += contact.weight[k];
    }
  }
}

// Contacts with obstacles, of this step and, if kept ones count, those of the last that have just
// opened. Both lists are in the order of their keys.
void add_obstacles(Workspace& workspace, const FrictionMemory& last, bool count_kept) {
  for (const std::int32_t v : workspace.contacts.vertex) {
    workspace.load[static_cast<std::size_t>(v)] += 1.0;
  }
  if (!count_kept) return;
  auto now = workspace.contacts.key.begin();
  for (const ContactKey key : last.key) {
    while (now != workspace.contacts.key.end() && *now < key) ++now;
    if (now != workspace.contacts.key.end() && *now == key) continue;
    workspace.load[static_cast<std::size_t>(second_of(key))] += 1.0;
  }
}

// N/m of a vertex, 1/kg.
double share(const Workspace& workspace, std::int32_t v) {
  const auto p = static_cast<std::size_t>(v);
  return workspace.load[p] * workspace.velocity[p].inverse_mass;
}

double own_share(const Workspace& workspace, const PairContact& contact) {
  return share(workspace, contact.vertex);
}

double own_share(const Workspace& workspace, const EdgeContact& contact) {
  return contact.own_weight[0] * share(workspace, contact.vertex[0]) +
         contact.own_weight[1] * share(workspace, contact.vertex[1]);
}

template <class Contact>
double harmonic_force(const PairOptions& options, double dt, const Workspace& workspace,
                      const Contact& contact) {
  double inverse_mass = own_share(workspace, contact);
  for (int k = 0; k < 4; ++k) {
    inverse_mass += contact.weight[k] * share(workspace, contact.partner[k]);
  }
  return options.harmonic_gain * contact.depth / (dt * dt * inverse_mass);
}

double paper_force(double dt, const Workspace& workspace, const PairContact& contact) {
  const auto c = [&](std::int32_t v) {
    return 1.0 / (1.0 + workspace.load[static_cast<std::size_t>(v)]);
  };
  const auto inverse_mass = [&](std::int32_t v) {
    return workspace.velocity[static_cast<std::size_t>(v)].inverse_mass;
  };
  double partner_mass = 0.0;  // M
  bool partner_fixed = false;
  for (int k = 0; k < 4; ++k) {
    if (contact.weight[k] == 0.0) continue;
    const double w = inverse_mass(contact.partner[k]);
    if (w == 0.0) {
      partner_fixed = true;
    } else {
      partner_mass += c(contact.partner[k]) * contact.weight[k] / w;
    }
  }
  const double own = inverse_mass(contact.vertex);
  // γ m, with the limits of an infinite mass on either side.
  double effective_mass = 0.0;
  if (own == 0.0) {
    effective_mass = partner_fixed ? 0.0 : partner_mass / c(contact.vertex);
  } else if (partner_fixed) {
    effective_mass = 1.0 / own;
  } else {
    const double mass = 1.0 / own;
    effective_mass = mass * partner_mass / (c(contact.vertex) * mass + partner_mass);
  }
  return effective_mass * contact.depth / (dt * dt);
}

}  // namespace

void pair_normal_forces(const Scene& scene, const Options& options, Workspace& workspace,
                        const FrictionMemory& last_obstacles) {
  const bool harmonic = options.pairs.gain == NormalGain::kHarmonic;
  workspace.load.assign(static_cast<std::size_t>(scene.vertex_count()), 0.0);
  accumulate(workspace, harmonic, !harmonic || options.pairs.count_hysteresis, workspace.load);
  accumulate(workspace.edges, options.pairs.count_hysteresis, workspace.load);
  if (harmonic) add_obstacles(workspace, last_obstacles, options.pairs.count_hysteresis);
  if constexpr (kMutation == Mutation::kLoadUncounted) {
    workspace.load.assign(workspace.load.size(), harmonic ? 1.0 : 0.0);
  }
  for (PairContact& contact : workspace.pairs) {
    if (contact.depth == 0.0) {
      contact.normal_force = 0.0;
    } else if (harmonic) {
      contact.normal_force = harmonic_force(options.pairs, options.time_step, workspace, contact);
    } else {
      const double force = paper_force(options.time_step, workspace, contact);
      const double transmitted = kMutation == Mutation::kHalfLeftOut ? 1.0 : 0.5;
      contact.normal_force = corrects(options.pairs) ? transmitted * force : force;
    }
  }
  for (EdgeContact& contact : workspace.edges) {
    contact.normal_force =
        contact.depth > 0.0 ? harmonic_force(options.pairs, options.time_step, workspace, contact)
                            : 0.0;
    apply(options.time_step * contact.normal_force * contact.normal, contact, workspace.velocity);
  }
  if (!options.pairs.normals_first) return;
  for (const PairContact& contact : workspace.pairs) {
    apply_normal_force(options, contact, workspace.velocity);
  }
}

void apply(const Vec3& impulse, const EdgeContact& contact, std::vector<Velocity>& velocity) {
  for (int k = 0; k < 2; ++k) {
    Velocity& own = velocity[static_cast<std::size_t>(contact.vertex[k])];
    own.v += contact.own_weight[k] * own.inverse_mass * impulse;
  }
  const Vec3 reaction = kMutation == Mutation::kEdgeReaction ? Vec3(0.98 * impulse) : impulse;
  for (int k = 0; k < 4; ++k) {
    Velocity& other = velocity[static_cast<std::size_t>(contact.partner[k])];
    other.v -= contact.weight[k] * other.inverse_mass * reaction;
  }
}

void apply_normal_force(const Options& options, const PairContact& contact,
                        std::vector<Velocity>& velocity) {
  Vec3 impulse = options.time_step * contact.normal_force * contact.normal;
  Velocity& own = velocity[static_cast<std::size_t>(contact.vertex)];
  own.v += own.inverse_mass * impulse;
  if (!corrects(options.pairs)) return;
  if constexpr (kMutation == Mutation::kNormalReaction) impulse *= 0.98;
  for (int k = 0; k < 4; ++k) {
    Velocity& other = velocity[static_cast<std::size_t>(contact.partner[k])];
    other.v -= contact.weight[k] * other.inverse_mass * impulse;
  }
}

}  // namespace stiction
