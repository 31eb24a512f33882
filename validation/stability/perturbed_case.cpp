// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/stability/perturbed_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "solver/demand.h"
#include "validation/core/case_run.h"
#include "validation/stability/digits.h"
#include "validation/stability/perturbation.h"

namespace stiction {

namespace {

// One of each kind, of a second or less: free and against a fixed plane, stopped, stuck and at its
// threshold; bodies that are thrown together, rest on each other, are clamped, roll and stick-slip.
struct Chosen {
  const char* name;
  CaseSet set = CaseSet::kDefault;
  bool rests = false;  // nothing moves at its end
};
constexpr Chosen kChosen[] = {{"couple/box/threshold"},
                              {"half-space/free-fall", CaseSet::kQuick},
                              {"impact/oblique/ball/slides"},
                              {"incline/below/creep/90%", CaseSet::kDefault, true},
                              {"incline/below/stop/box", CaseSet::kQuick},
                              {"incline/threshold/mu=0.5/azimuth=30/yaw=20"},
                              {"oscillator/stick-slip"},
                              {"paper/appendix-a-momentum/crossed-bars", CaseSet::kQuick},
                              {"paper/appendix-a-momentum/two-boxes"},
                              {"paper/fig3-clamped-box", CaseSet::kDefault, true},
                              {"push-and-retract/slab/40%", CaseSet::kFull},
                              {"slab/rest/one", CaseSet::kDefault, true},
                              {"stack/rest/n=2", CaseSet::kDefault, true},
                              {"stack/rest/n=5", CaseSet::kFull, true},
                              {"two-body/free-collision"}};

struct Outcome {
  std::vector<Observation> observations;
  std::uint64_t unlike = 0;  // steps that were not the same when taken again
  std::string lacking;       // why it is not applicable
  std::string broken;        // why it broke off
};

Outcome run_once(CaseRun& run, const Case& which, const Perturbation& how) {
  Outcome outcome;
  const auto trace = std::make_shared<PerturbedTrace>();
  try {
    Settings settings = run.settings();
    settings[kPerturbedSetting] = how.name;
    CaseRun part = run.nested(which, perturbed(run.engine(), how, trace), std::move(settings));
    try {
      which.run(part);
    } catch (const NotApplicable& reason) {
      outcome.lacking = reason.what();
    } catch (const InputError& error) {
      outcome.broken = error.what();
    }
    Record record = part.record();
    outcome.observations = observations_of(record, *trace);
    if (outcome.broken.empty()) outcome.broken = record.error;
    record.notes.clear();
    record.error.clear();
    run.include(record, true);
  } catch (const NotApplicable& reason) {
    outcome.lacking = reason.what();
  }
  outcome.unlike = trace->unlike;
  return outcome;
}

class Perturbed {
 public:
  Perturbed(CaseRun& run, const Case& which, bool rests)
      : run_(run), which_(which), rests_(rests) {}

  void check_all() {
    const Outcome& plain = outcome_of("");
    if (!plain.lacking.empty()) throw NotApplicable(plain.lacking);
    if (!plain.broken.empty() && run_.configuration().contrast) {
      throw NotApplicable("it breaks off as it is: " + plain.broken);
    }
    if (!plain.broken.empty()) throw InputError(plain.broken);
    for (const Observation& one : plain.observations) {
      if (std::isnan(one.value)) throw NotApplicable(one.name + " is no number as it is");
    }
    for (const PerturbationGroup& group : perturbation_groups()) check(group);
  }

 private:
  // Runs what has not been run; "": the case as it is.
  const Outcome& outcome_of(const std::string& name) {
    const auto known = outcomes_.find(name);
    if (known != outcomes_.end()) return known->second;
    const Perturbation plain{.name = "plain", .words = "as it is"};
    const Perturbation& how = name.empty() ? plain : find_perturbation(name);
    return outcomes_.emplace(name, run_once(run_, which_, how)).first->second;
  }

  void check(const PerturbationGroup& group) {
    const Outcome& base = outcome_of(group.against);
    if (!base.lacking.empty()) return;
    std::vector<std::vector<Observation>> runs{base.observations};
    std::vector<std::string> words{"as it is"};
    bool other_build = false;
    std::string broken = base.broken;
    for (const Perturbation& how : perturbations()) {
      if (how.group != group.name) continue;
      const Outcome& outcome = outcome_of(how.name);
      if (!outcome.lacking.empty()) {
        run_.note(fmt::format("{}: not applicable: {}", group.name, outcome.lacking));
        return;
      }
      if (!outcome.broken.empty()) broken = how.words + ": " + outcome.broken;
      if (outcome.unlike > 0) {
        broken = fmt::format("{} steps were not the same when taken again", outcome.unlike);
      }
      other_build = other_build || !how.build.empty();
      runs.push_back(outcome.observations);
      words.push_back(how.words);
    }
    const Deviation found =
        broken.empty() ? deviation(runs, words, other_build) : unbounded(broken);
    run_.check({.quantity = group.name,
                .unit = "1",
                .statement = group.statement,
                .formula = "σ/|scale| = 0 of each figure of the case, and of each body's end",
                .source = "invariance of mechanics",
                .kind = ReferenceKind::kExactComputed,
                .expected = 0.0,
                .scale = 1.0,
                .tolerance = rests_ ? group.at_rest : group.tolerance,
                .reason = group.reason},
               found.relative, found.worst);
  }

  CaseRun& run_;
  const Case& which_;
  bool rests_;
  std::map<std::string, Outcome> outcomes_;  // nodes stay where they are
};

}  // namespace

Case perturbed_case(const Case& which, CaseSet set, bool rests) {
  return {.name = "perturbed/" + which.name,
          .title = which.title + ": how many digits survive what must not matter",
          .set = set,
          .suite = "stability",
          .run = [=](CaseRun& run) { Perturbed(run, which, rests).check_all(); }};
}

std::vector<Case> perturbed_cases(const std::vector<Case>& catalog) {
  std::vector<Case> all;
  for (const Chosen& chosen : kChosen) {
    const auto found = std::find_if(catalog.begin(), catalog.end(),
                                    [&](const Case& one) { return one.name == chosen.name; });
    demand(found != catalog.end(), "a case to be perturbed is not in the catalog");
    all.push_back(perturbed_case(*found, chosen.set, chosen.rests));
  }
  return all;
}

}  // namespace stiction
