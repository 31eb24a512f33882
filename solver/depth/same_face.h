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
  unsigned stays = 0;                    ///< those whose triangle is known, a bit each
};

/// Whether it is known which triangle `choose_face` chooses, of those near the contact's element: that
/// of the last step, or where it doesn't look at that, the one that was found (staying.h).
inline bool stays_on_face(const Topology& topology, const PairOptions& options,
                          const PairSearch& search, const PairSite& site,
                          const PairSearch::Group& group) {
  const bool looks_back = options.face == PairFace::kOpposed || options.tie_margin > 0.0;
  return group.stays_on >= 0 && group.near_element == site.element &&
         (site.triangle == group.stays_on || (site.triangle < 0 && !looks_back)) &&
         paths(topology, search, group.key) < group.stays_until;
}

/// Whether no other triangle was as near as that of the last step when those near the contact's element
/// were listed. (Of a vertex over a corner or an edge others were.)
inline bool may_stay_on_face(const PairSearch& search, const PairSite& site,
                             const PairSearch::Group& group) {
  if (site.triangle < 0 || group.near_element != site.element) return false;
  const std::int32_t listed = group.near_end - group.near_begin;
  if (listed == 0) return false;
  const PairSearch::Near* const near = &search.near[static_cast<std::size_t>(group.near_begin)];
  const auto body = static_cast<std::size_t>(second_of(group.key));
  return near[0].triangle == site.triangle &&
         (listed == 1 || near[1].distance - near[0].distance > 2 * search.moved[body]);
}

/// Measures those of a batch, one at least, whose triangle is known (`stays`) or to which no other is as
/// near as that of the last step: depth, normal, weights and inverse mass, as `depths` does one at a
/// time, to the bit. Returns the rest, a bit each, which it leaves as they were: those too deep to be
/// sure, those that have left, and those beside their triangle, where it matters what else is near.
/// `width`: of registers, in doubles (lane_width.h), at least the number in the batch.
unsigned measure_on_same_face(const Scene& scene, const PairOptions& options, const State& state,
                              const Workspace& workspace, const OpenLimits& limits, int width,
                              FaceBatch& batch);

}  // namespace stiction
