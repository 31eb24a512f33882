// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/depth.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

#include "solver/depth/consistent_depth.h"
#include "solver/depth/face_choice.h"
#include "solver/depth/same_face.h"
#include "solver/depth/staying.h"
#include "solver/detection/detect_pairs.h"
#include "solver/detection/pair_candidates.h"
#include "solver/hash.h"
#include "solver/lanes/lane_width.h"
#include "solver/lanes/lanes.h"
#include "solver/prefetch.h"

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

// What of the contact's depth is not to be answered in this step, m; `last` and `now` are its triangles
// of the last step and of this one. A vertex that comes in through a side wall, behind a face that it
// can rest on, has not fallen to the depth at which it is found: closed in one step that depth d would
// throw it out at d/Δt, and the contact would be lost and found again for ever. So the face begins
// where the vertex is, and comes to its place by a tenth of the way in each step, which gives a
// hundredth of that energy. Of the border's margin, in which one contact comes and goes, a third is answered at once:
// with nothing the critical force of a row of boxes reads 0.075 % too much, with all of it 2 of 200
// poses don't rest.
Real excess_of(const Topology& topology, const std::vector<Vec3>& x, const PairGeometry& memory,
               const PairContact& contact, std::int32_t last, std::int32_t now, Real unexplained) {
  constexpr Real kRemains = 0.9;
  if (unexplained > 0.0) return std::min(unexplained, contact.depth);
  if (memory.excess.empty()) return 0.0;
  const auto found =
      std::lower_bound(memory.excess.begin(), memory.excess.end(), contact.key(),
                       [](const auto& excess, ContactKey key) { return excess.body_key < key; });
  if (found == memory.excess.end() || found->body_key != contact.key() ||
      !goes_on(topology, x, last, now)) {
    return 0.0;
  }
  return std::min(kRemains * found->depth, contact.depth);
}

constexpr std::int32_t kDropped = -1;  // in place of the vertex of a contact that is none any more

// What ranges of contacts tell of all.
struct Found {
  bool dropped = false;         // any that is no contact
  bool immovable = false;       // any that nothing can move
  bool acts_elsewhere = false;  // any on other partners than it had
  PairSearch::TooDeep too_deep;
  // Those that are not measured yet: their triangles are to be listed first, by one thread alone.
  struct Unlisted {
    std::size_t contact, group;
  };
  std::vector<Unlisted> unlisted;

  void note_depth(const Topology& topology, const PairContact& contact) {
    PairSearch::TooDeep one;
    note_too_deep(topology, contact.vertex, contact.other, contact.depth, one);
    add(one);
  }

  // The first in the order of the keys, whichever is heard of first.
  void add(const PairSearch::TooDeep& other) {
    const auto key = [](const PairSearch::TooDeep& one) {
      return contact_key(one.vertex, one.body);
    };
    if (other.depth > 0.0 && (too_deep.depth == 0.0 || key(other) < key(too_deep))) {
      too_deep = other;
    }
  }

  void add(const Found& other) {
    dropped = dropped || other.dropped;
    immovable = immovable || other.immovable;
    acts_elsewhere = acts_elsewhere || other.acts_elsewhere;
    add(other.too_deep);
    unlisted.insert(unlisted.end(), other.unlisted.begin(), other.unlisted.end());
  }
};

// Of one contact.
class Measure {
 public:
  Measure(const Scene& scene, const Options& options, const State& state, Workspace& workspace)
      : scene_(scene),
        options_(options),
        state_(state),
        workspace_(workspace),
        limits_(scene, options, state),
        asks_until_(asks_until(workspace.pairs.size())) {}

  const OpenLimits& limits() const { return limits_; }

