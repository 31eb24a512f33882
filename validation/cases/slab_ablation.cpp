// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "validation/slab_rest.h"

namespace stiction {

namespace {

struct Ingredient {
  std::string name;
  Settings settings;
  bool all = false;  // the whole of quiet, which is what the check is about
};

// From the paper's method to quiet, one ingredient after another, then quiet without each.
std::vector<Ingredient> ingredients() {
  const Settings quiet{{"method", "quiet"}};
  const auto without = [&](const std::string& setting, const std::string& value) {
    Settings settings = quiet;
    settings[setting] = value;
    return settings;
  };
  Settings sum{{"method", "paper"}};
  std::vector<Ingredient> list{{"paper", sum}};
  const auto with = [&](const std::string& name, const std::string& setting,
                        const std::string& value) {
    sum[setting] = value;
    list.push_back({name, sum});
  };
  with("+ harmonic gain", "normals", "harmonic");
  with("+ hysteresis", "hysteresis", "20");
  with("+ normals first", "order", "normals-first");
  with("+ stored vector", "rule", "stored-vector");
  with("+ tetrahedral weights", "weights", "tetrahedron");
  with("+ projected depth", "depth", "projection");
  with("+ tie margin = quiet", "tie", "1e-3");
  list.back().all = true;
  list.push_back({"quiet with the paper's gain", without("normals", "paper")});
  list.push_back({"quiet without hysteresis", without("hysteresis", "0")});
  list.push_back({"quiet, hysteresis not counted", without("count-hysteresis", "off")});
  list.push_back({"quiet without tie margin", without("tie", "0")});
  list.push_back({"quiet with consistent depth", without("depth", "consistent")});
  list.push_back({"quiet interleaved", without("order", "interleaved")});
  list.push_back({"quiet with ξ", without("rule", "fixed-point")});
  list.push_back(
      {"paper with the stored vector", {{"method", "paper"}, {"rule", "stored-vector"}}});
  return list;
}

void run_ablation(CaseRun& run, const std::vector<SlabSetup>& setups) {
  Series shares{"share at rest", "1", "ingredient", "1", {}, {}};
  Series slips{"largest fastest slip", "m/s", "ingredient", "1", {}, {}};
  double quiet = 0.0;
  for (const Ingredient& one : ingredients()) {
    int at_rest = 0;
    double fastest = 0.0, kinetic = 0.0;
    for (const SlabSetup& setup : setups) {
      const SlabOutcome outcome = bring_to_rest(run, setup, one.settings, nullptr);
      at_rest += outcome.at_rest;
      fastest = std::max(fastest, outcome.last.fastest_slip);
      kinetic = std::max(kinetic, outcome.last.kinetic);
    }
    const double share = at_rest / static_cast<double>(setups.size());
    if (one.all) quiet = share;
    shares.x.push_back(static_cast<double>(shares.x.size()));
    shares.y.push_back(share);
    slips.x.push_back(shares.x.back());
    slips.y.push_back(fastest);
    run.note(
        fmt::format("{:.0f} {}: {} of {} at rest, fastest slip {:.1e} m/s, kinetic energy "
                    "{:.1e} J",
                    shares.x.back(), one.name, at_rest, setups.size(), fastest, kinetic));
  }
  run.check({.quantity = "share at rest with all ingredients",
             .unit = "1",
             .claim =
                 "harmonic gain, counted hysteresis, normals first, stored vector, "
                 "tetrahedral weights and tie margin together bring every configuration to rest",
             .formula = "fastest slip ≤ 1e-12 m/s and kinetic energy ≤ 1e-24 J",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .value = quiet,
             .expected = 1.0,
             .tolerance = 0.5 / static_cast<double>(setups.size()),
             .reason = "a count: half a configuration"});
  run.add(std::move(shares));
  run.add(std::move(slips));
}

}  // namespace

std::vector<Case> cases_slab_ablation() {
  const auto few = random_slabs(4, 2, 3);
  const auto many = random_slabs(20, 3, 1);
  return {{.name = "slab/ablation",
           .title = "what each ingredient of the quiet method does for rest, four poses",
           .run = [few](CaseRun& run) { run_ablation(run, few); }},
          {.name = "slab/ablation/twenty",
           .title = "what each ingredient of the quiet method does for rest, twenty poses",
           .set = CaseSet::kFull,
           .run = [many](CaseRun& run) { run_ablation(run, many); }}};
}

}  // namespace stiction
