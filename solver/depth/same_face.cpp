// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/same_face.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

#include "solver/depth/face_choice.h"
#include "solver/depth/lane_triangle.h"
#include "solver/depth/nearest_face.h"
#include "solver/detection/detect_pairs.h"
#include "solver/detection/pair_candidates.h"
#include "solver/lanes/in_registers.h"

namespace stiction {

namespace {

struct Step {
  const Scene& scene;
  const PairOptions& options;
  const State& state;
  const Workspace& workspace;
  const OpenLimits& limits;
};

// Of the vertices of a batch, or of their partner of a number, 1/kg.
template <int Bytes>
STICTION_LANES_INLINE Lanes<Bytes> inverse_masses(const Scene& scene, const FaceBatch& batch,
                                                  int partner = -1) {
  const Real* of[Lanes<Bytes>::kCount];
  for (int lane = 0; lane < Lanes<Bytes>::kCount; ++lane) {
    const PairContact& contact = *batch.contact[lane];
    const std::int32_t v = partner < 0 ? contact.vertex : contact.partner[partner];
    of[lane] = &scene.inverse_mass[static_cast<std::size_t>(v)];
  }
  return load_numbers<Bytes>(of);
}

template <int kCorners>
bool has_corner(const std::int32_t* corner, std::int32_t vertex) {
  bool has = false;
  for (int k = 0; k < kCorners; ++k) has |= corner[k] == vertex;
  return has;
}

// Measures the contacts of a batch on their own triangles.
template <int Bytes>
class Measured {
 public:
  using Number = Lanes<Bytes>;
  using Mask = typename Number::Mask;
  static constexpr int kCount = Number::kCount;
  static constexpr int kMostOthers = 8 * kCount;  // compared with the triangles of a batch

  STICTION_LANES_INLINE Measured(const Step& step, FaceBatch& batch)
      : step_(step),
        batch_(batch),
        count_(std::min(batch.count, kCount)),
        point_(at_vertices<Number>(x(), [&](int lane) { return batch.contact[lane]->vertex; })),
        face_{corner(0), corner(1), corner(2)},
        normal_(face_.normal()),
        height_(dot_as_eigen(normal_, point_ - face_.a)),
        nearest_(point_, face_),
        distance_(sqrt(nearest_.distance2)) {}

  unsigned all_of_batch() const { return (1U << count_) - 1; }

  // Those that are left, a bit each.
  STICTION_LANES_INLINE unsigned left() {
    const Number gap(step_.limits.gap), border2(step_.limits.border * step_.limits.border);
    const Number off_plane2 = nearest_.distance2 - height_ * height_;
    unsigned on_itself = 0;
    for (unsigned own = batch_.own; own != 0; own &= own - 1) {
      const int lane = std::countr_zero(own);
      on_itself |= unsigned{is_on_itself(*batch_.contact[lane], *batch_.site[lane])} << lane;
    }
    open_ = Mask::of(batch_.open);
    // A number, and one that is not too deep to be sure.
    const Mask near = is_shallow() & (height_ <= height_);
    const Mask kept = open_ & (height_ < gap) & (off_plane2 <= border2);
    const Mask sure = near & (kept | (nearest_.inside & (~open_ | (height_ < gap))));
    unsigned left = (on_itself | ~sure.bits()) & all_of_batch();
    to_foot_ = sunk_ = Mask::of(0);
    if ((left & batch_.stays) != 0) left &= ~beside(near.bits() & ~on_itself & left);
    // Those that may be on another triangle now, or have one passed over, and of these the ones beside their own.
    const unsigned off =
        (near & ~(open_ | nearest_.inside) & (Number(Real(0)) < nearest_.distance2)).bits() & left &
        ~on_itself;
    const unsigned asked = (all_of_batch() & ~(left | batch_.stays)) | off;
    if (asked == 0) return left;
    const Compared found = compare(asked);
    const unsigned stay = off & ~found.outdone;
    to_foot_ = to_foot_ | Mask::of(stay & ~found.passes_over);
    sunk_ = sunk_ | Mask::of(stay & found.passes_over);
    return (left & ~off) | found.outdone;
  }

