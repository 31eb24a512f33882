// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/detect_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/detection/crossing_edges.h"
#include "solver/detection/edge_candidates.h"
#include "solver/detection/holding.h"
#include "solver/detection/lasting.h"
#include "solver/detection/outrun.h"
#include "solver/detection/pair_candidates.h"
#include "solver/lanes/lane_width.h"
#include "solver/lanes/lanes.h"
#include "solver/prefetch.h"

namespace stiction {

namespace {

PairContact contact_at(const Scene& scene, ContactKey key, std::int32_t element) {
  PairContact contact;
  contact.vertex = first_of(key);
  contact.other = second_of(key);
  set_corners(scene.elements, element, contact);
  return contact;
}

// The candidate of one key that the vertex is deepest in, the lower number winning a tie; −1 for none.
std::int32_t deepest_candidate(const Scene& scene, const PairSearch& search,
                               const PairSearch::Group& group, int width) {
  const std::vector<Vec3>& x = search.predicted;
  const Vec3& point = x[static_cast<std::size_t>(first_of(group.key))];
  const auto corners_of = [&](std::int32_t element) -> const auto& {
    return scene.elements[static_cast<std::size_t>(element)].vertex;
  };
  // What the round-off of the weights lets in must not be beyond the outermost corner.
  const auto in_box = [&](std::int32_t element) {
    Box3 box;
    for (const std::int32_t v : corners_of(element)) box.extend(x[static_cast<std::size_t>(v)]);
    return box.contains(point);
  };
  std::int32_t found = -1;
  Real deepest = kOnBoundary;
  for (std::int32_t k = group.candidate_begin, count; k < group.candidate_end; k += count) {
    count = std::min(group.candidate_end - k, lanes_of(width));
    const std::int32_t* const candidate = &search.candidate[static_cast<std::size_t>(k)];
    const std::int32_t* corner[kMostLanes];
    Real weight[kMostLanes];
    for (int lane = 0; lane < count; ++lane) corner[lane] = corners_of(candidate[lane]);
    least_weights(point, x, corner, count, width, weight);
    for (int lane = 0; lane < count; ++lane) {
      if (!(found < 0 ? weight[lane] >= deepest : weight[lane] > deepest)) continue;
      if (!in_box(candidate[lane])) continue;
      found = candidate[lane];
      deepest = weight[lane];
    }
  }
  return found;
}

// What of the candidates of one key holds the vertex, −1 for none. `last`, where it was in the last step
// or −1, is tried first, and stays while the vertex is in the body and no weight in `last` is below
// −`margin`.
std::int32_t find_element(const Scene& scene, const PairSearch& search,
                          const PairSearch::Group& group, std::int32_t last, Real margin,
                          int width) {
  Real in_last = -std::numeric_limits<Real>::infinity();
  if (last >= 0) {
    const auto x = [&](std::int32_t v) -> const Vec3& {
      return search.predicted[static_cast<std::size_t>(v)];
    };
    const auto& v = scene.elements[static_cast<std::size_t>(last)].vertex;
    in_last = barycentric(x(first_of(group.key)), x(v[0]), x(v[1]), x(v[2]), x(v[3])).minCoeff();
  }
  if (in_last > kInside) return last;
  const std::int32_t found = deepest_candidate(scene, search, group, width);
  return found >= 0 && margin > 0.0 && in_last >= -margin ? last : found;
}

// For how long what the candidates say of the group's vertex lasts, m, `last` being where it was in the
// last step or −1, and `found` what holds it.
Real lasts_within(const Scene& scene, const PairSearch& search, const PairSearch::Group& group,
                  std::int32_t last, std::int32_t found) {
  const auto x = [&](std::int32_t v) -> const Vec3& {
    return search.predicted[static_cast<std::size_t>(v)];
  };
  const Vec3& point = x(first_of(group.key));
  const auto corners = [&](std::int32_t e) -> std::array<Vec3, 4> {
    const auto& v = scene.elements[static_cast<std::size_t>(e)].vertex;
    return {x(v[0]), x(v[1]), x(v[2]), x(v[3])};
  };
  const Real rounding = list_rounding(search, point.norm());
  if (found >= 0) return found == last ? held_within(point, corners(found)) - rounding : 0;
  Real least = last >= 0 ? clearance(point, corners(last)) : std::numeric_limits<Real>::infinity();
  for (std::int32_t k = group.candidate_begin; k < group.candidate_end; ++k) {
    const std::int32_t element = search.candidate[static_cast<std::size_t>(k)];
    least = std::min(least, clearance(point, corners(element)));
  }
  return least - rounding;
}

// What was found of a vertex that was with `last`, or with none (−1), as PairSearch::Group says it.
std::int32_t verdict_of(std::int32_t last, std::int32_t found) {
  return found >= 0 ? found : -2 - last;
}

// Tests the candidates of groups.
class Find {
 public:
  Find(const Scene& scene, const PairGeometry& last, Real margin, PairSearch& search)
      : scene_(scene), last_(last), margin_(margin), search_(search), width_(lane_width()) {
    search.holds.resize(search.group.size());
  }

