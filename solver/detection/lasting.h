// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/scene/scene.h"
#include "solver/workspace.h"

namespace stiction {

/// Paths of the two bodies of a key together, m.
inline double paths(const Topology& topology, const PairSearch& search, ContactKey key) {
  const auto own = topology.vertex_body[static_cast<std::size_t>(first_of(key))];
  return search.path[static_cast<std::size_t>(own)] +
         search.path[static_cast<std::size_t>(second_of(key))];
}

/// So many steps in a row something is as it was before it is asked for how long it will be, which takes
/// longer than to find it once more: where bodies move on before that helps, it is asked in vain.
inline constexpr int kStepsToAsk = 4;
/// … and so many more where an answer would hold for less than paths have grown since the last one ended: as
/// bodies move now, to ask takes longer than what it saves.
inline constexpr int kStepsToPause = 28;

/// Something was found at paths of so much, m, as it was in the last step or not (`same`). Counts the
/// steps in a row, and after a few of them asks `within` by how much paths may grow, m, while it is
/// still so: known until then, unless that is too little to be of use.
template <class Within>
void note_lasting(bool same, double path, std::int8_t& steps, double& until, const Within& within) {
  if (!same) {
    steps = 0;
    until = -std::numeric_limits<double>::infinity();
  } else if (++steps == kStepsToAsk) {
    const double more = within();
    const double since = path - until;  // infinite where there was no answer
    const bool in_vain = std::isfinite(since) && more < since;
    steps = in_vain ? -kStepsToPause : 0;
    // Rounded down.
    until = in_vain ? -std::numeric_limits<double>::infinity()
                    : std::nextafter(path + more, -std::numeric_limits<double>::infinity());
  }
}

/// Whether of something that was found as it was in the last step only the steps are to be counted, which
/// is done then: no answer holds, and none is due, as in most steps of bodies that move.
inline bool only_counts(std::int8_t& steps, double until) {
  if (!(until < 0.0 && steps + 1 < kStepsToAsk)) return false;
  ++steps;
  return true;
}

/// For so many steps it is told what is awake, if no body becomes faster than twice what the fastest is.
inline constexpr int kStepsAwake = 16;
inline constexpr double kFaster = 2;

/// Renews what of a list of `count` is awake, unless that is known of this step: all but where
/// `sleeps(place, more)`, which says whether what was found will be while the paths of both bodies grow by
/// `more`, m. In a step they grow by no more than two strides.
template <class Sleeps>
void wake(const PairSearch& search, std::size_t count, const Sleeps& sleeps,
          PairSearch::Awake& awake) {
  if (awake.steps-- > 0 && search.strides <= awake.until) return;
  const double by = kFaster * kStepsAwake * search.stride;
  awake.steps = kStepsAwake - 1;
  awake.until = search.strides + by;
  awake.place.clear();
  for (std::size_t place = 0; place < count; ++place) {
    if (!sleeps(place, 2 * by)) awake.place.push_back(static_cast<std::uint32_t>(place));
  }
}

}  // namespace stiction
