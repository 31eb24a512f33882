// SPDX-License-Identifier: BSD-3-Clause
#include "solver/phases/depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/hash.h"
#include "solver/mutation.h"
#include "solver/phases/consistent_depth.h"
#include "solver/phases/detect_pairs.h"
#include "solver/phases/nearest.h"
#include "solver/phases/pair_candidates.h"

namespace stiction {

namespace {

using Triangle = Topology::Triangle;

struct Projection {
  NearestOnTriangle nearest;
  std::int32_t triangle;
};

Vec3 outward_normal(const Triangle& triangle, const std::vector<Vec3>& x) {
  const Vec3& a = x[static_cast<std::size_t>(triangle.vertex[0])];
  const Vec3& b = x[static_cast<std::size_t>(triangle.vertex[1])];
  const Vec3& c = x[static_cast<std::size_t>(triangle.vertex[2])];
  return (b - a).cross(c - a).normalized();
}

// Whether the vertex can rest on a face with this outward normal: its own surface lies before the
// face's plane, in so far as the edges of that surface that end at the vertex do.
bool can_rest_on(const Topology& topology, const std::vector<Vec3>& x, std::int32_t vertex,
                 const Vec3& normal) {
  // Sine of the angle by which an edge may lead behind the plane: surfaces bend, and a face that
  // is the wrong one stands across.
  constexpr double kBehind = 0.5;
  const auto v = static_cast<std::size_t>(vertex);
  for (std::int32_t k = topology.neighbour_begin[v]; k < topology.neighbour_begin[v + 1]; ++k) {
    const Vec3 edge =
        x[static_cast<std::size_t>(topology.neighbour[static_cast<std::size_t>(k)])] - x[v];
    const double along = normal.dot(edge);
    if (along < 0.0 && along * along > kBehind * kBehind * edge.squaredNorm()) return false;
  }
  return true;
}

Projection project_on(const Topology& topology, const std::vector<Vec3>& x, const Vec3& point,
                      std::int32_t t) {
  const Triangle& triangle = topology.triangle[static_cast<std::size_t>(t)];
  return {nearest_on_triangle(point, x[static_cast<std::size_t>(triangle.vertex[0])],
                              x[static_cast<std::size_t>(triangle.vertex[1])],
                              x[static_cast<std::size_t>(triangle.vertex[2])]),
          t};
}

// The nearest of the triangles that it has been shown, of equals that of the lowest number.
struct Nearest {
  const Topology& topology;
  const std::vector<Vec3>& x;
  const Vec3& point;
  std::int32_t resting = -1;  // only triangles that this vertex can rest on; −1: any
  Projection best{{Vec3::Zero(), std::numeric_limits<double>::infinity(), false}, -1};
  double reach = std::numeric_limits<double>::infinity();  // distance of the best

