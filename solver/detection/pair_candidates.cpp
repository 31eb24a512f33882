// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/pair_candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "solver/demand.h"
#include "solver/depth/nearest.h"
#include "solver/detection/boxes.h"
#include "solver/detection/follow.h"
#include "solver/lanes/in_registers.h"
#include "solver/lanes/packed_vec3.h"

namespace stiction {

namespace {

// Skin over mean edge. Wider: lists last longer and name more; at 0.05 a vertex near a surface has
// about ten tetrahedra, and a body that slides at 1 m/s over edges of 1 cm renews them every 500
// µs.
constexpr Real kSkin = 0.05;

bool may_touch_itself(const Body& body) {
  return STICTION_HAS_SELF_COLLISION && body.self_collision;
}

bool comes_before(const PairSearch::Meeting& a, const PairSearch::Meeting& b) {
  return a.body != b.body ? a.body < b.body : a.other < b.other;
}

// Forgets the lists of another scene.
void begin_scene(const Scene& scene, std::size_t vertices, PairSearch& search) {
  if (search.scene == scene.serial && search.reference.size() == vertices) return;
  search.scene = scene.serial;
  search.skin = kSkin * scene.topology.mean_edge;
  const std::size_t bodies = scene.bodies.size();
  search.predicted.assign(vertices, Vec3::Zero());
  search.reference.assign(vertices, Vec3::Constant(std::numeric_limits<Real>::infinity()));
  search.moved.assign(bodies, 0.0);
  search.path.assign(bodies, 0.0);
  search.strides = 0.0;
  search.renewed.assign(bodies, false);
  search.box.assign(bodies, Box3());
  search.meeting.clear();
  search.found.clear();
  search.group.clear();
  search.near.clear();
  search.outlets.clear();
  search.ball.assign(scene.topology.triangle.size(),
                     {Vec3::Zero(), std::numeric_limits<Real>::infinity()});
}

// So many surface vertices are asked for by one box around all at first: what is next in number is
// near in space.
constexpr std::size_t kBlock = 16;

void widen(Box3& box, Real by) {
  box.min().array() -= by;
  box.max().array() += by;
}

// Takes the bodies that have moved where they are, and bounds them.
STICTION_LANES_INLINE void bound_in_registers(const Scene& scene, PairSearch& search) {
  const Vec3* const predicted = search.predicted.data();
  Vec3* const reference = search.reference.data();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!search.renewed[b]) continue;
    const auto begin = static_cast<std::size_t>(scene.bodies[b].first_vertex);
    const std::size_t end = begin + static_cast<std::size_t>(scene.bodies[b].vertex_count);
    Box3 box = box_around(
        begin, end, [&](std::size_t k) __attribute__((always_inline)) {
          reference[k] = predicted[k];
          return PackedVec3(predicted[k]);
        });
    widen(box, 2 * search.skin);
    search.box[b] = box;
  }
  // Those that hold vertices of two bodies are made twice, to the same.
  search.vertex_block.resize((scene.surface_vertex.size() + kBlock - 1) / kBlock);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::size_t begin = scene.bodies[b].surface_begin, end = scene.bodies[b].surface_end;
    if (!search.renewed[b] || begin == end) continue;
    for (std::size_t block = begin / kBlock; block * kBlock < end; ++block) {
      const std::size_t last = std::min((block + 1) * kBlock, scene.surface_vertex.size());
      search.vertex_block[block] = box_around(
          block * kBlock, last, [&](std::size_t k) __attribute__((always_inline)) {
            return PackedVec3(reference[static_cast<std::size_t>(scene.surface_vertex[k])]);
          });
    }
  }
}
void bound_bodies(const Scene& scene, PairSearch& search) {
  in_registers(
      lane_width(), [&]() __attribute__((always_inline)) { bound_in_registers(scene, search); });
}

