// SPDX-License-Identifier: GPL-3.0-or-later
// In how many poses of a box on a slab a rule comes to rest, over the slope.
#include <fmt/format.h>

#include <algorithm>

#include "validation/comparison/comparison.h"
#include "validation/comparison/scenes.h"
#include "validation/protocols/incline_run.h"
#include "validation/protocols/slab_rest.h"

namespace stiction {

namespace {

constexpr int kCount = 16;
constexpr std::uint32_t kSeed = 3;

void run_poses(CaseRun& run, double slope) {
  int at_rest = 0;
  std::string moving;
  std::vector<double> slips;
  for (SlabSetup setup : random_slabs(kCount, 2, kSeed)) {
    setup.slope = radians(slope);
    const SlabOutcome outcome = bring_to_rest(run, setup, {{"dt", "1e-4"}}, nullptr);
    slips.push_back(outcome.last.fastest_slip);
    if (outcome.at_rest) {
      ++at_rest;
    } else if (moving.empty()) {
      moving = slab_words(setup);
    }
  }
  std::sort(slips.begin(), slips.end());
  run.add(Figure{kPosesAtRest, "1", "a box on a slab comes to rest", static_cast<double>(at_rest)});
  run.add(Figure{kPoses, "1", "that were tried", kCount});
  run.add(Figure{"fastest slip, median pose", "m/s", "at the end", slips[slips.size() / 2]});
  run.add(Figure{"… worst pose", "m/s", "at the end", slips.back()});
  if (!moving.empty()) run.note("The first that did not come to rest: " + moving);
}

}  // namespace

std::vector<Case> comparisons_poses() {
  std::vector<Settings> variants = scalar_and_vector();
  // The stored vector, the paper's rules on quiet ones, and the scalar on
  // consistent depth are told by load/ already.
  std::erase_if(variants, [](const Settings& settings) {
    const bool quiets = settings.at("rule") == "conjugate-vector";
    return settings.at("rule") == "stored-vector" || quiets != !settings.count("depth") ||
           (settings.at("rule") == "fixed-point" && settings.at("depth") == "consistent");
  });
  std::vector<Case> cases;
  for (const double slope : {3.0, 10.0, 20.0}) {
    cases.push_back(
        {.name = fmt::format("poses/slope={}", slope),
         .title = fmt::format("{} random poses of a box on a slab at {}°", kCount, slope),
         .variants = variants,
         .run = [slope](CaseRun& run) { run_poses(run, slope); }});
  }
  return cases;
}

}  // namespace stiction
