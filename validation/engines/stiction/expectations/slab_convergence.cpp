// SPDX-License-Identifier: GPL-3.0-or-later
// slab/convergence: steps until static friction is found again. 3001 says: not in the 3000 run.
#include "validation/engines/stiction/expectations/table.h"

namespace stiction {

namespace {

constexpr Cause kNever{
    "kNever",
    "neither half of the paper's method gets there alone: ξ on quiet contacts is at 6.7e-6 m/s "
    "after "
    "100 steps (half the step) and never below 1e-9 in 3000, a stored vector on the paper's "
    "contacts is at 3.8e-7. Both replaced: 9 steps",
    kBothHalves};
constexpr Cause kTwice{"kTwice",
                       "one vertex of the slab lies in the box: its contact and those of the box's "
                       "vertices say nearly "
                       "the same twice, and a sweep passes the slip to and fro between them. At "
                       "half the step there is "
                       "no such vertex, and 9 steps do. Conjugate directions (quiet's default) "
                       "take 7 here",
                       kTwiceSaid};
constexpr Cause kOutlasts{"kOutlasts",
                          "the first steps set an elastic vibration going that damping takes away, "
                          "not friction: the mean "
                          "slip stays below after 9 steps, that of one contact swings beyond once "
                          "more until step 33; with "
                          "the vertices numbered in another order after 15",
                          kOutlastsShort};
constexpr Words kNotInRun{"kNotInRun", "a claim of never: not once in the 3000 steps of the run"};
constexpr Words kHalf{
    "kHalf",
    "half as much again either way: the slip falls by the same factor in each step, so that the "
    "steps that it takes hardly depend on where it starts (975 and 982 of two starts)"};

}  // namespace

// clang-format off
Expectations expectations_slab_convergence() {
  return {
      {"slab/convergence*", "method=paper", "steps until the mean slip stays below 1e-9 m/s", {3001, 3001}, kRefuted, kNever, kNotInRun},
      {"slab/convergence*", "method=paper", "steps until the fastest contact's slip stays below 1e-9 m/s", {3001, 3001}, kRefuted, kNever, kNotInRun},
      {"slab/convergence*", "method=paper rule=secant", "steps until the mean slip stays below 1e-9 m/s", {3001, 3001}, kRefuted, kNever, kNotInRun},
      {"slab/convergence*", "method=paper rule=secant", "steps until the fastest contact's slip stays below 1e-9 m/s", {3001, 3001}, kRefuted, kNever, kNotInRun},
      {"slab/convergence", "method=quiet rule=stored-vector", "steps until the mean slip stays below 1e-9 m/s", {650, 1500}, kShortfall, kTwice, kHalf},
      {"slab/convergence", "method=quiet rule=stored-vector", "steps until the fastest contact's slip stays below 1e-9 m/s", {1400, 3300}, kShortfall, kTwice, kHalf},
      {"slab/convergence/half-step", "method=quiet rule=stored-vector", "steps until the fastest contact's slip stays below 1e-9 m/s", {17, 50}, kShortfall, kOutlasts, kHalf},
  };
}
// clang-format on

}  // namespace stiction
