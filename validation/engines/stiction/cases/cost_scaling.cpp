// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "reference/statistics/power_law.h"
#include "validation/core/case_run.h"
#include "validation/problems/piles/plates_problem.h"

namespace stiction {

namespace {

const std::vector<std::string> kContactPhases = {"detect", "depth", "normal force", "friction"};
const std::vector<std::string> kPasses = {"forces", "predict", "integrate"};

// What a step of one scene costs, s by phase: of the steps that the engine times the cheapest,
// phase by phase, since whatever else runs on the machine only adds.
struct StepSeconds {
  double contacts = 0.0;  // per step
  std::map<std::string, double> phase;
  double sum(const std::vector<std::string>& phases) const {
    double all = 0.0;
    for (const std::string& one : phases) all += phase.at(one);
    return all;
  }
};

StepSeconds cheapest_step(CaseRun& run, int cells) {
  constexpr int kTimed = 16, kSteps = 6;  // the engine times every 16th step
  const auto simulation = run.simulate(plates_problem({.cells = cells}));
  Engine& engine = simulation->engine();
  engine.advance(kTimed);
  Cost before = engine.cost();
  const Cost warm = before;
  StepSeconds found;
  for (int k = 0; k < kSteps; ++k) {
    engine.advance(kTimed);
    const Cost after = engine.cost();
    for (const auto& [phase, seconds] : after.phase_seconds) {
      const double spent = (seconds - before.phase_seconds.at(phase)) / kTimed;
      const auto known = found.phase.find(phase);
      if (known == found.phase.end() || spent < known->second) found.phase[phase] = spent;
    }
    before = after;
  }
  found.contacts =
      static_cast<double>(before.contact_updates - warm.contact_updates) / (kSteps * kTimed);
  return found;
}

// Time grows faster than the work when a scene no longer fits a cache, and when other programs want
// the same memory. So contact phases are held against phases of the same step that are one pass
// over tetrahedra and vertices, linear whatever they run on. A factor log n (a sort, a tree) would
// add ln(ln n₂/ln n₁)/ln(n₂/n₁) to the exponent between n₁ and n₂ contacts: half of that is the
// bound, so that linear passes and n log n does not.
void run_scaling(CaseRun& run, const std::vector<int>& sizes) {
  std::vector<Series> each;
  for (const std::string& phase : kContactPhases) {
    each.push_back({phase + " per contact", "s", "contacts", "1", {}, {}});
  }
  std::vector<double> contacts, seconds, passes;
  for (const int n : sizes) {
    const StepSeconds step = cheapest_step(run, n);
    std::string words;
    for (std::size_t p = 0; p < kContactPhases.size(); ++p) {
      const double spent = step.phase.at(kContactPhases[p]);
      each[p].x.push_back(step.contacts);
      each[p].y.push_back(spent / step.contacts);
      words += fmt::format(", {} {:.0f}", kContactPhases[p], 1e9 * spent / step.contacts);
    }
    contacts.push_back(step.contacts);
    seconds.push_back(step.sum(kContactPhases));
    passes.push_back(step.sum(kPasses));
    run.note(
        fmt::format("{:.0f} contacts, ns per contact: {:.0f} in all{}; elastic and other "
                    "forces {:.0f}, predict {:.0f}, integrate {:.0f}",
                    step.contacts, 1e9 * seconds.back() / step.contacts, words,
                    1e9 * step.phase.at("forces") / step.contacts,
                    1e9 * step.phase.at("predict") / step.contacts,
                    1e9 * step.phase.at("integrate") / step.contacts));
  }
  const reference::PowerLaw law = reference::fit_power_law(contacts, seconds);
  std::vector<double> ratio;
  for (std::size_t k = 0; k < seconds.size(); ++k) ratio.push_back(seconds[k] / passes[k]);
  const reference::PowerLaw pass = reference::fit_power_law(contacts, passes);
  const reference::PowerLaw beyond = reference::fit_power_law(contacts, ratio);
  const double with_logarithm = std::log(std::log(contacts.back()) / std::log(contacts.front())) /
                                std::log(contacts.back() / contacts.front());
  run.check({.quantity = "exponent of cost over contacts, beyond that of plain passes",
             .unit = "1",
             .statement = "the cost of contact grows no faster than linearly with the contacts",
             .formula = "max(0, p) = 0; time of detect, depth, normal force and friction ÷ time "
                        "of forces, predict and integrate ∝ contactsᵖ",
             .source = "spatial hashing and one pass a phase",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.5 * with_logarithm,
             .reason = fmt::format("half of what a factor log n would add over these sizes, {:.3f}",
                                   with_logarithm)},
            std::max(0.0, beyond.exponent));
  run.note(fmt::format("exponent {:.3f} ± {:.3f} (95 %), of a plain pass {:.3f} ± {:.3f}",
                       law.exponent, law.exponent_margin, pass.exponent, pass.exponent_margin));
  for (Series& series : each) run.add(std::move(series));
}

}  // namespace

std::vector<Case> cases_cost_scaling() {
  return {{.name = "cost/scaling",
           .title = "contact phases from 60 to 60 000 contacts",
           // A claim about times wants a machine with nothing else on it: exponents of 0.051 to
           // 0.058 above one alone, 0.081 beside a compiler.
           .set = CaseSet::kFull,
           .variants = {{{"method", "quiet"}}},
           .run =
               [](CaseRun& run) {
                 run_scaling(run, {5, 10, 20, 42, 85, 173});
               }},
          {.name = "cost/scaling/methods",
           .title = "contact phases from 60 to 200 000 contacts, each method",
           .set = CaseSet::kFull,
           .variants = {{{"method", "paper"}}, {{"method", "quiet"}}},
           .run = [](CaseRun& run) {
             run_scaling(run, {5, 10, 20, 42, 85, 173, 316});
           }}};
}

}  // namespace stiction