  // Of those from `begin` to before `end`.
  void operator()(std::size_t begin, std::size_t end) const {
    if (begin == end) return;
    const auto first =
        std::lower_bound(last_.body_key.begin(), last_.body_key.end(), search_.group[begin].key);
    auto old = static_cast<std::size_t>(first - last_.body_key.begin());
    for (std::size_t g = begin; g < end; ++g) {
      PairSearch::Group& group = search_.group[g];
      while (old < last_.body_key.size() && last_.body_key[old] < group.key) ++old;
      const bool persists = old < last_.body_key.size() && last_.body_key[old] == group.key;
      const std::int32_t in = persists ? last_.element[old] : -1;
      search_.holds[g] = held_by(group, in, [&] { ask_ahead(old); });
    }
  }

  // Of all, where `holds` is of the last step, whose contacts are all remembered. Returns whether anything
  // else holds any vertex now.
  bool any_changes(const Team* team) const {
    const auto sleeps = [&](std::size_t g, double more) {
      const PairSearch::Group& group = search_.group[g];
      return group.verdict == search_.holds[g] &&
             paths(scene_.topology, search_, group.key) + more < group.holds_until;
    };
    wake(search_, search_.group.size(), sleeps, search_.group_awake);
    const std::vector<std::uint32_t>& awake = search_.group_awake.place;
    std::atomic<bool> any = false;
    for_ranges(team, awake.size(), kContactsToShare, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const std::uint32_t g = awake[k];
        PairSearch::Group& group = search_.group[g];
        const std::int32_t last = search_.holds[g];
        search_.holds[g] = held_by(group, last >= 0 ? last : open_in(group), [] {});
        if (search_.holds[g] != last) any = true;
      }
    });
    return any;
  }

 private:
  // The element that holds the group's vertex now, or −1, `in` being what did in the last step.
  template <class BeforeTest>
  std::int32_t held_by(PairSearch::Group& group, std::int32_t in, const BeforeTest& before) const {
    const double path = paths(scene_.topology, search_, group.key);
    if (path < group.holds_until && (group.verdict == in || group.verdict == verdict_of(in, -1))) {
      return group.verdict >= 0 ? in : -1;
    }
    before();
    const std::int32_t found = find_element(scene_, search_, group, in, margin_, width_);
    const std::int32_t verdict = verdict_of(in, found);
    const bool same = verdict == group.verdict;
    group.verdict = verdict;
    note_lasting(same, path, group.held, group.holds_until,
                 [&] { return lasts_within(scene_, search_, group, in, found); });
    return found;
  }

  // Where the contact of a group of which nothing holds the vertex was in the last step; −1 where there is none.
  std::int32_t open_in(const PairSearch::Group& group) const {
    if (group.verdict == verdict_of(-1, -1)) return -1;
    const auto at = std::lower_bound(last_.body_key.begin(), last_.body_key.end(), group.key);
    if (at == last_.body_key.end() || *at != group.key) return -1;
    return last_.element[static_cast<std::size_t>(at - last_.body_key.begin())];
  }

