// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/pair_candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/depth/nearest.h"

namespace stiction {

namespace {

// Skin over mean edge. Wider: lists last longer and name more; at 0.05 a vertex near a surface has
// about ten tetrahedra, and a body that slides at 1 m/s over edges of 1 cm renews them every 500
// µs.
constexpr Real kSkin = 0.05;

bool may_touch_itself(const Body& body) {
  return STICTION_HAS_SELF_COLLISION && body.self_collision;
}

// Notes how far each body has moved; false as soon as that is too far for the lists.
bool note_moves(const Scene& scene, const Team* team, PairSearch& search) {
  if (search.scene != scene.serial || search.reference.size() != search.predicted.size()) {
    return false;
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const auto first = static_cast<std::size_t>(scene.bodies[b].first_vertex);
    std::atomic<Real> farthest = 0.0;  // along an axis
    const auto note = [&](std::size_t begin, std::size_t end) {
      Real here = 0.0;
      for (std::size_t k = first + begin; k < first + end; ++k) {
        const Vec3 by = (search.predicted[k] - search.reference[k]).cwiseAbs();
        // Written so that what is no number counts as moved.
        if (!(by.x() <= search.skin && by.y() <= search.skin && by.z() <= search.skin)) {
          here = std::numeric_limits<Real>::infinity();
          break;
        }
        here = std::max({here, by.x(), by.y(), by.z()});
      }
      Real known = farthest;
      while (known < here && !farthest.compare_exchange_weak(known, here)) {
      }
    };
    for_ranges(team, static_cast<std::size_t>(scene.bodies[b].vertex_count), kVerticesToShare,
               note);
    if (farthest > search.skin) return false;
    search.moved[b] = std::sqrt(Real(3)) * farthest;
  }
  return true;
}

void widen(Box3& box, Real by) {
  box.min().array() -= by;
  box.max().array() += by;
}

void bound_bodies(const Scene& scene, PairSearch& search) {
  search.box.resize(scene.bodies.size());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    Box3 box;
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
      box.extend(search.reference[static_cast<std::size_t>(v)]);
    }
    widen(box, 2 * search.skin);
    search.box[b] = box;
  }
}

// The part of each body's box in which it can meet another body; empty boxes meet nothing. Sweep
// and prune along x.
void find_overlaps(const Scene& scene, PairSearch& search) {
  const std::size_t count = scene.bodies.size();
  search.overlap.assign(count, Box3());
  search.order.resize(count);
  std::iota(search.order.begin(), search.order.end(), 0);
  std::sort(search.order.begin(), search.order.end(), [&](int a, int b) {
    const Real xa = search.box[static_cast<std::size_t>(a)].min().x();
    const Real xb = search.box[static_cast<std::size_t>(b)].min().x();
    return xa != xb ? xa < xb : a < b;
  });
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = static_cast<std::size_t>(search.order[i]);
    if (may_touch_itself(scene.bodies[a]) && !scene.bodies[a].fixed) {
      search.overlap[a].extend(search.box[a]);
    }
    for (std::size_t j = i + 1; j < count; ++j) {
      const auto b = static_cast<std::size_t>(search.order[j]);
      if (search.box[b].min().x() > search.box[a].max().x()) break;
      if (scene.bodies[a].fixed && scene.bodies[b].fixed) continue;
      const Box3 common = search.box[a].intersection(search.box[b]);
      if (common.isEmpty()) continue;
      search.overlap[a].extend(common);
      search.overlap[b].extend(common);
    }
  }
}

void hash_vertices(const Scene& scene, PairSearch& search) {
  search.hash.clear(scene.topology.mean_edge);
  for (const int vertex : scene.surface_vertex) {
    const auto v = static_cast<std::size_t>(vertex);
    const auto body = static_cast<std::size_t>(scene.topology.vertex_body[v]);
    if (search.overlap[body].isEmpty()) continue;
    if (search.overlap[body].contains(search.reference[v])) {
      search.hash.add(vertex, search.reference[v]);
    }
  }
  search.hash.build();
}

