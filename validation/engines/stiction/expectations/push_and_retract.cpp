// SPDX-License-Identifier: GPL-3.0-or-later
// push-and-retract: a box on a slab that is pushed and let go ends behind its start, twice.
#include "validation/engines/stiction/expectations/table.h"

namespace stiction {

namespace {

constexpr Cause kGivesWay{
    "kGivesWay",
    "the scalar ξ: it holds friction only against a slip that goes on, and when the push is "
    "released "
    "the slab must keep a force that the present free slip does not name. On quiet contacts ξ "
    "leaves "
    "−1.7e-5 m (40 %) and −9.4e-6 m (80 %), as on the paper's; a stored vector on the paper's "
    "contacts springs back not at all",
    kScalarLeaves};
constexpr Cause kVibrates{
    "kVibrates",
    "the scalar ξ: on quiet contacts it leaves 2.3e-11 J (40 %) and 3.5e-11 J (80 %), as on the "
    "paper's, where a stored vector leaves 1.5e-13 and 1.9e-13 J",
    kScalarLeaves};

}  // namespace

// clang-format off
Expectations expectations_push_and_retract() {
  return {
      {"push-and-retract/slab/40%", "method=paper", "spring-back behind the start, after the first push", {-3.1e-05, -7.1e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/40%", "method=paper", "displacement left by the first push", {-3.1e-05, -7.1e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/40%", "method=paper", "displacement added by the second push", {-2.6e-05, -6.1e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/40%", "method=paper", "kinetic energy at the end", {3.9e-12, 2.2e-10}, kShortfall, kVibrates, kNoise},
      {"push-and-retract/slab/40%", "method=paper rule=secant", "spring-back behind the start, after the first push", {-3e-05, -6.9e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/40%", "method=paper rule=secant", "displacement left by the first push", {-3e-05, -6.9e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/40%", "method=paper rule=secant", "displacement added by the second push", {-2.4e-05, -5.7e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/40%", "method=paper rule=secant", "kinetic energy at the end", {2.4e-11, 2.3e-10}, kShortfall, kVibrates, kOneRun},
      {"push-and-retract/slab/80%", "method=paper", "spring-back behind the start, after the first push", {-1.7e-05, -3.3e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/80%", "method=paper", "displacement added by the second push", {-1.3e-05, -2.8e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/80%", "method=paper", "kinetic energy at the end", {7.7e-12, 7.2e-11}, kShortfall, kVibrates, kFactorThree},
      {"push-and-retract/slab/80%", "method=paper rule=secant", "spring-back behind the start, after the first push", {-1.6e-05, -3.4e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/80%", "method=paper rule=secant", "displacement added by the second push", {-1.3e-05, -2.8e-06}, kShortfall, kGivesWay, kFactorTwo},
      {"push-and-retract/slab/80%", "method=paper rule=secant", "kinetic energy at the end", {2.6e-11, 3.1e-09}, kShortfall, kVibrates, kFactorThree},
  };
}
// clang-format on

}  // namespace stiction