  // For what the test of contacts after one of the last step will read. Twice as far ahead as elsewhere:
  // less is done between.
  void ask_ahead(std::size_t old) const {
    if (old + 2 * kAskedAhead >= last_.element.size()) return;
    ask_for(&scene_.elements[static_cast<std::size_t>(last_.element[old + 2 * kAskedAhead])]);
    const std::size_t sooner = old + kAskedAhead;
    const std::int32_t next = last_.element[sooner];
    ask_for(&search_.predicted[static_cast<std::size_t>(first_of(last_.body_key[sooner]))]);
    for (const std::int32_t v : scene_.elements[static_cast<std::size_t>(next)].vertex) {
      ask_for(&search_.predicted[static_cast<std::size_t>(v)]);
    }
  }

  const Scene& scene_;
  const PairGeometry& last_;
  Real margin_;
  PairSearch& search_;
  int width_;
};

bool keeps_open(const PairOptions& options) { return options.hysteresis > 0.0; }
bool keeps_triangles(const PairOptions& options) {
  return keeps_open(options) || options.tie_margin > 0.0;
}

// Merges what is found with the contacts of the last step that have only just opened. Those are
// measured in the depth phase, which drops them when the gap is too wide.
class Merge {
 public:
  Merge(const Scene& scene, const PairSearch& search, const PairGeometry& last,
        const PairOptions& options)
      : elements_(scene.elements),
        search_(search),
        last_(last),
        keep_open_(keeps_open(options)),
        keep_triangle_(keeps_triangles(options)) {}

  // Calls add(key, element, triangle, open) for each contact, in the order of the keys, from the
  // group `begin` on (all before it, if it is the first) to before the group `end`.
  template <class Add>
  void operator()(std::size_t begin, std::size_t end, const Add& add) const {
    std::size_t old = begin == 0 ? 0 : first_of_last(search_.group[begin].key);
    const std::size_t old_end =
        end == search_.group.size() ? last_.body_key.size() : first_of_last(search_.group[end].key);
    const auto keep_open = [&] {
      if (keep_open_) add(last_.body_key[old], last_.element[old], last_.triangle[old], true);
    };
    for (std::size_t g = begin; g < end; ++g) {
      const ContactKey key = search_.group[g].key;
      for (; old < old_end && last_.body_key[old] < key; ++old) keep_open();
      const bool persists = old < old_end && last_.body_key[old] == key;
      const std::int32_t element = search_.holds[g];
      if (g + kAskedAhead < end && search_.holds[g + kAskedAhead] >= 0) {
        ask_for(&elements_[static_cast<std::size_t>(search_.holds[g + kAskedAhead])]);
      }
      if (element >= 0) {
        add(key, element, persists && keep_triangle_ ? last_.triangle[old] : -1, false);
      } else if (persists) {
        keep_open();
      }
      if (persists) ++old;
    }
    for (; old < old_end; ++old) keep_open();
  }

 private:
  std::size_t first_of_last(ContactKey key) const {
    const auto first = std::lower_bound(last_.body_key.begin(), last_.body_key.end(), key);
    return static_cast<std::size_t>(first - last_.body_key.begin());
  }

  const std::vector<Element>& elements_;
  const PairSearch& search_;
  const PairGeometry& last_;
  bool keep_open_, keep_triangle_;
};

// Puts a contact in place c of the list, where that of the last step may stand already: most do, and
// nothing is written then. Returns whether it did.
bool put(const Scene& scene, ContactKey key, std::int32_t element, std::int32_t triangle, bool open,
         PairContacts& pairs, std::size_t c) {
  PairSite& site = pairs.site(c);
  if (pairs[c].key() != key || site.element != element) {
    pairs[c] = contact_at(scene, key, element);
    site = {.element = element, .triangle = triangle, .open = open};
    return false;
  }
  if (site.triangle != triangle) site.triangle = triangle;
  if (site.open != open) site.open = open;
  return true;
}

// Whether `pairs` are those that detection found in the last step, as it did in the one before, and all that
// is remembered of it: where the same holds each vertex they are those of this step.
bool stand_as_found(const PairGeometry& last, const PairOptions& options, const PairSearch& search,
                    const PairContacts& pairs) {
  return search.found_same && pairs.remembered != 0 && pairs.remembered == last.serial &&
         options.key == PairKey::kBody && keeps_triangles(options);
}

