// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/contact/pair_contacts.h"
#include "solver/contact/pair_options.h"
#include "solver/depth/open_limits.h"
#include "solver/detection/lasting.h"
#include "solver/lanes/lanes.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Contacts that may have stayed on their face of the last step, to be measured side by side.
struct FaceBatch {
  int count = 0;
  PairContact* contact[kMostLanes];
  PairSite* site[kMostLanes];            ///< of the contact
  PairSearch::Group* group[kMostLanes];  ///< of the contact's key
  // A bit each:
  unsigned stays = 0;     ///< whose triangle is known
  unsigned open = 0;      ///< whose site is open
  unsigned own = 0;       ///< of a vertex in its own body
  unsigned compared = 0;  ///< that others were compared for, once measured

  bool acts_elsewhere = false;  ///< whether any has other partners than it had, once measured

  void add(const Topology& topology, PairContact& of, PairSite& at, PairSearch::Group& with,
           bool its_triangle_is_known) {
    contact[count] = &of;
    site[count] = &at;
    group[count] = &with;
    const std::int32_t body = topology.vertex_body[static_cast<std::size_t>(of.vertex)];
    stays |= unsigned{its_triangle_is_known} << count;
    open |= unsigned{at.open} << count;
    own |= unsigned{body == of.other} << count;
    ++count;
  }
  /// Of which it is to be noted for how long they have stayed: those that were asked in this step, be it that no
  /// other was near enough to compare.
  unsigned to_note() const { return compared | ~stays; }
  void clear() {
    count = 0;
    stays = open = own = compared = 0;
    acts_elsewhere = false;
  }
};

/// Whether it is known which triangle `choose_face` chooses, of those near the contact's element: that
/// of the last step, or where it doesn't look at that, the one that was found (staying.h).
inline bool stays_on_face(const Topology& topology, const PairOptions& options,
                          const PairSearch& search, const PairSite& site,
                          const PairSearch::Group& group) {
  const bool looks_back = options.face == PairFace::kOpposed || options.tie_margin > 0.0;
  return group.stays_until > 0.0 && group.stays_on >= 0 && group.near_element == site.element &&
         (site.triangle == group.stays_on || (site.triangle < 0 && !looks_back)) &&
         paths(topology, search, group.key) < group.stays_until;
}

/// Whether a contact had a triangle in the last step, and those near its element are listed.
inline bool may_stay_on_face(const PairSite& site, const PairSearch::Group& group) {
  return site.triangle >= 0 && group.near_element == site.element &&
         group.near_begin < group.near_end;
}

/// Measures those of a batch, one at least, whose triangle is known (`stays`) or to which no other is
/// nearer than that of the last step by more than the margin of a tie: depth, normal, weights and inverse
/// mass, as `depths` does one at a time, to the bit. Returns the rest, a bit each, which it leaves as
/// they were: those too deep to be sure and those that have left.
/// `width`: of registers, in doubles (lane_width.h), at least the number in the batch.
unsigned measure_on_same_face(const Scene& scene, const PairOptions& options, const State& state,
                              const Workspace& workspace, const OpenLimits& limits, int width,
                              FaceBatch& batch);

}  // namespace stiction
