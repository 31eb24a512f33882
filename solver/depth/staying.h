// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/contact/pair_options.h"
#include "solver/depth/nearest_face.h"
#include "solver/detection/lasting.h"

namespace stiction {

/// For how long a contact stays on its triangle.
struct Staying {
  Real within = 0.0;             ///< vertex and triangles may move so far, both together, m
  std::int8_t passes_over = -1;  ///< until then: PairSearch::Group::passes_over
};

/// How far vertex and triangles may still move while `choose_face` (face_choice.h) still chooses the
/// triangle that a contact is on, as long as the vertex is over it or beside it by no more than rounding;
/// of those near its element, which must be listed in its group; 0 or less where that is not known, or it
/// is not among them.
///
///   own distance d₀, another triangle's d, margin of a tie m:   ((1 + m) d − d₀)/(2 + m)
///
/// since both distances change by no more than is moved. Where the two share a corner or an edge, while
/// the way from there to the vertex is so close to the other's normal that they tie. Where the vertex
/// can't rest on the other, but can on its own, a share of edges and heights by which neither changes:
/// no direction of these turns by so much.
Staying stays_within(const Topology& topology, const PairOptions& options, const PairSearch& search,
                     const PairSearch::Group& group, const PairSite& site);

/// Asks for how long, where it is time to, and starts anew where it is on another triangle.
void note_change_of_staying(const Topology& topology, const PairOptions& options,
                            const PairSearch& search, const PairSite& site,
                            PairSearch::Group& group);

/// Keeps count of the steps in which a contact has stayed on its triangle, and after a few of them
/// asks for how long it will.
inline void note_staying(const Topology& topology, const PairOptions& options,
                         const PairSearch& search, const PairSite& site, PairSearch::Group& group) {
  const bool same = site.triangle == group.stays_on && group.near_element == site.element;
  if (same && only_counts(group.stayed, group.stays_until)) return;
  note_change_of_staying(topology, options, search, site, group);
}

}  // namespace stiction