  STICTION_LANES_INLINE void write(unsigned left) {
    const auto stays = [left](int lane) { return (left >> lane & 1U) == 0; };
    Number weight[4] = {nearest_.weight[0], nearest_.weight[1], nearest_.weight[2],
                        Number(Real(0))};
    for (int lane = 0; lane < count_; ++lane) {
      if (!stays(lane) || (!of_faces() && !batch_.site[lane]->open)) continue;
      const Partners before(*batch_.contact[lane]);
      set_partners(*batch_.contact[lane], *batch_.site[lane]);
      if (!before.are_of(*batch_.contact[lane])) batch_.acts_elsewhere = true;
    }
    if (!of_faces()) {
      const LaneWeights<Number> weights(start([](const PairContact& c) { return c.vertex; }),
                                        start([](const PairContact& c) { return c.partner[0]; }),
                                        start([](const PairContact& c) { return c.partner[1]; }),
                                        start([](const PairContact& c) { return c.partner[2]; }),
                                        start([](const PairContact& c) { return c.partner[3]; }));
      for (int k = 0; k < 4; ++k) weight[k] = weights.of[k];
    }
    const Scene& scene = step_.scene;
    Number inverse_mass = inverse_masses<Bytes>(scene, batch_);
    for (int k = 0; step_.options.friction_reaction && k < 4; ++k) {
      inverse_mass += weight[k] * weight[k] * inverse_masses<Bytes>(scene, batch_, k);
    }
    FourNumbers plane[kCount], weights[kCount];
    const LaneVector<Number> direction = this->direction();
    store_records(direction.x, direction.y, direction.z, depth(), plane);
    store_records(weight[0], weight[1], weight[2], weight[3], weights);
    static_assert(offsetof(PairContact, depth) == offsetof(PairContact, normal) + 3 * sizeof(Real));
    for (int lane = 0; lane < count_; ++lane) {
      if (!stays(lane)) continue;
      PairContact& contact = *batch_.contact[lane];
      std::memcpy(contact.normal.data(), &plane[lane], sizeof plane[lane]);  // and depth
      std::memcpy(contact.weight, &weights[lane], sizeof weights[lane]);
      contact.inverse_mass = inverse_mass[lane];
      PairSite& site = *batch_.site[lane];
      if (site.excess != 0.0) site.excess = 0.0;
    }
  }

 private:
  // Those less deep in a body than half an element.
  STICTION_LANES_INLINE Mask is_shallow() const {
    const Real least = kSqueezed * topology().thinnest;
    const Mask in_any = nearest_.distance2 < Number(least * least);
    if (all(in_any)) return in_any;
    Real width[kCount];
    for (int lane = 0; lane < kCount; ++lane) {
      width[lane] = topology().least_width[static_cast<std::size_t>(batch_.contact[lane]->other)];
    }
    const Number deepest = Number(kSqueezed) * Number::load(width);
    return nearest_.distance2 < deepest * deepest;
  }

  // Another triangle that may be as near to the vertex of a lane as its own.
  struct Other {
    int lane;
    std::int32_t triangle;
  };
  // Lanes in which `choose_face` may choose another triangle, and those in which it passes over one.
  struct Compared {
    unsigned outdone = 0, passes_over = 0;
  };

