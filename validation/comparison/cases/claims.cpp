// SPDX-License-Identifier: GPL-3.0-or-later
// The claims of the paper once more, in both readings of its iteration (one scalar ξ a contact as
// printed, or the tangential bias vector) and with both depths (to the nearest face, or consistent
// as sec. 3.2 has it). The scenes and their checks are those of `validate`; here it is counted how
// many of a case's checks hold.
#include <algorithm>
#include <stdexcept>

#include "validation/comparison/comparison.h"

namespace stiction {

namespace {

struct PaperClaim {
  std::string name, title;
  std::vector<std::string> cases;  // of the catalog of validate
};

const std::vector<PaperClaim>& claims() {
  static const std::vector<PaperClaim> all = {
      {"rigid-plane",
       "a box on a rigid plane stops, keeps its speed or speeds up as Coulomb's law has it",
       {"incline/threshold/mu=0.3/azimuth=30/yaw=0", "incline/below/stop/box",
        "incline/below/creep/99%", "incline/at-critical", "incline/above"}},
      {"fig3", "a box between two offset bars stays where it is", {"paper/fig3-clamped-box"}},
      {"fig4", "a box slides down an inclined membrane", {"paper/fig4-membrane"}},
      {"fig5", "a pyramid of boxes rests on a slope", {"paper/fig5-box-pyramid"}},
      {"fig6", "20 objects come to rest in a basket", {"paper/fig6-basket/objects=20"}},
      {"fig7", "four balls stand at μ = 0.24 and break at 0.20", {"paper/fig7-four-balls"}},
      {"rest", "a box comes to rest on a deformable slab, in twelve poses", {"slab/rest/fixed"}},
      {"steps", "from the loss of memory to 1e-9 m/s", {"slab/convergence/half-step"}},
      {"momentum", "post-correction keeps the momentum", {"paper/appendix-a-momentum"}}};
  return all;
}

// The case of validate that has this name, or those of the default set in the folder of this name.
std::vector<Case> meant(const std::string& name, const EngineKind& engine) {
  std::vector<Case> found;
  for (Case& one : cases_for(engine)) {
    if (one.name == name) return {std::move(one)};
    if (one.set != CaseSet::kFull && one.name.starts_with(name + "/")) {
      found.push_back(std::move(one));
    }
  }
  if (found.empty()) throw std::logic_error("no case of validate is named " + name);
  return found;
}

void run_claim(CaseRun& run, const PaperClaim& claim) {
  run.passages_are_noted();
  int met = 0, count = 0;
  for (const std::string& name : claim.cases) {
    for (const Case& one : meant(name, run.engine())) {
      CaseRun part = run.part(run.settings());
      one.run(part);
      const Record record = part.record();
      run.include(record, true);
      for (const Judgement& check : record.checks) {
        met += check.verdict == Verdict::kPass;
        count += check.verdict != Verdict::kForInformation;
        run.show(check.claim, check.value);
      }
    }
  }
  run.add(Figure{"checks of the claim that hold", "1", "more is better", static_cast<double>(met)});
  run.add(Figure{"checks of the claim", "1", "that were made", static_cast<double>(count)});
  run.add(Figure{"share of the claim that holds", "1", "1: all of it",
                 static_cast<double>(met) / std::max(count, 1)});
}

}  // namespace

std::vector<Case> comparisons_claims() {
  std::vector<Settings> variants;
  for (const char* rule : {"fixed-point", "bias-vector"}) {
    for (const char* depth : {"projection", "consistent"}) {
      variants.push_back({{"method", "paper"}, {"depth", depth}, {"rule", rule}});
    }
  }
  std::vector<Case> cases;
  for (const PaperClaim& claim : claims()) {
    cases.push_back({.name = "claims/" + claim.name,
                     .title = claim.title,
                     .set = CaseSet::kFull,
                     .variants = variants,
                     .run = [claim](CaseRun& run) { run_claim(run, claim); }});
  }
  return cases;
}

}  // namespace stiction
