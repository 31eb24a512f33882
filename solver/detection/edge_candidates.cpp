// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/edge_candidates.h"

#include <algorithm>
#include <cstddef>

#include "solver/detection/boxes.h"
#include "solver/detection/pair_candidates.h"
#include "solver/lanes/in_registers.h"

namespace stiction {

namespace {

// So few edges of a body are near another that wider registers would be filled by half.
constexpr int kSideBySide = 4;

// Edges are numbered body by body, and meetings are in the order of their bodies: so pairs come in the
// order of their keys, made anew or kept.
class EdgeLists {
 public:
  EdgeLists(const Topology& topology, PairSearch& search)
      : topology_(topology), search_(search), all_(!search.edges_listed) {
    search_.old_edge_candidate.swap(search_.edge_candidate);
    search_.edge_candidate.clear();
    search_.edge_box.reserve(topology_.sharp_edge.size());
    for (std::size_t b = 0; b < search_.overlap.size(); ++b) {
      if (all_ || search_.renewed[b]) bound(edges_of(static_cast<std::int32_t>(b)));
    }
  }

  // Lists the pairs of a body with later ones, of its meetings from `begin` to before `end`.
  template <int Bytes>
  STICTION_LANES_INLINE void list(std::size_t begin, std::size_t end) {
    search_.edge_meeting.clear();
    search_.near_edge.clear();
    const std::int32_t body = search_.meeting[begin].body;
    const Range edges = edges_of(body);
    for (std::size_t m = begin; m < end; ++m) {
      const PairSearch::Meeting& with = search_.meeting[m];
      const Range others = edges_of(with.other);
      if (with.other <= body || edges.empty() || others.empty()) continue;
      PairSearch::EdgeMeeting meeting{.of = &with,
                                      .keeps = !all_ && !is_renewed(search_, body, with.other)};
      if (!meeting.keeps) list_near<Bytes>(others, meeting);
      search_.edge_meeting.push_back(meeting);
    }
    if (search_.edge_meeting.empty()) return;
    for (std::size_t edge = edges.begin; edge < edges.end; ++edge) {
      const Box3 box = search_.edge_box[edge];
      for (const PairSearch::EdgeMeeting& meeting : search_.edge_meeting) {
        if (meeting.keeps) {
          keep(edge, edges_of(meeting.of->other));
        } else if (!apart(box, meeting.of->common)) {
          add<Bytes>(edge, box, meeting);
        }
      }
    }
  }

 private:
  struct Range {
    std::size_t begin, end;
    bool empty() const { return begin == end; }
  };

  Range edges_of(std::int32_t body) const {
    const auto b = static_cast<std::size_t>(body);
    return {static_cast<std::size_t>(topology_.body_edge_begin[b]),
            static_cast<std::size_t>(topology_.body_edge_begin[b + 1])};
  }

  static ContactKey key_of(std::size_t a, std::size_t b) {
    return contact_key(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
  }

  void bound(const Range& edges) {
    for (std::size_t e = edges.begin; e < edges.end; ++e) {
      const auto& v = topology_.sharp_edge[e].vertex;
      Box3 box(search_.reference[static_cast<std::size_t>(v[0])]);
      box.extend(search_.reference[static_cast<std::size_t>(v[1])]);
      box.min().array() -= 2 * search_.skin;
      box.max().array() += 2 * search_.skin;
      search_.edge_box.set(e, box);
    }
  }

  // Lists those of the edges that may be where a meeting is.
  template <int Bytes>
  STICTION_LANES_INLINE void list_near(const Range& edges, PairSearch::EdgeMeeting& meeting) {
    meeting.begin = search_.near_edge.size();
    const auto note = [&](std::size_t e) __attribute__((always_inline)) {
      search_.near_edge.push_back(e);
    };
    search_.edge_box.for_each_meeting<Bytes>(edges.begin, edges.end, meeting.of->common, note);
    meeting.end = search_.near_edge.size();
    search_.near_edge_box.reserve(meeting.end);
    for (std::size_t k = meeting.begin; k < meeting.end; ++k) {
      search_.near_edge_box.set(k, search_.edge_box, search_.near_edge[k]);
    }
  }

  // Adds the pairs of an edge with those listed.
  template <int Bytes>
  STICTION_LANES_INLINE void add(std::size_t edge, const Box3& box,
                                 const PairSearch::EdgeMeeting& meeting) {
    const auto pair = [&](std::size_t k) __attribute__((always_inline)) {
      search_.edge_candidate.push_back({.key = key_of(edge, search_.near_edge[k]),
                                        .body_a = static_cast<std::uint32_t>(meeting.of->body),
                                        .body_b = static_cast<std::uint32_t>(meeting.of->other)});
    };
    search_.near_edge_box.for_each_meeting<Bytes>(meeting.begin, meeting.end, box, pair);
  }

  // Keeps the pairs of an edge with others as they are. To be called in the order of their keys.
  void keep(std::size_t edge, const Range& others) {
    const std::vector<PairSearch::EdgePair>& old = search_.old_edge_candidate;
    while (old_ < old.size() && old[old_].key < key_of(edge, others.begin)) ++old_;
    while (old_ < old.size() && old[old_].key < key_of(edge, others.end)) {
      search_.edge_candidate.push_back(old[old_++]);
    }
  }

  const Topology& topology_;
  PairSearch& search_;
  bool all_;             // nothing is kept
  std::size_t old_ = 0;  // those before it are kept, or gone
};

}  // namespace

void find_edge_candidates(const Scene& scene, PairSearch& search) {
  EdgeLists lists(scene.topology, search);
  const std::vector<PairSearch::Meeting>& meeting = search.meeting;
  in_lanes(
      kSideBySide, lane_width(), [&](auto bytes) __attribute__((always_inline)) {
        for (std::size_t begin = 0, end; begin < meeting.size(); begin = end) {
          end = begin + 1;
          while (end < meeting.size() && meeting[end].body == meeting[begin].body) ++end;
          lists.list<bytes>(begin, end);
        }
      });
  search.edges_listed = true;
  search.edge_awake.steps = 0;
}

}  // namespace stiction
