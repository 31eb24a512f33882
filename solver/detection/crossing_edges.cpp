// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/crossing_edges.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <span>

#include "solver/depth/depth.h"
#include "solver/depth/open_limits.h"
#include "solver/detection/edge_lanes.h"
#include "solver/detection/edge_pair.h"
#include "solver/detection/lasting.h"
#include "solver/detection/pair_candidates.h"
#include "solver/lanes/lane_width.h"
#include "solver/parallel/team.h"

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

using Touch = PairSearch::EdgeTouch;

// One edge crosses another body in two directions at once where that body has a corner: the one
// that is the deeper is an artefact of straight lines. Marks those that are, of all in the order of
// their keys.
void mark_outdone(const Topology& topology, PairSearch& search) {
  std::vector<Touch>& all = search.edge_touch;
  const auto body = [&](std::int32_t edge) {
    return topology.vertex_body[static_cast<std::size_t>(
        topology.sharp_edge[static_cast<std::size_t>(edge)].vertex[0])];
  };
  // Each with those behind it that share an edge, which `at` brings together, and are with the same body.
  const auto compare = [&](const auto& shared, const auto& other, const auto& at) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      Touch& one = at(j);
      for (std::size_t k = j + 1; k < all.size() && shared(at(k).key) == shared(one.key); ++k) {
        Touch& two = at(k);
        if (body(other(one.key)) != body(other(two.key))) continue;
        if (!(one.crossing.normal.dot(two.crossing.normal) < 0.5)) continue;
        one.outdone = one.outdone || one.crossing.gap < two.crossing.gap;
        two.outdone = two.outdone || two.crossing.gap < one.crossing.gap;
      }
    }
  };
  compare(first_of, second_of, [&](std::size_t k) -> Touch& { return all[k]; });
  std::vector<std::uint64_t>& by_b = search.touch_by_b;
  const auto has_key = [](const Touch& touch, ContactKey key) { return touch.key == key; };
  // In most steps they are those of the last.
  if (!std::equal(all.begin(), all.end(), search.touch_key.begin(), search.touch_key.end(),
                  has_key)) {
    search.touch_key.clear();
    by_b.clear();
    for (const Touch& touch : all) {
      const auto b = static_cast<std::uint32_t>(second_of(touch.key));
      by_b.push_back(std::uint64_t{b} << 32 | by_b.size());
      search.touch_key.push_back(touch.key);
    }
    std::sort(by_b.begin(), by_b.end());
  }
  compare(second_of, first_of, [&](std::size_t k) -> Touch& {
    return all[static_cast<std::size_t>(by_b[k] & 0xffffffff)];
  });
}

EdgeContact contact_of(const Topology& topology, const Touch& touch) {
  const auto& a = topology.sharp_edge[static_cast<std::size_t>(first_of(touch.key))];
  const auto& b = topology.sharp_edge[static_cast<std::size_t>(second_of(touch.key))];
  EdgeContact contact;
  contact.key = touch.key;
  std::copy(std::begin(a.vertex), std::end(a.vertex), contact.vertex);
  contact.own_weight[0] = 1 - touch.crossing.along_a;
  contact.own_weight[1] = touch.crossing.along_a;
  contact.normal = touch.crossing.normal;
  contact.depth = std::max(Real(0), -touch.crossing.gap);
  contact.element = b.element;
  return contact;
}

// Of both bodies, m.
double path_of(const PairSearch& search, const PairSearch::EdgePair& pair) {
  return search.path[pair.body_a] + search.path[pair.body_b];
}

// Tests a part of the candidates of a step, several side by side.
class EdgeTest {
 public:
  EdgeTest(const Scene& scene, const Options& options, const State& state, PairSearch& search,
           PairSearch::EdgePart& part)
      : topology_(scene.topology),
        state_(state),
        search_(search),
        part_(part),
        deepest_(kDeepest * scene.topology.mean_edge),
        limits_(scene, options, state),
        width_(lane_width()) {}

