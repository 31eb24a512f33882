// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/demand.h"
#include "validation/engines/stiction/step_rate.h"
#include "validation/problems/slopes/slab_problem.h"
#include "validation/protocols/paper_figure.h"

namespace stiction {

namespace {

// Steps after which a slip stays static, that is, below `kStaticSlip`.
class Found {
 public:
  void add(int step, double slip) {
    if (!(slip <= kStaticSlip)) last_above_ = step;
  }
  int steps() const { return last_above_ + 1; }

 private:
  int last_above_ = 0;
};

Claim steps_claim(const std::string& whose) {
  return {.quantity = "steps until the " + whose + " slip stays below 1e-9 m/s",
          .unit = "1",
          .statement = "static friction is found again in the paper's 8 to 16 steps",
          .formula = "u ≤ 1e-9 m/s from then on",
          .source = "[Lazarevych2009], sec. 5: 8 to 16 steps",
          .kind = ReferenceKind::kExternal,
          .expected = 0.0,
          .tolerance = 16.0,
          .reason = "the paper's largest"};
}

// Factor by which a slip falls in a step at the end of its history: between the highest values of
// two windows, far above round-off.
double rate_at_end(const std::vector<double>& slip) {
  constexpr double kRoundOff = 1e-14;  // m/s: slips at rest are up to 1e-14
  std::size_t end = slip.size();
  while (end > 0 && slip[end - 1] < 10.0 * kRoundOff) --end;
  const std::size_t window = end / 4;
  if (window < 2) return std::nan("");
  const auto highest = [&](std::size_t from) {
    return std::max_element(slip.begin() + static_cast<std::ptrdiff_t>(from),
                            slip.begin() + static_cast<std::ptrdiff_t>(from + window));
  };
  const auto early = highest(end - 2 * window), late = highest(end - window);
  return std::pow(*late / *early, 1.0 / static_cast<double>(late - early));
}

double predicted_rate(const CaseRun& run, const SlabSetup& setup, SlabRun& settled,
                      const Settings& extra) {
  // A state that is not at rest has no Jacobian.
  if (run.settings().at("method") != "quiet") return std::nan("");
  Settings settings = run.settings();
  for (const auto& [name, value] : extra) settings[name] = value;
  settings["dt"] = fmt::format("{}", settled.time_step());
  settings.try_emplace("cells", fmt::format("{}", setup.cells));
  return slowest_rate(slab_problem(setup), settings, settled.engine().save());
}

// What is left behind the friction iteration: shown beside the slowest eigenvalue of the linearised
// step. Per second, not per step, it is the same at either time step (measured: 3.95 and 4.0 1/s),
// hence elastic.
void note_tail(CaseRun& run, double predicted, double observed, double dt) {
  run.show({.quantity = "decay of the slip at the end",
            .unit = "1/s",
            .statement = "what is left decays as the slowest part of the linearised step",
            .formula = "−ln ρ/Δt",
            .source = "eigenvalues of the step's Jacobian, validation/engines/stiction/step_rate.h",
            .kind = ReferenceKind::kExactComputed,
            .expected = -std::log(predicted) / dt,
            .reason = "not judged: several parts of about the same decay swing against each other"},
           -std::log(observed) / dt);
}

// A settled box at 20° whose contacts forget their friction for one step: no friction rule keeps
// what another remembered, so one step with the rule `none` empties the memory and leaves a slip.
// Nothing else is disturbed, so what follows is the friction iteration, and behind it the elastic
// vibration that its first steps have set going.
void run_convergence(CaseRun& run, const SlabSetup& setup, const Settings& extra,
                     bool both_sides_touch) {
  constexpr int kSteps = 3000;
  SlabRun settled(run, setup, {}, extra);
  settled.advance_to(4.0);
  const double dt = settled.time_step();
  const double predicted = predicted_rate(run, setup, settled, extra);
  const bool uses_none = run.settings().count("rule") && run.settings().at("rule") == "none";
  Settings forget = extra;
  forget["rule"] = uses_none ? "fixed-point" : "none";
  forget["sweeps"] = "1";
  SlabRun forgetful(run, setup, {}, forget);
  forgetful.engine().restore(settled.engine().save());
  forgetful.engine().advance(1);
  settled.engine().restore(forgetful.engine().save());

  Series fastest{"fastest contact slip", "m/s", "step", "1", {}, {}};
  Series mean{"mean contact slip", "m/s", "step", "1", {}, {}};
  Series kinetic{"kinetic energy", "J", "step", "1", {}, {}};
  const SlabSample forgotten = forgetful.sample();
  demand(forgotten.fastest_slip > 1e-4, "forgetting friction leaves a slip");
  Found found_mean, found_fastest;
  std::vector<double> slips;
  for (int k = 1; k <= kSteps; ++k) {
    settled.engine().advance(1);
    const SlabSample sample = settled.sample();
    if (k <= 100 || k % 20 == 0) {
      for (Series* series : {&fastest, &mean, &kinetic}) series->x.push_back(k);
      fastest.y.push_back(sample.fastest_slip);
      mean.y.push_back(sample.mean_slip);
      kinetic.y.push_back(sample.kinetic);
    }
    found_mean.add(k, sample.mean_slip);
    found_fastest.add(k, sample.fastest_slip);
    slips.push_back(sample.fastest_slip);
  }
  run.check(steps_claim("mean"), found_mean.steps());
  run.check(steps_claim("fastest contact's"), found_fastest.steps());
  if (run.settings().at("method") == "quiet") note_tail(run, predicted, rate_at_end(slips), dt);
  int of_box = 0, of_slab = 0;
  for (const ContactSample& contact : settled.engine().contacts()) {
    if (contact.normal_force > 0.0) ++(contact.body == 0 ? of_box : of_slab);
  }
  run.note(fmt::format(
      "mean slip {:.1e} m/s, fastest {:.1e} m/s when forgotten; {:.1e} and {:.1e} m/s after 100 "
      "steps. Contacts under load: {} vertices of the box in the slab, {} of the slab in the box. "
      "{}The slip then follows the elastic vibration, which damping takes away, not friction",
      forgotten.mean_slip, forgotten.fastest_slip, mean.y[99], fastest.y[99], of_box, of_slab,
      both_sides_touch ? "Where both sides' vertices touch, their contacts say nearly the same "
                         "twice, and one sweep passes the slip to and fro between them. "
                       : ""));
  run.add(std::move(fastest));
  run.add(std::move(mean));
  run.add(std::move(kinetic));
}

}  // namespace

std::vector<Case> cases_slab_convergence() {
  SlabSetup setup = slab_at_20_degrees();
  setup.elasticity.damping_time = 1e-3;
  std::vector<Settings> variants{{{"method", "paper"}},
                                 {{"method", "paper"}, {"rule", "secant"}},
                                 {{"method", "quiet"}},
                                 {{"method", "quiet"}, {"rule", "stored-vector"}}};
  const auto convergence = [setup](const Settings& extra, bool both_sides_touch) {
    return [=](CaseRun& run) { run_convergence(run, setup, extra, both_sides_touch); };
  };
  return {{.name = "slab/convergence",
           .title = "how fast static friction is found again",
           .variants = variants,
           .run = convergence({}, true)},
          // Depths are a quarter, so that the slab's one vertex no longer reaches into the box.
          {.name = "slab/convergence/half-step",
           .title = "how fast static friction is found again, at half the time step",
           .variants = {variants[0], variants[1], variants[2], variants[3]},
           .run = convergence({{"dt", "1e-4"}}, false)}};
}

}  // namespace stiction