// What bodies can meet, and where: sweep and prune along x.
void find_meetings(const Scene& scene, PairSearch& search) {
  const std::size_t count = scene.bodies.size();
  search.overlap.assign(count, Box3());
  search.order.resize(count);
  std::iota(search.order.begin(), search.order.end(), 0);
  std::sort(search.order.begin(), search.order.end(), [&](int a, int b) {
    const Real xa = search.box[static_cast<std::size_t>(a)].min().x();
    const Real xb = search.box[static_cast<std::size_t>(b)].min().x();
    return xa != xb ? xa < xb : a < b;
  });
  search.old_meeting.swap(search.meeting);
  search.meeting.clear();
  const auto add = [&](std::size_t body, std::size_t other, const Box3& common) {
    search.overlap[body].extend(common);
    search.meeting.push_back(
        {static_cast<std::int32_t>(body), static_cast<std::int32_t>(other), common, 0, 0});
  };
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = static_cast<std::size_t>(search.order[i]);
    if (may_touch_itself(scene.bodies[a]) && !scene.bodies[a].fixed) add(a, a, search.box[a]);
    for (std::size_t j = i + 1; j < count; ++j) {
      const auto b = static_cast<std::size_t>(search.order[j]);
      if (search.box[b].min().x() > search.box[a].max().x()) break;
      if (scene.bodies[a].fixed && scene.bodies[b].fixed) continue;
      const Box3 common = search.box[a].intersection(search.box[b]);
      if (common.isEmpty()) continue;
      add(a, b, common);
      add(b, a, common);
    }
  }
  std::sort(search.meeting.begin(), search.meeting.end(), comes_before);
}

bool is_corner(const Scene& scene, std::int32_t vertex, std::int32_t element) {
  const auto& corner = scene.elements[static_cast<std::size_t>(element)].vertex;
  return std::count(corner, corner + 4, vertex) > 0;
}

// Most rows and blocks have few: wider registers would be filled by half.
constexpr int kSideBySide = 4;

// Of a meeting; `element_boxes` are of its body.
void find_candidates(const Scene& scene, const PairSearch::Meeting& meeting, PairSearch& search) {
  const Body& other = scene.bodies[static_cast<std::size_t>(meeting.other)];
  search.hash.clear(scene.topology.mean_edge);
  const auto at = [&](std::int32_t vertex) -> const Vec3& {
    return search.reference[static_cast<std::size_t>(vertex)];
  };
  // Noted whether they are wanted or not, for which is anybody's guess.
  std::vector<std::int32_t>& common = search.common_vertex;
  common.resize(other.surface_end - other.surface_begin);
  std::size_t count = 0;
  for (std::size_t begin = other.surface_begin, end; begin < other.surface_end; begin = end) {
    end = std::min((begin / kBlock + 1) * kBlock, other.surface_end);
    if (apart(search.vertex_block[begin / kBlock], meeting.common)) continue;
    for (std::size_t k = begin; k < end; ++k) {
      common[count] = scene.surface_vertex[k];
      count += static_cast<std::size_t>(holds(meeting.common, at(common[count])));
    }
  }
  for (std::size_t k = 0; k < count; ++k) search.hash.add(common[k], at(common[k]));
  if (search.hash.empty()) return;
  const bool self = meeting.body == meeting.other;
  in_lanes(
      kSideBySide, lane_width(), [&](auto bytes) __attribute__((always_inline)) {
        search.element_boxes.for_each_holding<bytes>(
            search.hash, [&](std::int32_t vertex, std::int32_t element)
                             __attribute__((always_inline)) {
                               if (self && is_corner(scene, vertex, element)) return;
                               search.found.push_back({vertex, element});
                             });
      });
}