// Finds contacts, and puts them in the places of those of the last step.
void renew_pairs(const Scene& scene, const PairGeometry& last, const PairOptions& options,
                 const Team* team, PairSearch& search, PairContacts& pairs) {
  const Find find(scene, last, options.tie_margin, search);
  const bool tested = stand_as_found(last, options, search, pairs);
  if (tested && !find.any_changes(team)) return;
  if (!tested) search.group_awake.steps = 0;  // tests of all may find otherwise of any
  // Groups are merged while what was found of them is in the nearest cache.
  constexpr std::size_t kBlock = 256;
  const Merge merge(scene, search, last, options);
  const std::size_t groups = search.group.size();
  const auto found = [&](std::size_t begin, std::size_t end, const auto& add) {
    do {
      const std::size_t next = std::min(begin + kBlock, end);
      if (!tested) find(begin, next);
      merge(begin, next, add);
      begin = next;
    } while (begin < end);
  };
  std::atomic<bool> same = true;
  const auto put_next = [&](std::size_t& next) {
    return [&](ContactKey key, std::int32_t element, std::int32_t triangle, bool open) {
      if (!put(scene, key, element, triangle, open, pairs, next++)) same = false;
    };
  };
  const std::size_t ranges = ranges_of(team, groups, kContactsToShare), before = pairs.size();
  std::size_t count = 0;
  if (ranges == 1) {
    const auto add = put_next(count);
    found(0, groups, [&](ContactKey key, std::int32_t element, std::int32_t triangle, bool open) {
      if (count == pairs.size()) pairs.resize(count + 1);
      add(key, element, triangle, open);
    });
    pairs.resize(count);
  } else {
    // Counted first, so that each range knows where its contacts come.
    std::vector<std::size_t> first(ranges + 1, 0);
    for_each_range(team, groups, ranges, [&](std::size_t r, std::size_t begin, std::size_t end) {
      std::size_t of_range = 0;
      found(begin, end, [&](ContactKey, std::int32_t, std::int32_t, bool) { ++of_range; });
      first[r + 1] = of_range;
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    count = first[ranges];
    pairs.resize(count);
    for_each_range(team, groups, ranges, [&](std::size_t r, std::size_t begin, std::size_t end) {
      std::size_t next = first[r];
      merge(begin, end, put_next(next));
    });
  }
  search.found_same = same && count == before;
  if (!search.found_same) pairs.remembered = 0;
}

// Of another scene, or with other options, what is known of faces and edges is forgotten, and the contacts
// of the last step say nothing of this one's.
void begin(const Scene& scene, const PairOptions& options, Workspace& workspace) {
  PairSearch& search = workspace.search;
  const PairSearch::KnownFor now{options.face,       options.weights,       options.key,
                                 options.tie_margin, options.border_margin, options.hysteresis};
  if (now == search.known_for && search.scene == scene.serial) return;
  search.known_for = now;
  search.edges_listed = false;
  search.found_same = false;
  for (PairSearch::Group& group : search.group) group.stays_on = -1;
  workspace.pairs.clear();
}

}  // namespace

void set_corners(const std::vector<Element>& elements, std::int32_t element, PairContact& contact) {
  const auto& corner = elements[static_cast<std::size_t>(element)].vertex;
  std::copy(corner, corner + 4, contact.partner);
}

void detect_pairs(const Scene& scene, const Options& options, const State& state,
                  Workspace& workspace) {
  PairSearch& search = workspace.search;
  begin(scene, options.pairs, workspace);
  const bool renewed =
      update_candidates(scene, options.dt(), state, workspace.velocity, workspace.team, search);
  if (renewed) {
    search.found_same = false;
    if (options.pairs.face == PairFace::kOpposed) {
      note_outrun(scene, options.dt(), workspace.velocity, search);
    }
  }
  if (!with_edges(options)) {
    search.edges_listed = false;
  } else if (renewed || !search.edges_listed) {
    find_edge_candidates(scene, search);
  }
  renew_pairs(scene, state.pair_geometry, options.pairs, workspace.team, search, workspace.pairs);
}

}  // namespace stiction
