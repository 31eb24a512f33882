// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/detect.h"

#include <algorithm>

#include "solver/detection/boxes.h"
#include "solver/lanes/packed_vec3.h"

namespace stiction {

namespace {

// Of one obstacle, where it will be at the end of a step.
struct ObstacleAtEnd {
  Vec3 normal, point;
};

// Finds which vertices are inside an obstacle.
class FindInside {
 public:
  FindInside(const Scene& scene, Real dt, const std::vector<Position>& position,
             const std::vector<Velocity>& predicted, const PairSearch* bounds)
      : scene_(scene), dt_(dt), position_(position), predicted_(predicted), bounds_(bounds) {}

  // Calls found(vertex, depth) for those of the places [begin, end) of Scene::surface_vertex.
  template <class Found>
  void operator()(const ObstacleAtEnd& obstacle, std::size_t begin, std::size_t end,
                  const Found& found) const {
    if (bounds_ == nullptr) return test(obstacle, begin, end, found);
    const std::vector<Body>& bodies = scene_.bodies;
    auto body = std::partition_point(bodies.begin(), bodies.end(),
                                     [&](const Body& one) { return one.surface_end <= begin; });
    for (; body != bodies.end() && body->surface_begin < end; ++body) {
      // The box is a skin wider than where the body's vertices may be, which is far above round-off.
      const auto b = static_cast<std::size_t>(body - bodies.begin());
      if (clear_of(bounds_->box[b], obstacle.normal, obstacle.point)) continue;
      test(obstacle, std::max(begin, body->surface_begin), std::min(end, body->surface_end), found);
    }
  }

 private:
  template <class Found>
  void test(const ObstacleAtEnd& obstacle, std::size_t begin, std::size_t end,
            const Found& found) const {
    in_registers(
        lane_width(), [&]() __attribute__((always_inline)) {
          const PackedVec3 normal(obstacle.normal), on(obstacle.point);
          const Position* const at = position_.data();
          const Velocity* const with = predicted_.data();
          const Real h = dt_;
          for (std::size_t k = begin; k < end; ++k) {
            const int vertex = scene_.surface_vertex[k];
            const auto v = static_cast<std::size_t>(vertex);
            if (with[v].inverse_mass == 0.0) continue;
            const PackedVec3 x = PackedVec3::load(&at[v]) + h * PackedVec3::load(&with[v]);
            const Real depth = -normal.dot(x - on);
            if (depth > 0.0) found(vertex, depth);
          }
        });
  }

  const Scene& scene_;
  Real dt_;
  const std::vector<Position>& position_;
  const std::vector<Velocity>& predicted_;
  const PairSearch* bounds_;
};

}  // namespace

void detect(const Scene& scene, double dt, const std::vector<Position>& position,
            const std::vector<Velocity>& predicted, OneSidedContacts& contacts, double time,
            const PairSearch* bounds, const Team* team) {
  const FindInside find(scene, static_cast<Real>(dt), position, predicted, bounds);
  const std::size_t count = scene.surface_vertex.size();
  const std::size_t ranges = ranges_of(team, count, kVerticesToShare);
  contacts.clear();
  for (std::size_t o = 0; o < scene.half_spaces.size(); ++o) {
    const HalfSpace& half_space = scene.half_spaces[o];
    const auto number = static_cast<std::int32_t>(o);
    const Vec3 velocity = half_space.motion.mean_velocity(time, dt).cast<Real>();
    const ObstacleAtEnd obstacle{half_space.normal,
                                 half_space.point + half_space.motion.at(time + dt).cast<Real>()};
    if (ranges == 1) {
      find(obstacle, 0, count, [&](std::int32_t vertex, Real depth) {
        contacts.add(contact_key(number, vertex), vertex, number, depth, velocity);
      });
      continue;
    }
    if (contacts.found.size() < ranges) contacts.found.resize(ranges);
    for_each_range(team, count, ranges, [&](std::size_t r, std::size_t begin, std::size_t end) {
      std::vector<OneSidedContacts::Found>& found = contacts.found[r];
      found.clear();
      find(obstacle, begin, end, [&](std::int32_t vertex, Real depth) {
        found.push_back({vertex, depth});
      });
    });
    std::vector<std::size_t> first(ranges + 1, contacts.size());
    for (std::size_t r = 0; r < ranges; ++r) first[r + 1] = first[r] + contacts.found[r].size();
    contacts.resize(first[ranges]);
    for_each(team, ranges, [&](std::size_t r) {
      std::size_t c = first[r];
      for (const auto [vertex, depth] : contacts.found[r]) {
        contacts.set(c++, contact_key(number, vertex), vertex, number, depth, velocity);
      }
    });
  }
}

}  // namespace stiction