  void consider(std::int32_t t) {
    const Projection other = project_on(topology, x, point, t);
    const double nearer = other.nearest.distance2 - best.nearest.distance2;
    if (nearer < 0.0 || (nearer == 0.0 && t < best.triangle)) {
      if (resting >= 0 &&
          !can_rest_on(topology, x, resting,
                       outward_normal(topology.triangle[static_cast<std::size_t>(t)], x))) {
        return;
      }
      best = other;
      reach = std::sqrt(best.nearest.distance2);
    }
  }
};

// Of the triangles of the group's list: in the order of their distances at the reference, until
// what vertex and triangles have moved since can't make the next one the nearest. None (−1) where
// the list need not name the nearest that is asked for.
Projection project_by_list(const Topology& topology, const PairSearch& search,
                           const PairSearch::Group& group, const Vec3& point,
                           const PairContact& contact, std::int32_t resting) {
  const auto vertex = static_cast<std::size_t>(group.key >> 32);
  const auto body = static_cast<std::size_t>(group.key & 0xffffffffu);
  // Far above the round-off of a distance.
  const double rounding = 1e-9 * search.skin + 1e-14 * point.norm();
  const double moved = (point - search.reference[vertex]).norm() + search.moved[body] + rounding;
  Nearest nearest{topology, search.predicted, point, resting};
  if (contact.triangle >= 0) nearest.consider(contact.triangle);
  for (std::int32_t k = group.near_begin; k < group.near_end; ++k) {
    const PairSearch::Near& near = search.near[static_cast<std::size_t>(k)];
    if (near.distance - moved > nearest.reach) break;
    if (near.triangle != contact.triangle) nearest.consider(near.triangle);
  }
  if (resting >= 0 && nearest.reach + moved > group.near_reach) nearest.best.triangle = -1;
  return nearest.best;
}

// Of all triangles near the contact's element, or of the body's where none is near or `everywhere`
// is asked for. Begins with that of the last step, if there was one, so that most others are out of
// reach.
Projection project_by_balls(const Topology& topology, const PairSearch& search, const Vec3& point,
                            const PairContact& contact, std::int32_t resting, bool everywhere) {
  constexpr double kRounding = 1.0 + 1e-12;
  Nearest nearest{topology, search.predicted, point, resting};
  if (contact.triangle >= 0) nearest.consider(contact.triangle);
  const auto consider = [&](std::int32_t t) {
    const PairSearch::Ball& ball = search.ball[static_cast<std::size_t>(t)];
    const double least = nearest.reach + ball.radius;
    if (t == contact.triangle || (point - ball.centre).squaredNorm() > least * least * kRounding) {
      return;
    }
    nearest.consider(t);
  };
  const auto e = static_cast<std::size_t>(contact.element);
  const auto begin = topology.near.begin() + topology.near_begin[e];
  const auto end = topology.near.begin() + topology.near_begin[e + 1];
  if (!everywhere) std::for_each(begin, end, consider);
  if (everywhere || begin == end) {
    const auto body = static_cast<std::size_t>(topology.element_body[e]);
    for (std::int32_t t = topology.body_triangle_begin[body];
         t < topology.body_triangle_begin[body + 1]; ++t) {
      consider(t);
    }
  }
  return nearest.best;
}

// An element is taken not to be squeezed to less than this share of its least width.
constexpr double kSqueezed = 0.5;

// Nearest surface triangle of the penetrated body, of equals that of the lowest number: of those
// near the contact's element, unless it lies so deep that one that shares no corner with the
// element may be as near (see Topology::least_width).
Projection project(const Topology& topology, PairSearch& search, PairSearch::Group* group,
                   const Vec3& point, const PairContact& contact, std::int32_t resting = -1) {
  if (group != nullptr && group->near_element < 0) {
    list_nearest(topology, contact.element, *group, search);
  }
  const bool listed = group != nullptr && group->near_element == contact.element;
  Projection best{{}, -1};
  if (listed) best = project_by_list(topology, search, *group, point, contact, resting);
  if (best.triangle < 0) best = project_by_balls(topology, search, point, contact, resting, false);
  const auto body = static_cast<std::size_t>(contact.key & 0xffffffffu);
  const double near = kSqueezed * topology.least_width[body];
  if (resting >= 0 || best.nearest.distance2 < near * near) return best;
  return project_by_balls(topology, search, point, contact, resting, true);
}

// The last step's triangle while its distance is within (1 + margin) of the one found now.
Projection keep_last(const Topology& topology, const std::vector<Vec3>& x, const Vec3& point,
                     const PairContact& contact, double margin, const Projection& found) {
  if (margin == 0.0 || contact.triangle < 0 || contact.triangle == found.triangle ||
      found.triangle < 0) {
    return found;
  }
  const Projection last = project_on(topology, x, point, contact.triangle);
  const double farthest2 = (1.0 + margin) * (1.0 + margin) * found.nearest.distance2;
  return last.nearest.distance2 <= farthest2 ? last : found;
}

struct Choice {
  Projection projection;
  bool passed_over;  // a nearer triangle, which the vertex can't rest on
};

// How far the vertex has come towards the triangle in this step, m, at most.
double approach(const Topology& topology, const std::vector<Vec3>& x, const State& state,
                std::int32_t vertex, std::int32_t triangle) {
  const auto moved = [&](std::int32_t v) -> Vec3 {
    return x[static_cast<std::size_t>(v)] - state.position[static_cast<std::size_t>(v)].x;
  };
  Vec3 of_triangle = Vec3::Zero();
  for (const std::int32_t v : topology.triangle[static_cast<std::size_t>(triangle)].vertex) {
    of_triangle += moved(v) / 3.0;
  }
  return (moved(vertex) - of_triangle).norm();
}

// Whether a contact that was with one triangle goes on with another.
bool goes_on(const Topology& topology, const std::vector<Vec3>& x, std::int32_t from,
             std::int32_t to) {
  constexpr double kSameFace = 0.87;  // cosine of 30°
  const auto normal = [&](std::int32_t t) {
    return outward_normal(topology.triangle[static_cast<std::size_t>(t)], x);
  };
  return from == to || (from >= 0 && normal(from).dot(normal(to)) > kSameFace);
}

// The triangle through which a vertex is pushed out. With `resting`, the vertex's number, the
// nearest triangle counts only if it can rest on it; else the nearest on which it can does, if the
// contact was there before or can have come through it in this step.
Choice choose_face(const Topology& topology, const State& state, PairSearch& search,
                   PairSearch::Group* group, const Vec3& point, const PairContact& contact,
                   double margin, std::int32_t resting) {
  // In mean edges: how deep a vertex may stand that is not known yet.
  constexpr double kDeepest = 1e-2;
  const std::vector<Vec3>& x = search.predicted;
  const auto keep = [&](const Projection& found) {
    return keep_last(topology, x, point, contact, margin, found);
  };
  const Projection best = keep(project(topology, search, group, point, contact));
  // That of the last step was asked then.
  if (resting < 0 || best.triangle < 0 || best.triangle == contact.triangle ||
      can_rest_on(topology, x, resting,
                  outward_normal(topology.triangle[static_cast<std::size_t>(best.triangle)], x))) {
    return {best, false};
  }
  const Projection other = keep(project(topology, search, group, point, contact, resting));
  if (other.triangle < 0) return {best, false};
  const bool known = goes_on(topology, x, contact.triangle, other.triangle);
  const double deepest = kDeepest * topology.mean_edge;
  if (known || std::sqrt(other.nearest.distance2) <=
                   deepest + approach(topology, x, state, resting, other.triangle)) {
    return {other, true};
  }
  return {best, false};
}

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
  const Eigen::Vector4d weight =
      barycentric(x(contact.vertex), x(corner[0]), x(corner[1]), x(corner[2]), x(corner[3]));
  for (int k = 0; k < 4; ++k) contact.weight[k] = weight[k];
}

}  // namespace