  // Compares the own triangles of those asked with others that may be as near, several side by side.
  STICTION_LANES_INLINE Compared compare(unsigned asked) {
    const PairSearch& search = step_.workspace.search;
    const LaneVector<Number> way = point_ - at_vertices<Number>(search.reference, [&](int lane) {
                                     return batch_.contact[lane]->vertex;
                                   });
    Real distance[kCount], moved[kCount], far[kCount];
    store_numbers(distance_, distance);
    store_numbers(sqrt(dot_as_eigen(way, way)), moved);
    store_numbers(sqrt(dot_as_eigen(point_, point_)), far);
    Other other[kMostOthers];
    int count = 0;
    unsigned unnamed = 0;  // lanes in which the list need not name all that are nearer
    Compared found;
    for (int lane = 0; lane < count_; ++lane) {
      if ((asked >> lane & 1U) == 0) continue;
      const PairSearch::Group& group = *batch_.group[lane];
      const std::int32_t own = batch_.site[lane]->triangle;
      // What vertex and triangles have moved since the list was made (project_by_list in nearest_face.cpp).
      moved[lane] += search.moved[static_cast<std::size_t>(batch_.contact[lane]->other)] +
                     list_rounding(search, far[lane]);
      unnamed |= unsigned{distance[lane] + moved[lane] > group.near_reach} << lane;
      const int before = count;
      for (std::int32_t k = group.near_begin; k < group.near_end; ++k) {
        const PairSearch::Near& near = search.near[static_cast<std::size_t>(k)];
        if (near.distance - moved[lane] > distance[lane]) break;
        if (near.triangle == own) continue;
        if (count == kMostOthers) {
          found.outdone |= 1U << lane;
          break;
        }
        other[count++] = {lane, near.triangle};
      }
      if (count > before) batch_.compared |= 1U << lane;
    }
    if (count > 0) compare_with(other, count, found);
    found.outdone |= found.passes_over & unnamed;
    for (int lane = 0; lane < count_; ++lane) {
      if ((found.passes_over & ~found.outdone) >> lane & 1U) {
        found.outdone |= unsigned{!can_rest(lane, batch_.site[lane]->triangle)} << lane;
      }
    }
    return found;
  }

  // As `choose_face` does (face_choice.h): a vertex over its own triangle is kept there while that is as near but
  // for the margin of a tie, one beside it while none is nearer, and either while it can rest on none of those that
  // are. Without a margin equals go by their numbers, which are not looked at here.
  STICTION_LANES_INLINE void compare_with(const Other* other, int count, Compared& found) const {
    const Real margin = step_.options.tie_margin;
    const Real farthest2 = (1 + margin) * (1 + margin);
    const bool may_pass = margin > 0.0 && step_.options.face == PairFace::kOpposed;
    const unsigned over = (nearest_.inside | is_straight(distance_, -height_)).bits();
    Real own2[kCount];
    store_numbers(nearest_.distance2, own2);
    for (int begin = 0; begin < count; begin += kCount) {
      const int end = std::min(begin + kCount, count);
      const auto of = [&](int k) -> const Other& { return other[std::min(begin + k, end - 1)]; };
      const auto corner = [&](int v) __attribute__((always_inline)) {
        return at_vertices<Number>(x(), [&](int k) {
          return topology().triangle[static_cast<std::size_t>(of(k).triangle)].vertex[v];
        });
      };
      const LaneVector<Number> point =
          at_vertices<Number>(x(), [&](int k) { return batch_.contact[of(k).lane]->vertex; });
      const LaneNearest<Number> nearest(point, {corner(0), corner(1), corner(2)});
      Real others2[kCount];
      store_numbers(nearest.distance2, others2);
      for (int k = 0; begin + k < end; ++k) {
        const auto [lane, triangle] = of(k);
        const bool ties = (over >> lane & 1U) != 0;
        const bool keeps = margin > 0.0 ? own2[lane] <= (ties ? farthest2 * others2[k] : others2[k])
                                        : own2[lane] < others2[k];
        if (keeps) continue;
        const bool passes = may_pass && !(found.outdone >> lane & 1U) && !can_rest(lane, triangle);
        (passes ? found.passes_over : found.outdone) |= 1U << lane;
      }
    }
  }
  bool can_rest(int lane, std::int32_t triangle) const {
    return can_rest_on(
        topology(), x(), batch_.contact[lane]->vertex,
        outward_normal(topology().triangle[static_cast<std::size_t>(triangle)], x()));
  }

  // Of those asked the ones beside their face of which it is known whether a nearer one is passed over.
  STICTION_LANES_INLINE unsigned beside(unsigned asked) {
    unsigned known = 0, over = 0;
    for (int lane = 0; lane < count_; ++lane) {
      const std::int8_t passes_over = batch_.group[lane]->passes_over;
      known |= unsigned{passes_over >= 0} << lane;
      over |= unsigned{passes_over == 1} << lane;
    }
    // Off by more than rounding, one that passes over none may have left its triangle for another.
    const Mask passed = Mask::of(over);
    const Mask alone =
        step_.options.tie_margin > 0.0 ? ~(passed | is_straight(distance_, -height_)) : Mask::of(0);
    const Mask found = ~(open_ | nearest_.inside | alone) & (Number(Real(0)) < nearest_.distance2) &
                       Mask::of(known & batch_.stays & asked);
    to_foot_ = found & ~passed;
    sunk_ = found & passed;
    return found.bits();
  }

