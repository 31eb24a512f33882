// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/depth.h"

#include <algorithm>
#include <cmath>

#include "solver/depth/consistent_depth.h"
#include "solver/depth/face_choice.h"
#include "solver/detection/detect_pairs.h"
#include "solver/hash.h"

namespace stiction {

namespace {

using Triangle = Topology::Triangle;

// Detection left the element's corners as partners.
void set_partners(const Triangle& triangle, const Options& options, const State& state,
                  const Projection& projection, PairContact& contact) {
  if (options.pairs.weights == PairWeights::kTriangle) {
    for (int k = 0; k < 3; ++k) {
      contact.partner[k] = triangle.vertex[k];
      contact.weight[k] = projection.nearest.weight[k];
    }
    contact.partner[3] = triangle.vertex[2];
    contact.weight[3] = 0.0;
    return;
  }
  const auto x = [&](std::int32_t v) -> const Vec3& {
    return state.position[static_cast<std::size_t>(v)].x;
  };
  const auto& corner = contact.partner;
  const Vec4 weight =
      barycentric(x(contact.vertex), x(corner[0]), x(corner[1]), x(corner[2]), x(corner[3]));
  for (int k = 0; k < 4; ++k) contact.weight[k] = weight[k];
}

// In mean edges: an excess below the rounding of a position.
constexpr Real kNothing = round_off(1e-15);

// What of the contact's depth is not to be answered in this step, m; `last` is its triangle of the
// last step. A vertex that comes in through a side wall, behind a face that it can rest on, has not
// fallen to the depth at which it is found: closed in one step that depth d would throw it out at
// d/Δt, and the contact would be lost and found again for ever. So the face begins where the vertex
// is, and comes to its place by a tenth of the way in each step, which gives a hundredth of that
// energy. Of the border's margin, in which one contact comes and goes, a third is answered at once:
// with nothing the critical force of a row of boxes reads 0.075 % too much, with all of it 2 of 200
// poses don't rest.
Real excess_of(const Topology& topology, const std::vector<Vec3>& x, const PairGeometry& memory,
               const PairContact& contact, std::int32_t last, Real unexplained) {
  constexpr Real kRemains = 0.9;
  if (unexplained > 0.0) return std::min(unexplained, contact.depth);
  if (memory.excess.empty()) return 0.0;
  const auto found =
      std::lower_bound(memory.excess.begin(), memory.excess.end(), contact.key,
                       [](const auto& excess, ContactKey key) { return excess.body_key < key; });
  if (found == memory.excess.end() || found->body_key != contact.key ||
      !goes_on(topology, x, last, contact.triangle)) {
    return 0.0;
  }
  return std::min(kRemains * found->depth, contact.depth);
}

}  // namespace

void note_too_deep(const Topology& topology, std::int32_t vertex, std::int32_t body, Real depth,
                   PairSearch& search) {
  const auto own = static_cast<std::size_t>(topology.vertex_body[static_cast<std::size_t>(vertex)]);
  const Real width =
      std::min(topology.least_width[own], topology.least_width[static_cast<std::size_t>(body)]);
  if (depth <= kPassed * width || search.too_deep.depth > 0.0) return;
  search.too_deep = {vertex, body, depth, width};
}

void depths(const Scene& scene, const Options& options, const State& state, Workspace& workspace) {
  const std::vector<Vec3>& x = workspace.search.predicted;
  const double dt = options.time_step;
  const auto widest =
      static_cast<Real>(options.pairs.hysteresis * dt * dt *
                        scene.gravity.at(static_cast<double>(state.step) * dt).norm());
  const auto inverse_mass = [&](std::int32_t v) {
    return workspace.velocity[static_cast<std::size_t>(v)].inverse_mass;
  };
  const Real border = options.pairs.border_margin * scene.topology.mean_edge;
  std::size_t kept = 0;
  bool immovable = false;  // any contact that nothing can move
  // Contacts and groups are both in the order of their keys.
  auto group = workspace.search.group.begin();
  const auto last_group = workspace.search.group.end();
  for (std::size_t c = 0; c < workspace.pairs.size(); ++c) {
    PairContact& contact = workspace.pairs[c];
    while (group != last_group && group->key < contact.key) ++group;
    const bool known = group != last_group && group->key == contact.key;
    const Vec3& point = x[static_cast<std::size_t>(contact.vertex)];
    const bool open = contact.open;
    const auto resting = options.pairs.face == PairFace::kOpposed ? contact.vertex : -1;
    const Choice choice =
        choose_face(scene.topology, state, workspace.search, known ? &*group : nullptr, point,
                    contact, options.pairs.tie_margin, resting);
    const Projection& projection = choice.projection;
    if (projection.triangle < 0) continue;  // no number: nothing is nearest
    const std::int32_t last = contact.triangle;
    contact.triangle = projection.triangle;
    const Triangle& triangle = scene.topology.triangle[static_cast<std::size_t>(contact.triangle)];
    const Real distance = std::sqrt(projection.nearest.distance2);
    contact.normal = outward_normal(triangle, x);
    const Real height = contact.normal.dot(point - x[static_cast<std::size_t>(triangle.vertex[0])]);
    if (open) {
      // Kept above or below a face, or a hair beyond its border: beyond that it has left.
      if (!projection.nearest.inside &&
          projection.nearest.distance2 - height * height > border * border) {
        continue;
      }
      if (height >= widest) continue;
      if (-height >= widest && !goes_on(scene.topology, x, last, contact.triangle)) continue;
      contact.element = triangle.element;
      set_corners(scene.elements, contact);
      contact.depth = std::max(Real(0), -height);
    } else if (projection.nearest.inside || distance == 0.0) {
      contact.depth = distance;
    } else if (choice.passed_over) {
      contact.depth = std::max(Real(0), -height);
    } else {
      Vec3 foot = Vec3::Zero();
      for (int k = 0; k < 3; ++k) {
        foot += projection.nearest.weight[k] * x[static_cast<std::size_t>(triangle.vertex[k])];
      }
      contact.depth = distance;
      contact.normal = (foot - point) / distance;
    }
    if (resting >= 0) {
      note_too_deep(scene.topology, contact.vertex, second_of(contact.key), contact.depth,
                    workspace.search);
    }
    contact.excess = excess_of(scene.topology, x, state.pair_geometry, contact, last,
                               choice.unexplained - border / 3);
    contact.depth -= contact.excess;
    set_partners(triangle, options, state, projection, contact);
    contact.inverse_mass = inverse_mass(contact.vertex);
    for (int k = 0; options.pairs.friction_reaction && k < 4; ++k) {
      contact.inverse_mass +=
          contact.weight[k] * contact.weight[k] * inverse_mass(contact.partner[k]);
    }
    immovable = immovable || contact.inverse_mass == 0.0;
    if (kept != c) workspace.pairs[kept] = contact;
    ++kept;
  }
  workspace.pairs.resize(kept);
  if (options.pairs.depth == DepthRule::kConsistent) consistent_depths(scene, workspace);
  // A vertex that nothing can move on partners that nothing can move takes no force.
  if (immovable) {
    std::erase_if(workspace.pairs, [](const PairContact& c) { return c.inverse_mass == 0.0; });
  }
  if (options.pairs.depth_noise > 0.0) {
    for (PairContact& contact : workspace.pairs) {
      contact.depth *=
          1 + options.pairs.depth_noise * static_cast<Real>(even_noise(contact.key, state.step));
    }
  }
  if (options.pairs.key == PairKey::kTriangle) {
    for (PairContact& contact : workspace.pairs) {
      contact.key = contact_key(contact.vertex, static_cast<std::uint32_t>(contact.triangle));
    }
  }
}

void remember_pairs(const PairContacts& pairs, const Topology& topology, PairGeometry& memory) {
  memory.body_key.resize(pairs.size());
  memory.element.resize(pairs.size());
  memory.triangle.resize(pairs.size());
  memory.excess.clear();
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    const std::int32_t body = topology.element_body[static_cast<std::size_t>(pairs[c].element)];
    memory.body_key[c] = contact_key(pairs[c].vertex, body);
    memory.element[c] = pairs[c].element;
    memory.triangle[c] = pairs[c].triangle;
    if (pairs[c].excess > kNothing * topology.mean_edge) {
      memory.excess.push_back({memory.body_key[c], pairs[c].excess});
    }
  }
}

}  // namespace stiction