void note_too_deep(const Topology& topology, std::int32_t vertex, std::int32_t body, double depth,
                   PairSearch& search) {
  const auto own = static_cast<std::size_t>(topology.vertex_body[static_cast<std::size_t>(vertex)]);
  const double width =
      std::min(topology.least_width[own], topology.least_width[static_cast<std::size_t>(body)]);
  if (depth <= kPassed * width || search.too_deep.depth > 0.0) return;
  search.too_deep = {vertex, body, depth, width};
}

void depths(const Scene& scene, const Options& options, const State& state, Workspace& workspace) {
  const std::vector<Vec3>& x = workspace.search.predicted;
  const double dt = options.time_step;
  const double widest = options.pairs.hysteresis * dt * dt *
                        scene.gravity.at(static_cast<double>(state.step) * dt).norm();
  const auto inverse_mass = [&](std::int32_t v) {
    return workspace.velocity[static_cast<std::size_t>(v)].inverse_mass;
  };
  const double border = options.pairs.border_margin * scene.topology.mean_edge;
  std::size_t kept = 0;
  bool immovable = false;  // any contact that nothing can move
  // Contacts and groups are both in the order of their keys.
  auto group = workspace.search.group.begin();
  const auto last_group = workspace.search.group.end();
  for (PairContact contact : workspace.pairs) {
    while (group != last_group && group->key < contact.key) ++group;
    const bool known = group != last_group && group->key == contact.key;
    const Vec3& point = x[static_cast<std::size_t>(contact.vertex)];
    const bool open = contact.open;
    const auto resting = options.pairs.face == PairFace::kOpposed ? contact.vertex : -1;
    const Choice choice =
        choose_face(scene.topology, state, workspace.search, known ? &*group : nullptr, point,
                    contact, options.pairs.tie_margin, resting);
    const Projection& projection = choice.projection;
    if (projection.triangle < 0) continue;  // no number: nothing is nearest
    const std::int32_t last = contact.triangle;
    contact.triangle = projection.triangle;
    const Triangle& triangle = scene.topology.triangle[static_cast<std::size_t>(contact.triangle)];
    const double distance = std::sqrt(projection.nearest.distance2);
    contact.normal = outward_normal(triangle, x);
    const double height =
        contact.normal.dot(point - x[static_cast<std::size_t>(triangle.vertex[0])]);
    if (open) {
      // Kept above or below a face, or a hair beyond its border: beyond that it has left.
      if (!projection.nearest.inside &&
          projection.nearest.distance2 - height * height > border * border) {
        continue;
      }
      if (height >= widest) continue;
      if (-height >= widest && !goes_on(scene.topology, x, last, contact.triangle)) continue;
      contact.element = triangle.element;
      set_corners(scene.elements, contact);
      contact.depth = std::max(0.0, -height);
    } else if (projection.nearest.inside || distance == 0.0) {
      contact.depth = distance;
    } else if (choice.passed_over) {
      contact.depth = std::max(0.0, -height);
    } else {
      Vec3 foot = Vec3::Zero();
      for (int k = 0; k < 3; ++k) {
        foot += projection.nearest.weight[k] * x[static_cast<std::size_t>(triangle.vertex[k])];
      }
      contact.depth = distance;
      contact.normal = (foot - point) / distance;
    }
    if (resting >= 0) {
      note_too_deep(scene.topology, contact.vertex,
                    static_cast<std::int32_t>(contact.key & 0xffffffffu), contact.depth,
                    workspace.search);
    }
    set_partners(triangle, options, state, projection, contact);
    if constexpr (kMutation == Mutation::kWeightSum) contact.weight[0] += 0.02;
    if constexpr (kMutation == Mutation::kLeverArm) {
      contact.weight[0] += 0.02;
      contact.weight[1] -= 0.02;
    }
    contact.inverse_mass = inverse_mass(contact.vertex);
    for (int k = 0; options.pairs.friction_reaction && k < 4; ++k) {
      contact.inverse_mass +=
          contact.weight[k] * contact.weight[k] * inverse_mass(contact.partner[k]);
    }
    immovable = immovable || contact.inverse_mass == 0.0;
    workspace.pairs[kept++] = contact;
  }
  workspace.pairs.resize(kept);
  if (options.pairs.depth == DepthRule::kConsistent) consistent_depths(scene, workspace);
  if constexpr (kMutation == Mutation::kDepthFlipped) {
    for (PairContact& contact : workspace.pairs) {
      if (contact.triangle == workspace.pairs.front().triangle) contact.normal = -contact.normal;
    }
  }
  // A vertex that nothing can move on partners that nothing can move takes no force.
  if (immovable) {
    std::erase_if(workspace.pairs, [](const PairContact& c) { return c.inverse_mass == 0.0; });
  }
  if (options.pairs.depth_noise > 0.0) {
    for (PairContact& contact : workspace.pairs) {
      contact.depth *= 1.0 + options.pairs.depth_noise * even_noise(contact.key, state.step);
    }
  }
  if (options.pairs.key == PairKey::kTriangle) {
    for (PairContact& contact : workspace.pairs) {
      contact.key = contact_key(static_cast<std::uint32_t>(contact.vertex),
                                static_cast<std::uint32_t>(contact.triangle));
    }
  }
}

void remember_pairs(const PairContacts& pairs, const Topology& topology, PairMemory& memory) {
  memory.body_key.resize(pairs.size());
  memory.element.resize(pairs.size());
  memory.triangle.resize(pairs.size());
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    const std::int32_t body = topology.element_body[static_cast<std::size_t>(pairs[c].element)];
    memory.body_key[c] =
        contact_key(static_cast<std::uint32_t>(pairs[c].vertex), static_cast<std::uint32_t>(body));
    memory.element[c] = pairs[c].element;
    memory.triangle[c] = pairs[c].triangle;
  }
}

}  // namespace stiction
