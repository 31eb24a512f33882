// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/crossing_edges.h"

#include <algorithm>

#include "solver/depth/depth.h"
#include "solver/depth/open_limits.h"
#include "solver/detection/detect_pairs.h"
#include "solver/detection/edge_pair.h"
#include "solver/detection/lasting.h"
#include "solver/detection/pair_candidates.h"

namespace stiction {

namespace {

// In mean edges: a crossing that is deeper when it is first seen is one of another kind.
constexpr Real kDeepest = 1e-2;

// In mean edges: far above round-off, so that no crossing falls between two edges in one line.
constexpr Real kOnJoint = by_precision(1e-9, 1e-5);

// Distance of a crossing from the nearest corner over its depth: where bodies rest on each other a
// corner is farther away than they are deep; of a corner that is put down on a face, beside which
// edges cross sideways, it is nearer.
constexpr Real kFarther = 10.0;

// Cosine of the angle to the normal within which edges must near each other to touch near a corner.
constexpr Real kNearing = 0.3;

// Depth of a crossing over how far the edges have neared each other in the step: 1 if they touched
// in it, and as much again for the step before, in which they may have met beyond the corner.
constexpr Real kJustNow = 2.0;

// The frames of edges, each made when it is first asked for.
class EdgeFrames {
 public:
  EdgeFrames(const Topology& topology, PairSearch& search) : topology_(topology), search_(search) {
    ++search.edge_calls;
    search.edge_frame.resize(topology.sharp_edge.size());
    search.edge_framed_at.resize(topology.sharp_edge.size(), 0);
  }
  const PairSearch::EdgeFrame& operator()(std::int32_t edge) const {
    const auto e = static_cast<std::size_t>(edge);
    if (search_.edge_framed_at[e] != search_.edge_calls) {
      search_.edge_framed_at[e] = search_.edge_calls;
      search_.edge_frame[e] = frame_of(search_.predicted, topology_.sharp_edge[e]);
    }
    return search_.edge_frame[e];
  }

 private:
  const Topology& topology_;
  PairSearch& search_;
};

struct Found {
  ContactKey key;
  std::int32_t a, b;
  EdgeCrossing crossing;
};

// One edge crosses another body in two directions at once where that body has a corner: the one
// that is the deeper is an artefact of straight lines. Says of which crossings that is so.
class Outdone {
 public:
  // `all` in the order of their keys, so that those of one edge a stand together.
  Outdone(const Topology& topology, const std::vector<Found>& all)
      : topology_(topology), all_(all) {
    for (const Found& found : all) by_b_.push_back(&found);
    std::stable_sort(by_b_.begin(), by_b_.end(),
                     [](const Found* one, const Found* other) { return one->b < other->b; });
  }

  bool operator()(const Found& found) const {
    const auto of_a =
        std::equal_range(all_.begin(), all_.end(), found,
                         [](const Found& one, const Found& other) { return one.a < other.a; });
    const auto of_b =
        std::equal_range(by_b_.begin(), by_b_.end(), &found,
                         [](const Found* one, const Found* other) { return one->b < other->b; });
    return std::any_of(of_a.first, of_a.second,
                       [&](const Found& other) {
                         return body(other.b) == body(found.b) && outdoes(other, found);
                       }) ||
           std::any_of(of_b.first, of_b.second, [&](const Found* other) {
             return body(other->a) == body(found.a) && outdoes(*other, found);
           });
  }

 private:
  std::int32_t body(std::int32_t edge) const {
    return topology_.vertex_body[static_cast<std::size_t>(
        topology_.sharp_edge[static_cast<std::size_t>(edge)].vertex[0])];
  }
  static bool outdoes(const Found& other, const Found& found) {
    return other.crossing.gap > found.crossing.gap &&
           other.crossing.normal.dot(found.crossing.normal) < 0.5;
  }