// Of all meetings; those of two bodies that have not moved are as they were. Returns whether there are such.
bool find_candidates(const Scene& scene, PairSearch& search) {
  search.old_found.swap(search.found);
  search.found.clear();
  bool keeps = false;
  std::int32_t bounded = -1;  // the body that `element_boxes` are of
  auto old = search.old_meeting.begin();
  for (PairSearch::Meeting& meeting : search.meeting) {
    meeting.begin = search.found.size();
    while (old != search.old_meeting.end() && comes_before(*old, meeting)) ++old;
    if (is_renewed(search, meeting.other, meeting.body)) {
      if (bounded != meeting.body) {
        bounded = meeting.body;
        const auto b = static_cast<std::size_t>(bounded);
        search.element_boxes.bound(scene, scene.bodies[b], search.reference, 2 * search.skin,
                                   search.overlap[b], lane_width());
      }
      find_candidates(scene, meeting, search);
    } else {
      demand(old != search.old_meeting.end() && !comes_before(meeting, *old),
             "bodies that have not moved meet as they did");
      keeps = true;
      search.found.insert(search.found.end(),
                          search.old_found.begin() + static_cast<std::ptrdiff_t>(old->begin),
                          search.old_found.begin() + static_cast<std::ptrdiff_t>(old->end));
    }
    meeting.end = search.found.size();
  }
  return keeps;
}

// Balls that hold the triangles as long as the lists do.
void renew_balls(const Topology& topology, PairSearch& search) {
  const Real moves = std::sqrt(Real(3)) * search.skin;
  const TriangleBall everywhere{Vec3::Zero(), std::numeric_limits<Real>::infinity()};
  for (std::size_t b = 0; b < search.overlap.size(); ++b) {
    const auto begin = static_cast<std::size_t>(topology.body_triangle_begin[b]);
    const auto end = static_cast<std::size_t>(topology.body_triangle_begin[b + 1]);
    const bool meets = !search.overlap[b].isEmpty();
    if (begin == end) continue;
    if (!search.renewed[b] && std::isfinite(search.ball[begin].radius) == meets) continue;
    if (!meets) {
      std::fill(search.ball.begin() + static_cast<std::ptrdiff_t>(begin),
                search.ball.begin() + static_cast<std::ptrdiff_t>(end), everywhere);
      continue;
    }
    bound_triangles(topology, begin, end, search.reference, moves, lane_width(), search.ball);
  }
}

// By vertex, then element. They were found in the order of bodies and of their elements, which is that of
// all elements, so they are only to be counted out to their vertices.
void sort_candidates(std::size_t vertices, PairSearch& search) {
  std::vector<std::int32_t>& end = search.candidate_end;
  end.assign(vertices + 1, 0);
  for (const PairSearch::Candidate& candidate : search.found) {
    ++end[static_cast<std::size_t>(candidate.vertex) + 1];
  }
  std::partial_sum(end.begin(), end.end(), end.begin());
  search.candidate.resize(search.found.size());
  // Each vertex's begin moves to its end here.
  for (const PairSearch::Candidate& candidate : search.found) {
    const auto next = end[static_cast<std::size_t>(candidate.vertex)]++;
    search.candidate[static_cast<std::size_t>(next)] = candidate.element;
  }
}

// Takes over what is known of a group, and the triangles that it has listed.
void keep_known(const PairSearch::Group& old, PairSearch::Group& group, PairSearch& search) {
  group.verdict = old.verdict;
  group.held = old.held;
  group.holds_until = old.holds_until;
  if (old.near_element < 0) return;
  group.near_begin = static_cast<std::int32_t>(search.near.size());
  search.near.insert(search.near.end(), search.old_near.begin() + old.near_begin,
                     search.old_near.begin() + old.near_end);
  group.near_end = static_cast<std::int32_t>(search.near.size());
  group.near_element = old.near_element;
  group.near_reach = old.near_reach;
  group.stays_until = old.stays_until;
  group.stays_on = old.stays_on;
  group.passes_over = old.passes_over;
}

