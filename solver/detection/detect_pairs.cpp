// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/detect_pairs.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "solver/detection/crossing_edges.h"
#include "solver/detection/edge_candidates.h"
#include "solver/detection/find_holders.h"
#include "solver/detection/outrun.h"
#include "solver/detection/pair_candidates.h"
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
  const FindHolders find(scene, last, options.tie_margin, search);
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
  if (!search.found_same) pairs.remembered = pairs.same_order = 0;
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
