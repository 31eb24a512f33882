// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/find_holders.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

#include "solver/detection/detect_pairs.h"
#include "solver/detection/holding.h"
#include "solver/detection/lasting.h"
#include "solver/detection/pair_candidates.h"
#include "solver/lanes/lane_width.h"
#include "solver/lanes/lanes.h"
#include "solver/prefetch.h"

namespace stiction {

namespace {

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
// or −1, with the least weight `in_last` now, stays while the vertex is in the body and that is not below
// −`margin`.
std::int32_t find_element(const Scene& scene, const PairSearch& search,
                          const PairSearch::Group& group, std::int32_t last, Real in_last,
                          Real margin, int width) {
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

}  // namespace

// Groups that must be tested, and were in an element in the last step: that one is tried first, of as many
// groups at a time as a register has lanes.
class FindHolders::Tests {
 public:
  explicit Tests(const FindHolders& find) : find_(find) {}

  // What holds the vertex of a group, which was in the element `in` or none, −1, in the last step: at the
  // end at the latest `holds` says it. Returns whether it must be tested.
  bool add(std::size_t g, std::int32_t in) {
    const PairSearch::Group& group = find_.search_.group[g];
    const double path = paths(find_.scene_.topology, find_.search_, group.key);
    if (path < group.holds_until && (group.verdict == in || group.verdict == verdict_of(in, -1))) {
      set(g, group.verdict >= 0 ? in : -1);
      return false;
    }
    if (in < 0) {
      test(g, in, path, -std::numeric_limits<Real>::infinity());
      return true;
    }
    group_[count_] = g;
    in_[count_] = in;
    path_[count_] = path;
    if (++count_ == lanes_of(find_.width_)) test_all();
    return true;
  }

  // Returns whether `holds` has changed for any group.
  bool end() {
    test_all();
    return changed_;
  }

 private:
  void test_all() {
    if (count_ == 0) return;
    std::int32_t vertex[kMostLanes];
    const std::int32_t* corner[kMostLanes];
    Real least[kMostLanes];
    for (int k = 0; k < count_; ++k) {
      vertex[k] = first_of(find_.search_.group[group_[k]].key);
      corner[k] = find_.scene_.elements[static_cast<std::size_t>(in_[k])].vertex;
    }
    least_weights(vertex, find_.search_.predicted, corner, count_, find_.width_, least);
    for (int k = 0; k < count_; ++k) test(group_[k], in_[k], path_[k], least[k]);
    count_ = 0;
  }

  void test(std::size_t g, std::int32_t in, double path, Real in_last) {
    PairSearch::Group& group = find_.search_.group[g];
    const std::int32_t found =
        find_element(find_.scene_, find_.search_, group, in, in_last, find_.margin_, find_.width_);
    const std::int32_t verdict = verdict_of(in, found);
    const bool same = verdict == group.verdict;
    group.verdict = verdict;
    note_lasting(same, path, group.held, group.holds_until,
                 [&] { return lasts_within(find_.scene_, find_.search_, group, in, found); });
    set(g, found);
  }

  void set(std::size_t g, std::int32_t found) {
    std::int32_t& holds = find_.search_.holds[g];
    changed_ = changed_ || holds != found;
    holds = found;
  }

  const FindHolders& find_;
  int count_ = 0;
  std::size_t group_[kMostLanes]{};
  std::int32_t in_[kMostLanes]{};
  double path_[kMostLanes]{};
  bool changed_ = false;
};

FindHolders::FindHolders(const Scene& scene, const PairGeometry& last, Real margin,
                         PairSearch& search)
    : scene_(scene), last_(last), margin_(margin), search_(search), width_(lane_width()) {
  search.holds.resize(search.group.size());
}

void FindHolders::operator()(std::size_t begin, std::size_t end) const {
  if (begin == end) return;
  const auto first =
      std::lower_bound(last_.body_key.begin(), last_.body_key.end(), search_.group[begin].key);
  auto old = static_cast<std::size_t>(first - last_.body_key.begin());
  Tests tests(*this);
  for (std::size_t g = begin; g < end; ++g) {
    const ContactKey key = search_.group[g].key;
    while (old < last_.body_key.size() && last_.body_key[old] < key) ++old;
    const bool persists = old < last_.body_key.size() && last_.body_key[old] == key;
    if (tests.add(g, persists ? last_.element[old] : -1)) ask_ahead(old);
  }
  tests.end();
}

bool FindHolders::any_changes(const Team* team) const {
  const auto sleeps = [&](std::size_t g, double more) {
    const PairSearch::Group& group = search_.group[g];
    return group.verdict == search_.holds[g] &&
           paths(scene_.topology, search_, group.key) + more < group.holds_until;
  };
  wake(search_, search_.group.size(), sleeps, search_.group_awake);
  const std::vector<std::uint32_t>& awake = search_.group_awake.place;
  std::atomic<bool> any = false;
  for_ranges(team, awake.size(), kContactsToShare, [&](std::size_t begin, std::size_t end) {
    Tests tests(*this);
    for (std::size_t k = begin; k < end; ++k) {
      const std::int32_t last = search_.holds[awake[k]];
      tests.add(awake[k], last >= 0 ? last : open_in(search_.group[awake[k]]));
    }
    if (tests.end()) any = true;
  });
  return any;
}

// Where the contact of a group of which nothing holds the vertex was in the last step; −1 where there is none.
std::int32_t FindHolders::open_in(const PairSearch::Group& group) const {
  if (group.verdict == verdict_of(-1, -1)) return -1;
  const auto at = std::lower_bound(last_.body_key.begin(), last_.body_key.end(), group.key);
  if (at == last_.body_key.end() || *at != group.key) return -1;
  return last_.element[static_cast<std::size_t>(at - last_.body_key.begin())];
}

// For what the test of contacts after one of the last step will read. Twice as far ahead as elsewhere:
// less is done between.
void FindHolders::ask_ahead(std::size_t old) const {
  if (old + 2 * kAskedAhead >= last_.element.size()) return;
  ask_for(&scene_.elements[static_cast<std::size_t>(last_.element[old + 2 * kAskedAhead])]);
  const std::size_t sooner = old + kAskedAhead;
  const std::int32_t next = last_.element[sooner];
  ask_for(&search_.predicted[static_cast<std::size_t>(first_of(last_.body_key[sooner]))]);
  for (const std::int32_t v : scene_.elements[static_cast<std::size_t>(next)].vertex) {
    ask_for(&search_.predicted[static_cast<std::size_t>(v)]);
  }
}

}  // namespace stiction
