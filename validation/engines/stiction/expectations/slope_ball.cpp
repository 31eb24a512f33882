// SPDX-License-Identifier: GPL-3.0-or-later
// A ball that rolls, or slides and turns, down a slope.
#include "validation/engines/stiction/expectations/table.h"

namespace stiction {

namespace {

constexpr Cause kPolyhedron{
    "kPolyhedron",
    "the ball is a polyhedron, and goes from edge to edge: at 162, 642 and 1442 surface vertices "
    "the acceleration of the rolling one is 5.2, 5.7 and 2 % too small, that of the sliding one "
    "0.12, 0.16 and 0.04 % too large, and the turning 0.9, 12 and 3 %, and −22, 3 and −0.1 % off",
    kFacetsRoll};

constexpr Words kFacets{
    "kFacets",
    "half as much again to either side of the error at 642 vertices: between the other meshes it "
    "varies threefold; steps of 1, 0.95 and 0.9 change its fourth digit"};

}  // namespace

// clang-format off
Expectations expectations_slope_ball() {
  return {
      {"slope/ball/rolls", "method=quiet", "acceleration", {2.19, 2.33}, kShortfall, kPolyhedron, kFacets},
      {"slope/ball/rolls", "method=quiet", "angular acceleration", {25.3, 28.2}, kShortfall, kPolyhedron, kFacets},
      {"slope/ball/slides", "method=quiet", "acceleration", {2.896, 2.902}, kShortfall, kPolyhedron, kFacets},
      {"slope/ball/slides", "method=quiet", "angular acceleration", {11.7, 12.1}, kShortfall, kPolyhedron, kFacets},
  };
}
// clang-format on

}  // namespace stiction