  // Leaves those of the candidates awake in begin … end − 1 that touch in `part.touch`.
  void run(std::size_t begin, std::size_t end) {
    part_.touch.clear();
    for (std::size_t k = begin; k < end; ++k) {
      PairSearch::EdgePair& candidate = search_.edge_candidate[search_.edge_awake.place[k]];
      if (path_of(search_, candidate) < candidate.apart_until) continue;
      const auto lane = static_cast<std::size_t>(batch_.count++);
      asked_[lane] = &candidate;
      batch_.a[lane] = first_of(candidate.key);
      batch_.b[lane] = second_of(candidate.key);
      if (batch_.count == lanes_of(width_)) test_batch();
    }
    if (batch_.count > 0) test_batch();
  }

 private:
  void test_batch() {
    const unsigned crossing =
        cross_side_by_side(topology_, search_.predicted, limits_.border, width_, batch_);
    for (int k = 0; k < batch_.count; ++k) {
      const auto lane = static_cast<std::size_t>(k);
      PairSearch::EdgePair& pair = *asked_[lane];
      // Farther off than a contact that has opened may be, they don't touch whether they did or not.
      const bool apart = (crossing >> k & 1U) == 0 || batch_.crossing[lane].gap > limits_.gap;
      note_lasting(apart, path_of(search_, pair), pair.apart, pair.apart_until, [&] {
        const std::int32_t a = first_of(pair.key), b = second_of(pair.key);
        const auto v = static_cast<std::size_t>(edge(a).vertex[0]);
        return apart_within(topology_, search_.predicted, a, b, {-limits_.border, -limits_.border},
                            limits_.gap) -
               list_rounding(search_, search_.predicted[v].norm());
      });
      if (!apart && touches(lane)) {
        part_.touch.push_back({pair.key, batch_.crossing[lane]});
      }
    }
    batch_.count = 0;
  }

  bool touches(std::size_t lane) {
    const ContactKey key = asked_[lane]->key;
    const EdgeCrossing& crossing = batch_.crossing[lane];
    const std::vector<ContactKey>& last = state_.edge_friction.key;
    if (std::binary_search(last.begin(), last.end(), key)) return crossing.gap < limits_.gap;
    if (!(crossing.gap < 0.0)) return false;
    const EndMargins begins{-kOnJoint * topology_.mean_edge,
                            std::min(deepest_, kFarther * -crossing.gap)};
    const bool within =
        inside_ends(edge(batch_.a[lane]), batch_.length_a[lane], crossing.along_a, begins) >= 0 &&
        inside_ends(edge(batch_.b[lane]), batch_.length_b[lane], crossing.along_b, begins) >= 0;
    return within ? crossing.gap >= -deepest_ || was_apart(key) : came_in(key, crossing);
  }

  bool was_apart(ContactKey key) {
    std::vector<Vec3>& start = part_.start;
    start.resize(state_.position.size());
    for (const std::int32_t e : {first_of(key), second_of(key)}) {
      for (const std::int32_t v :
           {edge(e).vertex[0], edge(e).vertex[1], edge(e).opposite[0], edge(e).opposite[1]}) {
        start[static_cast<std::size_t>(v)] = state_.position[static_cast<std::size_t>(v)].x;
      }
    }
    EdgeCrossing before;
    return crossing_of(topology_, start, first_of(key), second_of(key), before) &&
           before.gap >= -deepest_;
  }

  // Whether a crossing near a corner is one that the edges have made just now, by nearing each
  // other there or by sliding in over the corner: then it is no deeper than what they have come. A
  // corner that is put down on a face crosses the edges beside it too, but sideways, where it
  // hardly nears them; and a deeper one would throw the bodies apart, again and again.
  bool came_in(ContactKey key, const EdgeCrossing& crossing) const {
    const auto travel = [&](std::int32_t e, Real along) -> Vec3 {
      const auto of = [&](int k) -> Vec3 {
        const auto v = static_cast<std::size_t>(edge(e).vertex[k]);
        return search_.predicted[v] - state_.position[v].x;
      };
      return (1 - along) * of(0) + along * of(1);
    };
    const Vec3 relative =
        travel(first_of(key), crossing.along_a) - travel(second_of(key), crossing.along_b);
    const Real nearing = -relative.dot(crossing.normal);
    return nearing > kNearing * relative.norm() && -crossing.gap <= kJustNow * nearing;
  }