  STICTION_LANES_INLINE Number depth() const {
    const Number zero(Real(0)), below = -height_;
    const Number sunk = greater(zero, below);
    return choose(open_ | sunk_, sunk, distance_);
  }
  STICTION_LANES_INLINE LaneVector<Number> direction() const {
    if (none(to_foot_)) return normal_;
    const LaneVector<Number> to_foot = nearest_.off / choose(to_foot_, distance_, Number(Real(1)));
    return {choose(to_foot_, to_foot.x, normal_.x), choose(to_foot_, to_foot.y, normal_.y),
            choose(to_foot_, to_foot.z, normal_.z)};
  }

  // Partners that open contacts and those of triangles get.
  void set_partners(PairContact& contact, PairSite& site) const {
    if (site.open) {
      site.element = triangle(site).element;
      set_corners(step_.scene.elements, site.element, contact);
    }
    if (!of_faces()) return;
    for (int k = 0; k < 4; ++k) contact.partner[k] = triangle(site).vertex[std::min(k, 2)];
  }
  // Whether it would be among its own partners. (Detection left those of its element.)
  bool is_on_itself(const PairContact& contact, const PairSite& site) const {
    if (of_faces()) return has_corner<3>(triangle(site).vertex, contact.vertex);
    if (!site.open) return has_corner<4>(contact.partner, contact.vertex);
    const auto element = static_cast<std::size_t>(triangle(site).element);
    return has_corner<4>(&step_.scene.elements[element].vertex[0], contact.vertex);
  }

  STICTION_LANES_INLINE LaneVector<Number> corner(int k) const {
    return at_vertices<Number>(x(),
                               [&](int lane) { return triangle(*batch_.site[lane]).vertex[k]; });
  }
  // Of a vertex of each contact, at the start of the step.
  template <class VertexOf>
  STICTION_LANES_INLINE LaneVector<Number> start(const VertexOf& vertex_of) const {
    return at_vertices<Number>(step_.state.position,
                               [&](int lane) { return vertex_of(*batch_.contact[lane]); });
  }

  bool of_faces() const { return step_.options.weights == PairWeights::kTriangle; }
  const Topology& topology() const { return step_.scene.topology; }
  const std::vector<Vec3>& x() const { return step_.workspace.search.predicted; }
  const Topology::Triangle& triangle(const PairSite& site) const {
    return topology().triangle[static_cast<std::size_t>(site.triangle)];
  }

  const Step& step_;
  FaceBatch& batch_;
  int count_;
  LaneVector<Number> point_;
  LaneTriangle<Number> face_;
  LaneVector<Number> normal_;
  Number height_;
  LaneNearest<Number> nearest_;
  Number distance_;
  Mask open_;
  // Of those beside their face: whose direction is to the nearest point, and whose depth is below the plane.
  Mask to_foot_, sunk_;
};

template <int Bytes>
STICTION_LANES_INLINE unsigned measure(const Step& step, FaceBatch& batch) {
  Measured<Bytes> measured(step, batch);
  const unsigned left = measured.left();
  if (left != measured.all_of_batch()) measured.write(left);
  return left;
}

}  // namespace

unsigned measure_on_same_face(const Scene& scene, const PairOptions& options, const State& state,
                              const Workspace& workspace, const OpenLimits& limits, int width,
                              FaceBatch& batch) {
  for (int lane = batch.count; lane < lanes_of(width); ++lane) {
    batch.contact[lane] = batch.contact[0];
    batch.site[lane] = batch.site[0];
    batch.group[lane] = batch.group[0];
  }
  const Step step{scene, options, state, workspace, limits};
  unsigned left = 0;
  in_lanes(
      batch.count, width, [&](auto bytes) __attribute__((always_inline)) {
        left = measure<bytes>(step, batch);
      });
  return left;
}

}  // namespace stiction