void find_candidates(const Scene& scene, std::int32_t e, PairSearch& search) {
  const Element& element = scene.elements[static_cast<std::size_t>(e)];
  const std::int32_t body = scene.topology.element_body[static_cast<std::size_t>(e)];
  const bool self = may_touch_itself(scene.bodies[static_cast<std::size_t>(body)]);
  const bool fixed = scene.bodies[static_cast<std::size_t>(body)].fixed;
  Box3 box;
  for (const std::int32_t v : element.vertex) {
    box.extend(search.reference[static_cast<std::size_t>(v)]);
  }
  widen(box, 2 * search.skin);
  if (!box.intersects(search.overlap[static_cast<std::size_t>(body)])) return;
  search.hash.for_each_in(
      search.hash.cell(box.min()), search.hash.cell(box.max()), [&](std::int32_t vertex) {
        const auto v = static_cast<std::size_t>(vertex);
        const std::int32_t other = scene.topology.vertex_body[v];
        if (other == body && (!self || std::count(element.vertex, element.vertex + 4, vertex))) {
          return;
        }
        if (fixed && scene.bodies[static_cast<std::size_t>(other)].fixed) return;
        if (!box.contains(search.reference[v])) return;
        search.candidate.push_back({contact_key(vertex, body), e});
      });
}

// Balls that hold the triangles as long as the lists do.
void bound_triangles(const Topology& topology, PairSearch& search) {
  search.ball.resize(topology.triangle.size());
  const std::vector<Vec3>& x = search.reference;
  for (std::size_t b = 0; b < search.overlap.size(); ++b) {
    const auto begin = static_cast<std::size_t>(topology.body_triangle_begin[b]);
    const auto end = static_cast<std::size_t>(topology.body_triangle_begin[b + 1]);
    for (std::size_t t = begin; t < end; ++t) {
      if (search.overlap[b].isEmpty()) {
        search.ball[t] = {Vec3::Zero(), std::numeric_limits<Real>::infinity()};
        continue;
      }
      const auto& v = topology.triangle[t].vertex;
      const Vec3& p = x[static_cast<std::size_t>(v[0])];
      const Vec3& q = x[static_cast<std::size_t>(v[1])];
      const Vec3& r = x[static_cast<std::size_t>(v[2])];
      const Vec3 centre = (p + q + r) / 3;
      const Real radius2 = std::max(
          {(p - centre).squaredNorm(), (q - centre).squaredNorm(), (r - centre).squaredNorm()});
      search.ball[t] = {centre, std::sqrt(radius2) + std::sqrt(Real(3)) * search.skin};
    }
  }
}

void group_candidates(PairSearch& search) {
  std::sort(search.candidate.begin(), search.candidate.end(),
            [](const PairSearch::Candidate& a, const PairSearch::Candidate& b) {
              return a.key != b.key ? a.key < b.key : a.element < b.element;
            });
  search.group.clear();
  search.near.clear();
  const std::size_t count = search.candidate.size();
  for (std::size_t begin = 0, end; begin < count; begin = end) {
    const ContactKey key = search.candidate[begin].key;
    end = begin + 1;
    while (end < count && search.candidate[end].key == key) ++end;
    search.group.push_back(
        {key, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end), 0, 0, -1, 0.0});
  }
}

}  // namespace

bool update_candidates(const Scene& scene, PairSearch& search, const Team* team) {
  if (note_moves(scene, team, search)) return false;
  search.scene = scene.serial;
  search.skin = kSkin * scene.topology.mean_edge;
  search.reference = search.predicted;
  search.moved.assign(scene.bodies.size(), 0.0);
  bound_bodies(scene, search);
  find_overlaps(scene, search);
  hash_vertices(scene, search);
  search.candidate.clear();
  for (std::size_t b = 0; b < scene.bodies.size() && !search.hash.empty(); ++b) {
    if (search.overlap[b].isEmpty()) continue;
    const Body& body = scene.bodies[b];
    for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
      find_candidates(scene, e, search);
    }
  }
  bound_triangles(scene.topology, search);
  group_candidates(search);
  return true;
}

void list_nearest(const Topology& topology, std::int32_t element, PairSearch::Group& group,
                  PairSearch& search) {
  const Real moves = std::sqrt(Real(3)) * search.skin;
  const Vec3& x = search.reference[static_cast<std::size_t>(first_of(group.key))];
  const auto e = static_cast<std::size_t>(element);
  const auto begin = topology.near.begin() + topology.near_begin[e];
  const auto end = topology.near.begin() + topology.near_begin[e + 1];
  if (begin == end) return;
  const auto ball = [&](std::int32_t t) -> const PairSearch::Ball& {
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
  group.near_element = element;
  group.near_reach = farthest;
  group.near_begin = static_cast<std::int32_t>(first);
  group.near_end = static_cast<std::int32_t>(search.near.size());
}

}  // namespace stiction
