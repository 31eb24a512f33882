// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/slab_rest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/problems/slopes/slab_problem.h"

namespace stiction {

namespace {

void check_rest(CaseRun& run, const std::vector<SlabSetup>& setups) {
  std::vector<SlabOutcome> outcomes;
  Series slips{"fastest slip at the end", "m/s", "configuration", "1", {}, {}};
  Series energies{"kinetic energy at the end", "J", "configuration", "1", {}, {}};
  for (const SlabSetup& setup : setups) {
    SlabSeries history;
    const bool shown = outcomes.empty() || outcomes.size() + 1 == setups.size();
    outcomes.push_back(bring_to_rest(run, setup, {}, shown ? &history : nullptr));
    if (shown) history.add_to(run, outcomes.size() == 1 ? " (first)" : " (last)");
    slips.x.push_back(static_cast<double>(outcomes.size()));
    slips.y.push_back(outcomes.back().last.fastest_slip);
    energies.x.push_back(slips.x.back());
    energies.y.push_back(outcomes.back().last.kinetic);
  }
  run.add(std::move(slips));
  run.add(std::move(energies));

  const auto worst = [&](auto value) {
    return static_cast<std::size_t>(
        std::max_element(outcomes.begin(), outcomes.end(),
                         [&](const auto& a, const auto& b) { return value(a) < value(b); }) -
        outcomes.begin());
  };
  const auto count = static_cast<double>(outcomes.size());
  const auto at_rest = static_cast<double>(
      std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.at_rest; }));
  const std::size_t fastest = worst([](const auto& o) { return o.last.fastest_slip; });
  const std::size_t mean = worst([](const auto& o) { return o.last.mean_slip; });
  const std::size_t energetic = worst([](const auto& o) { return o.last.kinetic; });
  const std::string decay =
      "the run goes on while elastic vibration still decays, so only what no longer decays is "
      "left; round-off of velocities of g Δt = 2e-3 m/s leaves some hundred roundings of 4e-19 m/s";
  run.check({.quantity = "share of configurations at rest",
             .unit = "1",
             .statement = "a box on a deformable slab comes to rest below the critical slope",
             .formula = "fastest slip ≤ 1e-12 m/s and kinetic energy ≤ 1e-24 J for half a second",
             .source = "Coulomb's law; [Lazarevych2009], sec. 5",
             .kind = ReferenceKind::kAnalytic,
             .expected = 1.0,
             .tolerance = 0.5 / count,
             .reason = "a count: half a configuration"},
            at_rest / count);
  run.check({.quantity = "fastest contact slip",
             .unit = "m/s",
             .statement = "no contact slips at rest",
             .formula = "u = 0",
             .source = "[Lazarevych2009], (15)",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = kRestSlip,
             .reason = decay},
            outcomes[fastest].last.fastest_slip, slab_words(setups[fastest]));
  run.check({.quantity = "mean contact slip",
             .unit = "m/s",
             .statement = "… nor do they on average, in the worst configuration",
             .formula = "mean |u| = 0",
             .source = "[Lazarevych2009], (15)",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = kRestSlip,
             .reason = decay},
            outcomes[mean].last.mean_slip, slab_words(setups[mean]));
  run.check({.quantity = "kinetic energy",
             .unit = "J",
             .statement = "nothing moves at rest, along the normal as little as along the slab",
             .formula = "E = 0",
             .source = "static equilibrium",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = kRestEnergy,
             .reason = "½ m v² of 1 kg at 1e-12 m/s, twice; " + decay},
            outcomes[energetic].last.kinetic, slab_words(setups[energetic]));
  std::string note = fmt::format("{:.0f} of {:.0f} at rest", at_rest, count);
  if (at_rest < count) {
    note += fmt::format("; the others stalled: their kinetic energy fell by less than half in {} s",
                        kStallWindow);
  }
  run.note(std::move(note));
}

}  // namespace

std::vector<Case> cases_slab_rest() {
  SlabSetup steep;
  steep.slope = 20.0 / 180.0 * std::numbers::pi;
  steep.yaw = 0.3;
  steep.offset = Vec3(0.013, 0.007, 0.0);
  steep.cells = 2;
  steep.slab_cells = 3;
  const auto rest = [](const std::string& name, const std::string& title, CaseSet set,
                       const std::vector<SlabSetup>& setups) {
    return Case{
        .name = "slab/rest/" + name, .title = title, .set = set, .run = [setups](CaseRun& run) {
          check_rest(run, setups);
        }};
  };
  return {rest("one", "a box comes to rest on a deformable slab at 20°", CaseSet::kQuick, {steep}),
          rest("fixed", "twelve chosen poses on a deformable slab come to rest", CaseSet::kDefault,
               fixed_slabs()),
          rest("random", "twenty random poses and meshes come to rest", CaseSet::kDefault,
               random_slabs(20, 2, 1)),
          rest("random-fine", "twenty random poses on finer meshes come to rest", CaseSet::kFull,
               random_slabs(20, 4, 2)),
          {.name = "slab/rest/drift",
           .title = "a box on a deformable slab at 20° does not move in 10 s",
           .run = [steep](CaseRun& run) { check_slab_drift(run, steep); }}};
}

}  // namespace stiction