  // For what contacts after the c-th will read, of what lies far apart.
  void ask_ahead(const PairContacts& pairs, std::size_t c) const {
    if (c >= asks_until_) return;
    const auto& triangles = scene_.topology.triangle;
    const auto at = [](std::int32_t k) { return static_cast<std::size_t>(k); };
    const std::int32_t far = pairs.site(c + kAskedAhead).triangle;
    if (far >= 0) ask_for(&triangles[at(far)]);
    const PairContact& next = pairs[c + kAskedAhead / 2];
    const std::size_t own = at(next.vertex);
    ask_for(&state_.position[own]);
    ask_for(&workspace_.search.predicted[own]);
    for (const std::int32_t v : next.partner) ask_for(&state_.position[at(v)]);
    const std::int32_t near = pairs.site(c + kAskedAhead / 2).triangle;
    if (near < 0) return;
    for (const std::int32_t v : triangles[at(near)].vertex) {
      ask_for(&workspace_.search.predicted[at(v)]);
    }
  }

  // Fills in the contact; false if it is none. `group` is that of its key, or null.
  bool operator()(PairContact& contact, PairSite& site, PairSearch::Group* group,
                  Found& found) const {
    const std::vector<Vec3>& x = workspace_.search.predicted;
    const Vec3& point = x[static_cast<std::size_t>(contact.vertex)];
    const bool open = site.open;
    const auto resting = options_.pairs.face == PairFace::kOpposed ? contact.vertex : -1;
    const Choice choice = choose_face(scene_.topology, state_, workspace_.search, group, point,
                                      site, options_.pairs.tie_margin, resting);
    const Projection& projection = choice.projection;
    if (projection.triangle < 0) return false;  // no number: nothing is nearest
    const std::int32_t last = site.triangle;
    site.triangle = projection.triangle;
    const Triangle& triangle = scene_.topology.triangle[static_cast<std::size_t>(site.triangle)];
    const Real distance = std::sqrt(projection.nearest.distance2);
    contact.normal = outward_normal(triangle, x);
    const Real height = contact.normal.dot(point - x[static_cast<std::size_t>(triangle.vertex[0])]);
    if (open) {
      // Kept above or below a face, or a hair beyond its border: beyond that it has left.
      if (!projection.nearest.inside &&
          projection.nearest.distance2 - height * height > limits_.border * limits_.border) {
        return false;
      }
      if (height >= limits_.gap) return false;
      if (-height >= limits_.gap && !goes_on(scene_.topology, x, last, site.triangle)) {
        return false;
      }
      site.element = triangle.element;
      set_corners(scene_.elements, site.element, contact);
      contact.depth = std::max(Real(0), -height);
    } else if (projection.nearest.inside || distance == 0.0) {
      contact.depth = distance;
    } else if (choice.passed_over) {
      contact.depth = std::max(Real(0), -height);
    } else {
      Vec3 foot = projection.nearest.weight[0] * x[static_cast<std::size_t>(triangle.vertex[0])];
      for (int k = 1; k < 3; ++k) {
        foot += projection.nearest.weight[k] * x[static_cast<std::size_t>(triangle.vertex[k])];
      }
      contact.depth = distance;
      contact.normal = (foot - point) / distance;
    }
    if (resting >= 0) found.note_depth(scene_.topology, contact);
    site.excess = excess_of(scene_.topology, x, state_.pair_geometry, contact, last, site.triangle,
                            choice.unexplained - limits_.border / 3);
    contact.depth -= site.excess;
    set_partners(triangle, options_, state_, projection, contact);
    // A vertex on an element that it is a corner of, as one that folds may come to, puts on itself what
    // it puts on its partners.
    if (std::count(contact.partner, contact.partner + 4, contact.vertex) > 0) return false;
    contact.inverse_mass = inverse_mass(contact.vertex);
    for (int k = 0; options_.pairs.friction_reaction && k < 4; ++k) {
      contact.inverse_mass +=
          contact.weight[k] * contact.weight[k] * inverse_mass(contact.partner[k]);
    }
    return true;
  }

 private:
  Real inverse_mass(std::int32_t v) const {
    return scene_.inverse_mass[static_cast<std::size_t>(v)];
  }

