// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/detect_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "solver/detection/crossing_edges.h"
#include "solver/detection/edge_candidates.h"
#include "solver/detection/outrun.h"
#include "solver/detection/pair_candidates.h"

namespace stiction {

namespace {

// Round-off of weights of order one: a point on a shared face must not fall between its two
// elements.
constexpr Real kOnBoundary = -by_precision(1e-12, 2e-6);

// With weights above this the point is inside this tetrahedron and no other of an unfolded body:
// far above round-off, far below any depth.
constexpr Real kInside = by_precision(1e-9, 1e-4);

// Of large scenes the elements that hold the vertices are far apart and out of the cache: asked for
// so many contacts before they are read, which halves the time at 1e5 contacts.
constexpr std::size_t kAhead = 16;

void add_contact(const Scene& scene, ContactKey key, std::int32_t element, std::int32_t triangle,
                 bool open, PairContacts& pairs) {
  PairContact contact;
  contact.open = open;
  contact.key = key;
  contact.vertex = first_of(key);
  contact.element = element;
  contact.triangle = triangle;
  set_corners(scene.elements, contact);
  pairs.push_back(contact);
}

// What of the candidates of one key holds the vertex: the tetrahedron that it is deepest in, the
// lower number winning a tie; −1 for none. `last`, where it was in the last step or −1, is tried
// first, and stays while the vertex is in the body and no weight in `last` is below −`margin`.
std::int32_t find_element(const Scene& scene, const PairSearch& search,
                          const PairSearch::Group& group, std::int32_t last, Real margin) {
  const auto x = [&](std::int32_t v) -> const Vec3& {
    return search.predicted[static_cast<std::size_t>(v)];
  };
  const Vec3& point = x(first_of(group.key));
  const auto smallest_weight = [&](std::int32_t e) {
    const auto& corner = scene.elements[static_cast<std::size_t>(e)].vertex;
    return barycentric(point, x(corner[0]), x(corner[1]), x(corner[2]), x(corner[3])).minCoeff();
  };
  // What the round-off of the weights lets in must not be beyond the outermost corner.
  const auto in_box = [&](std::int32_t e) {
    Box3 box;
    for (const std::int32_t v : scene.elements[static_cast<std::size_t>(e)].vertex)
      box.extend(x(v));
    return box.contains(point);
  };
  const Real in_last = last >= 0 ? smallest_weight(last) : -std::numeric_limits<Real>::infinity();
  if (in_last > kInside) return last;
  std::int32_t found = -1;
  Real deepest = kOnBoundary;
  for (std::int32_t k = group.candidate_begin; k < group.candidate_end; ++k) {
    const std::int32_t element = search.candidate[static_cast<std::size_t>(k)].element;
    const Real weight = smallest_weight(element);
    if (!(found < 0 ? weight >= deepest : weight > deepest)) continue;
    if (in_box(element)) {
      found = element;
      deepest = weight;
    }
  }
  return found >= 0 && margin > 0.0 && in_last >= -margin ? last : found;
}

// Tests the candidates, and merges what is found with the contacts of the last step that have only
// just opened. Those are measured in the depth phase, which drops them when the gap is too wide.
void merge_with_kept(const Scene& scene, const PairSearch& search, const PairGeometry& last,
                     const PairOptions& options, PairContacts& pairs) {
  const bool keep_open_ones = options.hysteresis > 0.0;
  const bool keep_triangle = keep_open_ones || options.tie_margin > 0.0;
  pairs.clear();
  const auto keep_open = [&](std::size_t old) {
    if (keep_open_ones)
      add_contact(scene, last.body_key[old], last.element[old], last.triangle[old], true, pairs);
  };
  std::size_t old = 0;
  for (const PairSearch::Group& group : search.group) {
    const ContactKey key = group.key;
    for (; old < last.body_key.size() && last.body_key[old] < key; ++old) keep_open(old);
    const bool persists = old < last.body_key.size() && last.body_key[old] == key;
    if (old + kAhead < last.element.size()) {
      __builtin_prefetch(&scene.elements[static_cast<std::size_t>(last.element[old + kAhead])]);
    }
    const std::int32_t element =
        find_element(scene, search, group, persists ? last.element[old] : -1, options.tie_margin);
    if (element >= 0) {
      add_contact(scene, key, element, persists && keep_triangle ? last.triangle[old] : -1, false,
                  pairs);
    } else if (persists) {
      keep_open(old);
    }
    if (persists) ++old;
  }
  for (; old < last.body_key.size(); ++old) keep_open(old);
}

}  // namespace

void set_corners(const std::vector<Element>& elements, PairContact& contact) {
  const auto& corner = elements[static_cast<std::size_t>(contact.element)].vertex;
  std::copy(corner, corner + 4, contact.partner);
}

Vec4 barycentric(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, ap = point - a;
  const Vec3 ac_ad = ac.cross(ad);
  const Real volume = ab.dot(ac_ad);
  Vec4 weight;
  weight[1] = ap.dot(ac_ad) / volume;
  weight[2] = ab.dot(ap.cross(ad)) / volume;
  weight[3] = ab.dot(ac.cross(ap)) / volume;
  weight[0] = 1 - weight[1] - weight[2] - weight[3];
  return weight;
}

void detect_pairs(const Scene& scene, const Options& options, const State& state,
                  Workspace& workspace) {
  PairSearch& search = workspace.search;
  search.predicted.resize(state.position.size());
  for (std::size_t k = 0; k < state.position.size(); ++k) {
    search.predicted[k] = state.position[k].x + options.dt() * workspace.velocity[k].v;
  }
  if (update_candidates(scene, search)) {
    search.edges_listed = false;
    if (options.pairs.face == PairFace::kOpposed) {
      note_outrun(scene, options.dt(), workspace.velocity, search);
    }
  }
  if (with_edges(options) && !search.edges_listed) find_edge_candidates(scene, search);
  merge_with_kept(scene, search, state.pair_geometry, options.pairs, workspace.pairs);
}

}  // namespace stiction
