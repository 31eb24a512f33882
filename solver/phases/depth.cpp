// SPDX-License-Identifier: BSD-3-Clause
#include "solver/phases/depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/hash.h"
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
  Projection best{{Vec3::Zero(), std::numeric_limits<double>::infinity(), false}, -1};
  double reach = std::numeric_limits<double>::infinity();  // distance of the best

  void consider(std::int32_t t) {
    const Projection other = project_on(topology, x, point, t);
    const double nearer = other.nearest.distance2 - best.nearest.distance2;
    if (nearer < 0.0 || (nearer == 0.0 && t < best.triangle)) {
      best = other;
      reach = std::sqrt(best.nearest.distance2);
    }
  }
};

// Of the triangles of the group's list: in the order of their distances at the reference, until
// what vertex and triangles have moved since can't make the next one the nearest.
Projection project_by_list(const Topology& topology, const PairSearch& search,
                           const PairSearch::Group& group, const Vec3& point,
                           const PairContact& contact) {
  const auto vertex = static_cast<std::size_t>(group.key >> 32);
  const auto body = static_cast<std::size_t>(group.key & 0xffffffffu);
  // Far above the round-off of a distance.
  const double rounding = 1e-9 * search.skin + 1e-14 * point.norm();
  const double moved = (point - search.reference[vertex]).norm() + search.moved[body] + rounding;
  Nearest nearest{topology, search.predicted, point};
  if (contact.triangle >= 0) nearest.consider(contact.triangle);
  for (std::int32_t k = group.near_begin; k < group.near_end; ++k) {
    const PairSearch::Near& near = search.near[static_cast<std::size_t>(k)];
    if (near.distance - moved > nearest.reach) break;
    if (near.triangle != contact.triangle) nearest.consider(near.triangle);
  }
  return nearest.best;
}

// Of all triangles near the contact's element, or of the body's where none is near or `everywhere`
// is asked for. Begins with that of the last step, if there was one, so that most others are out of
// reach.
Projection project_by_balls(const Topology& topology, const PairSearch& search, const Vec3& point,
                            const PairContact& contact, bool everywhere) {
  constexpr double kRounding = 1.0 + 1e-12;
  Nearest nearest{topology, search.predicted, point};
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
                   const Vec3& point, const PairContact& contact) {
  if (group != nullptr && group->near_element < 0) {
    list_nearest(topology, contact.element, *group, search);
  }
  const Projection best = group != nullptr && group->near_element == contact.element
                              ? project_by_list(topology, search, *group, point, contact)
                              : project_by_balls(topology, search, point, contact, false);
  const auto body = static_cast<std::size_t>(contact.key & 0xffffffffu);
  const double near = kSqueezed * topology.least_width[body];
  return best.nearest.distance2 < near * near
             ? best
             : project_by_balls(topology, search, point, contact, true);
}

// As `project`, but keeps the last step's triangle while its distance is within (1 + margin) of the
// nearest one's.
Projection project_again(const Topology& topology, PairSearch& search, PairSearch::Group* group,
                         const Vec3& point, const PairContact& contact, double margin) {
  const Projection best = project(topology, search, group, point, contact);
  if (margin == 0.0 || contact.triangle < 0 || contact.triangle == best.triangle ||
      best.triangle < 0) {
    return best;
  }
  const Projection last = project_on(topology, search.predicted, point, contact.triangle);
  const double farthest2 = (1.0 + margin) * (1.0 + margin) * best.nearest.distance2;
  return last.nearest.distance2 <= farthest2 ? last : best;
}

Vec3 outward_normal(const Triangle& triangle, const std::vector<Vec3>& x) {
  const Vec3& a = x[static_cast<std::size_t>(triangle.vertex[0])];
  const Vec3& b = x[static_cast<std::size_t>(triangle.vertex[1])];
  const Vec3& c = x[static_cast<std::size_t>(triangle.vertex[2])];
  return (b - a).cross(c - a).normalized();
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

void depths(const Scene& scene, const Options& options, const State& state, Workspace& workspace) {
  const std::vector<Vec3>& x = workspace.search.predicted;
  const double dt = options.time_step;
  const double widest = options.pairs.hysteresis * dt * dt *
                        scene.gravity.at(static_cast<double>(state.step) * dt).norm();
  const auto inverse_mass = [&](std::int32_t v) {
    return workspace.velocity[static_cast<std::size_t>(v)].inverse_mass;
  };
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
    const Projection projection =
        project_again(scene.topology, workspace.search, known ? &*group : nullptr, point, contact,
                      open ? 0.0 : options.pairs.tie_margin);
    if (projection.triangle < 0) continue;  // no number: nothing is nearest
    contact.triangle = projection.triangle;
    const Triangle& triangle = scene.topology.triangle[static_cast<std::size_t>(contact.triangle)];
    const double distance = std::sqrt(projection.nearest.distance2);
    contact.normal = outward_normal(triangle, x);
    if (open) {
      // Kept only above a face: beyond a border it has left.
      if (!projection.nearest.inside || distance >= widest) continue;
      contact.element = triangle.element;
      set_corners(scene.elements, contact);
      contact.depth = 0.0;
    } else {
      contact.depth = distance;
      if (!projection.nearest.inside && distance > 0.0) {
        Vec3 foot = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
          foot += projection.nearest.weight[k] * x[static_cast<std::size_t>(triangle.vertex[k])];
        }
        contact.normal = (foot - point) / distance;
      }
    }
    set_partners(triangle, options, state, projection, contact);
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
