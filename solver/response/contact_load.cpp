// SPDX-License-Identifier: BSD-3-Clause
#include "solver/response/contact_load.h"

#include <algorithm>
#include <span>

#include "solver/prefetch.h"

namespace stiction {

namespace {

// Σ over contacts of a chunk of what each asks of its vertex and of its partners, per vertex.
void accumulate(const PairContacts& pairs, std::span<const std::int32_t> chunk, bool count_vertex,
                bool count_kept, std::vector<Real>& load) {
  const PairContact* const contacts = pairs.data();
  Real* const of_vertex = load.data();
  const auto at = [&](std::size_t k) -> const PairContact& {
    return contacts[static_cast<std::size_t>(chunk[k])];
  };
  const std::size_t ahead = lie_far_apart(pairs.size()) ? kAskedAhead : chunk.size();
  for (std::size_t k = 0; k < chunk.size(); ++k) {
    if (k + ahead < chunk.size()) ask_for(&at(k + ahead));
    const PairContact& contact = at(k);
    if (!count_kept && contact.depth == 0.0) continue;  // asked last: it is in another line
    if (count_vertex) of_vertex[static_cast<std::size_t>(contact.vertex)] += 1;
    for (int j = 0; j < 4; ++j) {
      of_vertex[static_cast<std::size_t>(contact.partner[j])] += contact.weight[j];
    }
  }
}

void accumulate(const EdgeContacts& edges, std::span<const std::int32_t> chunk, bool count_kept,
                std::vector<Real>& load) {
  for (const std::int32_t c : chunk) {
    const EdgeContact& contact = edges[static_cast<std::size_t>(c)];
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
    workspace.load[static_cast<std::size_t>(v)] += 1;
  }
  if (!count_kept) return;
  auto now = workspace.contacts.key.begin();
  for (const ContactKey key : last.key) {
    while (now != workspace.contacts.key.end() && *now < key) ++now;
    if (now != workspace.contacts.key.end() && *now == key) continue;
    workspace.load[static_cast<std::size_t>(second_of(key))] += 1;
  }
}

}  // namespace

void contact_loads(const Scene& scene, const Options& options, const FrictionMemory& last_obstacles,
                   Workspace& workspace) {
  const bool harmonic = options.pairs.gain == NormalGain::kHarmonic;
  const bool count_kept = options.pairs.count_hysteresis;
  const auto vertices = static_cast<std::size_t>(scene.vertex_count());
  workspace.load.resize(vertices);
  const auto clear = [&] {
    for_ranges(workspace.team, vertices, kVerticesToShare, [&](std::size_t begin, std::size_t end) {
      std::fill(workspace.load.data() + begin, workspace.load.data() + end, Real(0));
    });
  };
  workspace.pair_order.make(workspace.pairs, scene.topology.vertex_place, workspace.team, clear,
                            [&](const ContactOrder::Chunk& chunk) {
                              accumulate(workspace.pairs, workspace.pair_order.in_turn(chunk),
                                         harmonic, !harmonic || count_kept, workspace.load);
                            });
  workspace.edge_order.for_each_chunk(workspace.team, [&](std::size_t,
                                                          const ContactOrder::Chunk& chunk) {
    accumulate(workspace.edges, workspace.edge_order.in_turn(chunk), count_kept, workspace.load);
  });
  if (harmonic) add_obstacles(workspace, last_obstacles, count_kept);
}

}  // namespace stiction