  const Topology::SharpEdge& edge(std::int32_t e) const {
    return topology_.sharp_edge[static_cast<std::size_t>(e)];
  }
  const Topology& topology_;
  const State& state_;
  PairSearch& search_;
  PairSearch::EdgePart& part_;
  Real deepest_;
  OpenLimits limits_;
  int width_;
  EdgeBatch batch_;
  PairSearch::EdgePair* asked_[kMostLanes];
};

// With fewer candidates in a part, what it takes to wake a thread is more than it does.
constexpr std::size_t kCandidatesToShare = 256;

// Leaves the candidates that touch in `search.edge_touch`, in the order of their keys.
void find_touches(const Scene& scene, const Options& options, const State& state,
                  Workspace& workspace) {
  PairSearch& search = workspace.search;
  const auto sleeps = [&](std::size_t c, double more) {
    const PairSearch::EdgePair& candidate = search.edge_candidate[c];
    return path_of(search, candidate) + more < candidate.apart_until;
  };
  wake(search, search.edge_candidate.size(), sleeps, search.edge_awake);
  const std::size_t count = search.edge_awake.place.size();
  const std::size_t parts = ranges_of(workspace.team, count, kCandidatesToShare);
  if (search.edge_part.size() < parts) search.edge_part.resize(parts);
  for_each_range(workspace.team, count, parts,
                 [&](std::size_t k, std::size_t begin, std::size_t end) {
                   EdgeTest(scene, options, state, search, search.edge_part[k]).run(begin, end);
                 });
  if (parts == 1) {
    std::swap(search.edge_touch, search.edge_part[0].touch);
    return;
  }
  search.edge_touch.clear();
  for (std::size_t k = 0; k < parts; ++k) {
    const std::vector<Touch>& touch = search.edge_part[k].touch;
    search.edge_touch.insert(search.edge_touch.end(), touch.begin(), touch.end());
  }
}

}  // namespace

bool with_edges(const Options& options) {
  return STICTION_HAS_EDGE_CONTACTS && options.pairs.edges &&
         options.pairs.gain == NormalGain::kHarmonic;
}

void crossing_edges(const Scene& scene, const Options& options, const State& state,
                    Workspace& workspace) {
  const Topology& topology = scene.topology;
  PairSearch& search = workspace.search;
  find_touches(scene, options, state, workspace);
  EdgeContacts& contacts = workspace.edges;
  mark_outdone(topology, search);
  search.touch_counts.clear();
  for (std::size_t k = 0; k < search.edge_touch.size(); ++k) {
    if (!search.edge_touch[k].outdone) search.touch_counts.push_back(k);
  }
  contacts.resize(search.touch_counts.size());
  std::atomic<bool> any_immovable = false;
  for_ranges(workspace.team, contacts.size(), kContactsToShare,
             [&](std::size_t begin, std::size_t end) {
               for (std::size_t c = begin; c < end; ++c) {
                 contacts[c] = contact_of(topology, search.edge_touch[search.touch_counts[c]]);
               }
               const auto range = std::span(contacts).subspan(begin, end - begin);
               set_partners(scene, state, workspace.velocity, lane_width(), range);
               for (const EdgeContact& contact : range) {
                 if (contact.inverse_mass == 0.0) any_immovable = true;
               }
             });
  if (any_immovable) {
    std::erase_if(contacts, [](const EdgeContact& contact) { return contact.inverse_mass == 0.0; });
  }
  for (const EdgeContact& contact : contacts) {
    note_too_deep(topology, contact.vertex[0],
                  topology.element_body[static_cast<std::size_t>(contact.element)], contact.depth,
                  search.too_deep);
  }
}

}  // namespace stiction
