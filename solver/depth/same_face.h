// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/contact/pair_contacts.h"
#include "solver/contact/pair_options.h"
#include "solver/lanes/lanes.h"
#include "solver/scene/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// Contacts that may have stayed on their face of the last step, to be measured side by side.
struct FaceBatch {
  int count = 0;
  PairContact* contact[kMostLanes];
  PairSearch::Group* group[kMostLanes];  ///< of the contact's key
};

/// Whether it belongs in a batch: inside an element that the triangles near it are listed of, with a
/// triangle of the last step, to which no other was as near when the list was made: a vertex over a
/// corner or an edge has several.
inline bool may_stay_on_face(const PairSearch& search, const PairContact& contact,
                             const PairSearch::Group& group) {
  if (contact.open || contact.triangle < 0 || group.near_element != contact.element) return false;
  const std::int32_t listed = group.near_end - group.near_begin;
  if (listed == 0) return false;
  const PairSearch::Near* const near = &search.near[static_cast<std::size_t>(group.near_begin)];
  const auto body = static_cast<std::size_t>(contact.other);
  return near[0].triangle == contact.triangle &&
         (listed == 1 || near[1].distance - near[0].distance > 2 * search.moved[body]);
}

/// Measures those of a batch, one at least, whose point falls inside their triangle of the last step, none being as
/// near: depth, normal, weights and inverse mass, as `depths` does one at a time, to the bit. Returns
/// the rest, a bit each: it has left them as they were. `width`: of registers, in doubles
/// (lane_width.h), at least the number in the batch.
unsigned measure_on_same_face(const Scene& scene, const PairOptions& options, const State& state,
                              const Workspace& workspace, int width, FaceBatch& batch);

}  // namespace stiction
