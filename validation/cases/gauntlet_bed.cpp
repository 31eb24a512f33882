// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies on a bed of spikes.
#include "validation/problems/gauntlet/spike_bed_problem.h"
#include "validation/protocols/gauntlet_rest.h"

namespace stiction {

namespace {

using BedSetups = std::vector<SpikeBedSetup>;

Case bed(const char* name, const char* title, const BedSetups& setups, const char* source,
         const char* claim) {
  return {
      .name = name,
      .title = title,
      .set = CaseSet::kDefault,
      .suite = "stability",
      .run = [=](CaseRun& run) {
        std::vector<std::pair<std::string, Problem>> scenes;
        for (const SpikeBedSetup& setup : setups) {
          scenes.emplace_back(spike_bed_words(setup), spike_bed_problem(setup));
        }
        check_gauntlet_rest(
            run, scenes,
            {.claim = claim, .source = source, .settled = 2.6, .window = 0.5, .given_up = 0.03});
      }};
}

BedSetups box() { return {{}, {.shift = {3e-3, 2e-3}, .yaw = 20.0}}; }

// Tip over the corner of four pads, the steeper spike in the blunter ones' valley; and turned, so
// that nothing fits.
BedSetups spikes() {
  const Vec2 valley(0.5 * kBedPad, 0.0);
  return {{.spikes = true, .shift = valley, .drop = -kBedHeight},
          {.spikes = true, .height = 0.015, .shift = valley, .drop = -0.015},
          {.spikes = true, .shift = {4e-3, 3e-3}, .yaw = 20.0}};
}

}  // namespace

std::vector<Case> cases_gauntlet_bed() {
  return {
      bed("gauntlet/spikes-in-bed/box", "a box on the tips of a bed of spikes", box(),
          "its centre of mass lies over the tips", "a box on tips rests"),
      bed("gauntlet/spikes-in-bed", "spikes in the valleys of a bed of spikes", spikes(),
          "four spikes in valleys carry what stands on them", "spikes in a bed of spikes rest")};
}

}  // namespace stiction
