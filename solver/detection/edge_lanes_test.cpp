// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/edge_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <vector>

#include "solver/detection/holding.h"
#include "solver/lanes/lane_width.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

// The edges of the first body with those of the second.
EdgeContacts all_pairs(const Scene& scene) {
  const Topology& topology = scene.topology;
  const auto edges = static_cast<std::int32_t>(topology.sharp_edge.size());
  EdgeContacts pairs;
  for (std::int32_t a = 0; a < edges; ++a) {
    for (std::int32_t b = a + 1; b < edges; ++b) {
      const auto first = [&](std::int32_t e) {
        const auto v = topology.sharp_edge[static_cast<std::size_t>(e)].vertex[0];
        return v < scene.bodies[1].first_vertex;
      };
      if (!first(a) || first(b)) continue;
      EdgeContact pair;
      pair.key = contact_key(a, b);
      pairs.push_back(pair);
    }
  }
  return pairs;
}

std::vector<Vec3> positions(const Scene& scene) {
  std::vector<Vec3> x;
  for (int v = 0; v < scene.vertex_count(); ++v) {
    x.push_back(scene.rest_position.col(v).cast<Real>());
  }
  return x;
}

// One pair of a batch against what is found of it alone; whether it can touch.
bool expect_as_alone(const Topology& topology, const std::vector<Vec3>& x, Real beyond,
                     const EdgeBatch& batch, std::size_t k, bool touches) {
  const auto edge = [&](std::int32_t e) -> const Topology::SharpEdge& {
    return topology.sharp_edge[static_cast<std::size_t>(e)];
  };
  const EndMargins ends{-beyond, -beyond};
  const Real length_a = frame_of(x, edge(batch.a[k])).length,
             length_b = frame_of(x, edge(batch.b[k])).length;
  EdgeCrossing alone;
  const bool can = crossing_of(topology, x, batch.a[k], batch.b[k], alone) &&
                   inside_ends(edge(batch.a[k]), length_a, alone.along_a, ends) >= 0 &&
                   inside_ends(edge(batch.b[k]), length_b, alone.along_b, ends) >= 0;
  EXPECT_EQ(touches, can);
  if (!can || !touches) return can;
  const EdgeCrossing& found = batch.crossing[k];
  EXPECT_EQ(found.along_a, alone.along_a);
  EXPECT_EQ(found.along_b, alone.along_b);
  EXPECT_EQ(found.normal, alone.normal);
  EXPECT_EQ(found.gap, alone.gap);
  EXPECT_EQ(batch.length_a[k], length_a);
  EXPECT_EQ(batch.length_b[k], length_b);
  return can;
}

TEST(EdgeLanes, FindWhatIsFoundOfOneAtEveryWidth) {
  for (const int width : lane_widths()) {
    std::size_t touching = 0;
    int most = 1;
    for (unsigned seed = 0; seed < 60; ++seed) {
      // Of some the edges are exactly parallel, or at right angles: nothing is divided by 0.
      const Scene scene = test::rough_blocks(seed, seed % 6 == 0 ? 0.0 : 0.01);
      const std::vector<Vec3> x = positions(scene);
      const Real beyond = seed % 2 == 0 ? Real(0) : Real(0.01);
      const EdgeContacts pairs = all_pairs(scene);
      for (std::size_t next = 0; next < pairs.size();) {
        EdgeBatch batch;
        for (; batch.count < most && next < pairs.size(); ++next, ++batch.count) {
          batch.a[batch.count] = first_of(pairs[next].key);
          batch.b[batch.count] = second_of(pairs[next].key);
        }
        most = most % lanes_of(width) + 1;
        std::feclearexcept(FE_ALL_EXCEPT);
        const unsigned can = cross_side_by_side(scene.topology, x, beyond, width, batch);
        ASSERT_EQ(std::fetestexcept(FE_INVALID | FE_DIVBYZERO), 0) << "seed " << seed;
        EXPECT_EQ(can >> batch.count, 0u);
        for (int k = 0; k < batch.count; ++k) {
          touching += expect_as_alone(scene.topology, x, beyond, batch, static_cast<std::size_t>(k),
                                      (can >> k & 1U) != 0);
        }
      }
    }
    EXPECT_GT(touching, 300u) << "width " << width;
  }
}

TEST(EdgeLanes, WeighContactsAsOneIsWeighed) {
  const Scene scene = test::rough_blocks(1);
  State state = initial_state(scene);
  std::vector<Velocity> velocity = state.velocity;
  velocity[3].inverse_mass = 0;  // a pinned vertex
  const auto x = [&](std::int32_t v) -> const Vec3& {
    return state.position[static_cast<std::size_t>(v)].x;
  };
  const auto inverse_mass = [&](std::int32_t v) {
    return velocity[static_cast<std::size_t>(v)].inverse_mass;
  };
  for (const int width : lane_widths()) {
    for (const std::size_t count : {0, 1, 2, 3, 7, 8, 29}) {
      EdgeContacts contacts = all_pairs(scene);
      contacts.resize(count);
      for (std::size_t c = 0; c < count; ++c) {
        const auto edge = [&](std::int32_t e) {
          return scene.topology.sharp_edge[static_cast<std::size_t>(e)];
        };
        EdgeContact& contact = contacts[c];
        std::copy_n(edge(first_of(contact.key)).vertex, 2, contact.vertex);
        contact.element = edge(second_of(contact.key)).element;
        contact.own_weight[1] = static_cast<Real>(c) / 31;
        contact.own_weight[0] = 1 - contact.own_weight[1];
      }
      set_partners(scene, state, velocity, width, contacts);
      for (const EdgeContact& contact : contacts) {
        const auto& corner = scene.elements[static_cast<std::size_t>(contact.element)].vertex;
        Vec3 point = Vec3::Zero();
        Real mass = 0;
        for (int k = 0; k < 2; ++k) {
          point += contact.own_weight[k] * x(contact.vertex[k]);
          mass += contact.own_weight[k] * contact.own_weight[k] * inverse_mass(contact.vertex[k]);
        }
        const Vec4 weight =
            barycentric(point, x(corner[0]), x(corner[1]), x(corner[2]), x(corner[3]));
        for (int k = 0; k < 4; ++k) {
          EXPECT_EQ(contact.partner[k], corner[k]);
          EXPECT_EQ(contact.weight[k], weight[k]);
          mass += weight[k] * weight[k] * inverse_mass(corner[k]);
        }
        EXPECT_EQ(contact.inverse_mass, mass);
      }
    }
  }
}

}  // namespace
}  // namespace stiction