  const Scene& scene_;
  const Options& options_;
  const State& state_;
  Workspace& workspace_;
  OpenLimits limits_;
  std::size_t asks_until_;  // of the contacts
};

std::vector<PairSearch::Group>::iterator first_group(std::vector<PairSearch::Group>& groups,
                                                     ContactKey key) {
  return std::lower_bound(
      groups.begin(), groups.end(), key,
      [](const PairSearch::Group& group, ContactKey of) { return group.key < of; });
}

// Measures the contacts of ranges, in batches where they may have stayed on their faces.
class RangesOfDepths {
 public:
  RangesOfDepths(const Measure& measure, const Scene& scene, const Options& options,
                 const State& state, Workspace& workspace)
      : measure_(measure),
        scene_(scene),
        options_(options.pairs),
        state_(state),
        workspace_(workspace),
        width_(lane_width()),
        // What is not answered yet of a depth is rare, and looked up one at a time.
        most_(state.pair_geometry.excess.empty() ? lanes_of(width_) : 0) {}

  // One more range. Leaves those aside whose triangles are to be listed, unless there is no team.
  void measure(std::size_t begin, std::size_t end) {
    PairContacts& pairs = workspace_.pairs;
    std::vector<PairSearch::Group>& groups = workspace_.search.group;
    const bool lists = workspace_.team == nullptr;
    if (begin == end) return;
    // Contacts and groups are both in the order of their keys.
    auto group = first_group(groups, pairs[begin].key());
    for (std::size_t c = begin; c < end; ++c) {
      PairContact& contact = pairs[c];
      PairSite& site = pairs.site(c);
      measure_.ask_ahead(pairs, c);
      while (group != groups.end() && group->key < contact.key()) ++group;
      const bool known = group != groups.end() && group->key == contact.key();
      if (known && !lists && is_to_list(scene_.topology, site.element, *group)) {
        found_.unlisted.push_back({c, static_cast<std::size_t>(group - groups.begin())});
        continue;
      }
      if (!(known && most_ > 0 && put_in_batch(contact, site, *group))) {
        measure_one(contact, site, known ? &*group : nullptr);
      }
      if (batch_.count == most_) measure_batch();
    }
    measure_batch();
  }
  // Of all of them.
  const Found& found() const { return found_; }

 private:
  bool put_in_batch(PairContact& contact, PairSite& site, PairSearch::Group& group) {
    const PairSearch& search = workspace_.search;
    const bool stays = stays_on_face(scene_.topology, options_, search, site, group);
    if (!stays && !may_stay_on_face(site, group)) return false;
    if (stays) {
      if (site.triangle != group.stays_on) site.triangle = group.stays_on;
    } else {  // it will be asked whether others are as near
      ask_for(&search.reference[static_cast<std::size_t>(contact.vertex)]);
    }
    batch_.add(scene_.topology, contact, site, group, stays);
    return true;
  }

  void measure_one(PairContact& contact, PairSite& site, PairSearch::Group* group) {
    const Partners before(contact);
    if (!measure_(contact, site, group, found_)) {
      contact.vertex = kDropped;
      found_.dropped = true;
      return;
    }
    if (contact.inverse_mass == 0.0) found_.immovable = true;
    if (!before.are_of(contact)) found_.acts_elsewhere = true;
    if (group != nullptr && most_ > 0) {
      note_staying(scene_.topology, options_, workspace_.search, site, *group);
    }
  }

  void measure_batch() {
    if (batch_.count == 0) return;
    const unsigned left = measure_on_same_face(scene_, options_, state_, workspace_,
                                               measure_.limits(), width_, batch_);
    if (batch_.acts_elsewhere) found_.acts_elsewhere = true;
    for (int k = 0; k < batch_.count; ++k) {
      PairContact& contact = *batch_.contact[k];
      if ((left >> k & 1U) != 0) {
        measure_one(contact, *batch_.site[k], batch_.group[k]);
        continue;
      }
      if (options_.face == PairFace::kOpposed) found_.note_depth(scene_.topology, contact);
      if (contact.inverse_mass == 0.0) found_.immovable = true;
      if ((batch_.to_note() >> k & 1U) != 0) {
        note_staying(scene_.topology, options_, workspace_.search, *batch_.site[k],
                     *batch_.group[k]);
      }
    }
    batch_.clear();
  }