// Groups of bodies that have not moved, where there are any, keep what is known of them.
void group_candidates(const Topology& topology, bool any_keep, PairSearch& search) {
  search.old_group.swap(search.group);
  search.old_near.swap(search.near);
  search.group.clear();
  search.near.clear();
  auto old = search.old_group.begin();
  const auto body_at = [&](std::int32_t k) {
    const std::int32_t element = search.candidate[static_cast<std::size_t>(k)];
    return topology.element_body[static_cast<std::size_t>(element)];
  };
  const auto add = [&](std::int32_t vertex, std::int32_t begin, std::int32_t end) {
    const std::int32_t body = body_at(begin);
    const std::int32_t other = topology.vertex_body[static_cast<std::size_t>(vertex)];
    const ContactKey key = contact_key(vertex, body);
    search.group.push_back({.key = key, .candidate_begin = begin, .candidate_end = end});
    if (!any_keep || is_renewed(search, other, body)) return;
    while (old != search.old_group.end() && old->key < key) ++old;
    if (old != search.old_group.end() && old->key == key) {
      keep_known(*old, search.group.back(), search);
    }
  };
  std::int32_t begin = 0;
  for (std::size_t v = 0; v < topology.vertex_body.size(); ++v) {
    for (const std::int32_t all = search.candidate_end[v]; begin < all;) {
      std::int32_t end = all;
      // Most vertices may be in one body alone.
      if (body_at(all - 1) != body_at(begin)) {
        end = begin + 1;
        while (body_at(end) == body_at(begin)) ++end;
      }
      add(static_cast<std::int32_t>(v), begin, end);
      begin = end;
    }
  }
}

}  // namespace

bool update_candidates(const Scene& scene, Real dt, const State& state,
                       const std::vector<Velocity>& velocity, const Team* team,
                       PairSearch& search) {
  begin_scene(scene, state.position.size(), search);
  if (!follow(scene, dt, state, velocity, team, search)) return false;
  bound_bodies(scene, search);
  find_meetings(scene, search);
  renew_balls(scene.topology, search);
  const bool any_keep = find_candidates(scene, search);
  sort_candidates(scene.mass.size(), search);
  group_candidates(scene.topology, any_keep, search);
  return true;
}

bool is_to_list(const Topology& topology, std::int32_t element, const PairSearch::Group& group) {
  const auto e = static_cast<std::size_t>(element);
  return group.near_element != element && group.listings < kMostListings &&
         topology.near_begin[e] < topology.near_begin[e + 1];
}

void list_nearest(const Topology& topology, std::int32_t element, PairSearch::Group& group,
                  PairSearch& search) {
  if (!is_to_list(topology, element, group)) return;
  const Real moves = std::sqrt(Real(3)) * search.skin;
  const Vec3& x = search.reference[static_cast<std::size_t>(first_of(group.key))];
  const auto e = static_cast<std::size_t>(element);
  const auto begin = topology.near.begin() + topology.near_begin[e];
  const auto end = topology.near.begin() + topology.near_begin[e + 1];
  ++group.listings;
  const auto ball = [&](std::int32_t t) -> const TriangleBall& {
    return search.ball[static_cast<std::size_t>(t)];
  };
  // D is at most the distance of any triangle; that with the nearest centre is a good one.
  const auto by_centre = [&](std::int32_t s, std::int32_t t) {
    return (x - ball(s).centre).squaredNorm() < (x - ball(t).centre).squaredNorm();
  };
  const auto distance = [&](std::int32_t t) {
    const auto& v = topology.triangle[static_cast<std::size_t>(t)].vertex;
    const auto corner = [&](int k) -> const Vec3& {
      return search.reference[static_cast<std::size_t>(v[k])];
    };
    return std::sqrt(nearest_on_triangle(x, corner(0), corner(1), corner(2)).distance2);
  };
  Real farthest = distance(*std::min_element(begin, end, by_centre)) + 4 * moves;
  const auto first = static_cast<std::ptrdiff_t>(search.near.size());
  for (auto t = begin; t != end; ++t) {
    // The ball is wider than the triangle at the reference by √3 s.
    const Real reach = farthest + ball(*t).radius - moves;
    if ((x - ball(*t).centre).squaredNorm() > reach * reach) continue;
    const Real d = distance(*t);
    farthest = std::min(farthest, d + 4 * moves);
    if (d <= farthest) search.near.push_back({d, *t});
  }
  std::sort(search.near.begin() + first, search.near.end(),
            [](const PairSearch::Near& a, const PairSearch::Near& b) {
              return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
            });
  group.stays_on = -1;
  group.near_element = element;
  group.near_reach = farthest;
  group.near_begin = static_cast<std::int32_t>(first);
  group.near_end = static_cast<std::int32_t>(search.near.size());
}

}  // namespace stiction
