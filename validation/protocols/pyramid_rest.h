// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/problems/piles/pyramid_problem.h"

namespace stiction {

/// Centres of the boxes, row by row from below, m.
std::vector<Vec3> box_places(const Engine& engine, const PyramidSetup& setup);

/// The largest displacement of a box, and whose.
struct BoxMoved {
  double distance = 0.0;  ///< m
  int box = 0;            ///< from 1
};
BoxMoved farthest_box(const std::vector<Vec3>& from, const std::vector<Vec3>& to);

/// What Fig. 5 shows, over time.
struct PyramidSeries {
  std::vector<double> time, kinetic, slip, moved;
  void sample(const Simulation& simulation, const PyramidSetup& setup,
              const std::vector<Vec3>& start);
  void add_to(CaseRun& run) const;
};

/// What a run left: the joints' slips in the window at rest, and how far it came in all.
struct PyramidAtRest {
  BoxMoved whole;             ///< from the start
  double broken_at = -1.0;    ///< time at which the pyramid was in pieces, s; −1: it is whole
  double before_tilt = 0.0;   ///< of `whole`, m
  std::vector<double> slips;  ///< of the joints over the window, m; empty when broken
  double fastest = 0.0;       ///< contact slip at the end, m/s
  double kinetic = 0.0;       ///< at the end, J
  double dt = 0.0;            ///< s
  double downhill() const { return std::max(0.0, *std::max_element(slips.begin(), slips.end())); }
  double uphill() const { return std::max(0.0, -*std::min_element(slips.begin(), slips.end())); }
  double farthest() const { return std::max(downhill(), uphill()); }
};

/// Tilts the pyramid, lets it settle and watches it over `window` (s), with steps `finer` times as
/// short as the engine's; until a box has moved half its width. `series` may be null.
PyramidAtRest pyramid_at_rest(CaseRun& run, const PyramidSetup& setup, double window, double finer,
                              PyramidSeries* series);

}  // namespace stiction