  const Topology& topology_;
  const std::vector<Found>& all_;
  std::vector<const Found*> by_b_;
};

EdgeContact contact_of(const Scene& scene, const State& state, const Workspace& workspace,
                       const Found& found) {
  const Topology& topology = scene.topology;
  const auto& a = topology.sharp_edge[static_cast<std::size_t>(found.a)];
  const auto& b = topology.sharp_edge[static_cast<std::size_t>(found.b)];
  EdgeContact contact;
  contact.key = found.key;
  contact.own_weight[0] = 1 - found.crossing.along_a;
  contact.own_weight[1] = found.crossing.along_a;
  contact.normal = found.crossing.normal;
  contact.depth = std::max(Real(0), -found.crossing.gap);
  contact.element = b.element;
  const auto x = [&](std::int32_t v) -> const Vec3& {
    return state.position[static_cast<std::size_t>(v)].x;
  };
  Vec3 point = Vec3::Zero();
  const auto inverse_mass = [&](std::int32_t v) {
    return workspace.velocity[static_cast<std::size_t>(v)].inverse_mass;
  };
  for (int k = 0; k < 2; ++k) {
    contact.vertex[k] = a.vertex[k];
    point += contact.own_weight[k] * x(a.vertex[k]);
    contact.inverse_mass +=
        contact.own_weight[k] * contact.own_weight[k] * inverse_mass(a.vertex[k]);
  }
  const auto& corner = scene.elements[static_cast<std::size_t>(b.element)].vertex;
  const Vec4 weight = barycentric(point, x(corner[0]), x(corner[1]), x(corner[2]), x(corner[3]));
  for (int k = 0; k < 4; ++k) {
    contact.partner[k] = corner[k];
    contact.weight[k] = weight[k];
    contact.inverse_mass += weight[k] * weight[k] * inverse_mass(corner[k]);
  }
  return contact;
}

}  // namespace

bool with_edges(const Options& options) {
  return STICTION_HAS_EDGE_CONTACTS && options.pairs.edges &&
         options.pairs.gain == NormalGain::kHarmonic;
}

void crossing_edges(const Scene& scene, const Options& options, const State& state,
                    Workspace& workspace) {
  const Topology& topology = scene.topology;
  const std::vector<Vec3>& x = workspace.search.predicted;
  const Real deepest = kDeepest * topology.mean_edge;
  const OpenLimits limits(scene, options, state);
  const EndMargins lasts{-limits.border, -limits.border};
  const std::vector<ContactKey>& last = state.edge_friction.key;
  const auto was_apart = [&](const Found& pair) {
    std::vector<Vec3>& start = workspace.search.start;
    start.resize(state.position.size());
    for (const std::int32_t e : {pair.a, pair.b}) {
      const auto& edge = topology.sharp_edge[static_cast<std::size_t>(e)];
      for (const std::int32_t v :
           {edge.vertex[0], edge.vertex[1], edge.opposite[0], edge.opposite[1]}) {
        start[static_cast<std::size_t>(v)] = state.position[static_cast<std::size_t>(v)].x;
      }
    }
    EdgeCrossing before;
    return crossing_of(topology, start, pair.a, pair.b, before) && before.gap >= -deepest;
  };
  // Whether a crossing near a corner is one that the edges have made just now, by nearing each
  // other there or by sliding in over the corner: then it is no deeper than what they have come. A
  // corner that is put down on a face crosses the edges beside it too, but sideways, where it
  // hardly nears them; and a deeper one would throw the bodies apart, again and again.
  const auto came_in = [&](const Found& pair) {
    const auto travel = [&](std::int32_t e, Real along) -> Vec3 {
      const auto& edge = topology.sharp_edge[static_cast<std::size_t>(e)];
      const auto of = [&](int k) -> Vec3 {
        const auto v = static_cast<std::size_t>(edge.vertex[k]);
        return x[v] - state.position[v].x;
      };
      return (1 - along) * of(0) + along * of(1);
    };
    const Vec3 relative =
        travel(pair.a, pair.crossing.along_a) - travel(pair.b, pair.crossing.along_b);
    const Real nearing = -relative.dot(pair.crossing.normal);
    return nearing > kNearing * relative.norm() && -pair.crossing.gap <= kJustNow * nearing;
  };
  const EdgeFrames frame(topology, workspace.search);
  std::vector<Found> found;
  for (PairSearch::EdgePair& candidate : workspace.search.edge_candidate) {
    const double path =
        workspace.search.path[candidate.body_a] + workspace.search.path[candidate.body_b];
    if (path < candidate.apart_until) continue;
    const ContactKey key = candidate.key;
    Found pair{key, first_of(key), second_of(key), {}};
    const auto lies_within = [&](const EndMargins& margins) {
      const auto inside = [&](std::int32_t e, Real along) {
        return inside_ends(topology.sharp_edge[static_cast<std::size_t>(e)], frame(e).length, along,
                           margins) >= 0.0;
      };
      return inside(pair.a, pair.crossing.along_a) && inside(pair.b, pair.crossing.along_b);
    };
    LinePair lines;
    const bool apart = !meet(topology, x, pair.a, pair.b, lines, pair.crossing) ||
                       !lies_within(lasts) ||
                       !face(lines, frame(pair.a), frame(pair.b), pair.crossing);
    note_lasting(apart, path, candidate.apart, candidate.apart_until, [&] {
      const auto& edge = topology.sharp_edge[static_cast<std::size_t>(pair.a)];
      return apart_within(topology, x, pair.a, pair.b, lasts) -
             list_rounding(workspace.search, x[static_cast<std::size_t>(edge.vertex[0])].norm());
    });
    if (apart) continue;
    const Real gap = pair.crossing.gap;
    const auto touches = [&] {
      if (std::binary_search(last.begin(), last.end(), key)) return gap < limits.gap;
      if (!(gap < 0.0)) return false;
      const EndMargins begins{-kOnJoint * topology.mean_edge, std::min(deepest, kFarther * -gap)};
      return lies_within(begins) ? gap >= -deepest || was_apart(pair) : came_in(pair);
    };
    if (touches()) found.push_back(pair);
  }
  workspace.edges.clear();
  const Outdone outdone(topology, found);
  for (const Found& pair : found) {
    if (outdone(pair)) continue;
    const EdgeContact contact = contact_of(scene, state, workspace, pair);
    if (contact.inverse_mass == 0.0) continue;
    note_too_deep(topology, contact.vertex[0],
                  topology.element_body[static_cast<std::size_t>(contact.element)], contact.depth,
                  workspace.search.too_deep);
    workspace.edges.push_back(contact);
  }
}

}  // namespace stiction