  const Measure& measure_;
  const Scene& scene_;
  const PairOptions& options_;
  const State& state_;
  Workspace& workspace_;
  int width_, most_;  // of registers, in doubles; contacts in a batch
  FaceBatch batch_;
  Found found_;
};

// Measures all.
Found measure_all(const Scene& scene, const Options& options, const State& state,
                  Workspace& workspace) {
  PairContacts& pairs = workspace.pairs;
  const Measure measure(scene, options, state, workspace);
  Found all;
  std::mutex of_all;
  const auto measure_some = [&](const auto& ranges) {
    RangesOfDepths depths(measure, scene, options, state, workspace);
    ranges(depths);
    const std::lock_guard lock(of_all);
    all.add(depths.found());
  };
  for_ranges(workspace.team, pairs.size(), kContactsToShare,
             [&](std::size_t begin, std::size_t end) {
               measure_some([&](RangesOfDepths& depths) { depths.measure(begin, end); });
             });
  if (all.unlisted.empty()) return all;
  const std::vector<Found::Unlisted> listed = std::exchange(all.unlisted, {});
  for (const auto [c, group] : listed) {
    list_nearest(scene.topology, pairs.site(c).element, workspace.search.group[group],
                 workspace.search);
  }
  for_ranges(workspace.team, listed.size(), kContactsToShare,
             [&](std::size_t begin, std::size_t end) {
               measure_some([&](RangesOfDepths& depths) {
                 for (std::size_t k = begin; k < end; ++k) {
                   depths.measure(listed[k].contact, listed[k].contact + 1);
                 }
               });
             });
  return all;
}

}  // namespace

void note_too_deep(const Topology& topology, std::int32_t vertex, std::int32_t body, Real depth,
                   PairSearch::TooDeep& too_deep) {
  if (depth <= kPassed * topology.thinnest) return;  // as nearly all
  const auto own = static_cast<std::size_t>(topology.vertex_body[static_cast<std::size_t>(vertex)]);
  const Real width =
      std::min(topology.least_width[own], topology.least_width[static_cast<std::size_t>(body)]);
  if (depth <= kPassed * width || too_deep.depth > 0.0) return;
  too_deep = {vertex, body, depth, width};
}

void depths(const Scene& scene, const Options& options, const State& state, Workspace& workspace) {
  static std::atomic<std::uint64_t> last_order = 0;
  PairContacts& pairs = workspace.pairs;
  const Found all = measure_all(scene, options, state, workspace);
  if (workspace.search.too_deep.depth == 0.0) workspace.search.too_deep = all.too_deep;
  if (all.dropped) {
    pairs.drop([](const PairContact& c) { return c.vertex == kDropped; });
  }
  if (options.pairs.depth == DepthRule::kConsistent) {
    consistent_depths(scene, options.pairs, workspace);
  }
  // A vertex that nothing can move on partners that nothing can move takes no force.
  if (all.immovable) {
    pairs.drop([](const PairContact& c) { return c.inverse_mass == 0.0; });
  }
  if (options.pairs.depth_noise > 0.0) {
    for (PairContact& contact : workspace.pairs) {
      contact.depth *=
          1 + options.pairs.depth_noise * static_cast<Real>(even_noise(contact.key(), state.step));
    }
  }
  if (options.pairs.key == PairKey::kTriangle) {
    for (PairContact& contact : workspace.pairs) {
      contact.other = workspace.pairs.site_of(contact).triangle;
    }
  }
  const bool may_be_others = all.acts_elsewhere || options.pairs.key == PairKey::kTriangle;
  if (may_be_others || pairs.same_order == 0) pairs.same_order = ++last_order;
}

}  // namespace stiction
