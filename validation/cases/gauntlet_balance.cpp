// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that balance on one vertex or one edge: their centre of mass lies below it.
#include <fmt/format.h>

#include <cmath>

#include "validation/problems/gauntlet/balance_problem.h"
#include "validation/protocols/gauntlet_rest.h"

namespace stiction {

namespace {

const char* const kBalanceSource = "its centre of mass can come to lie below what carries it";

using BalanceSetups = std::vector<BalanceSetup>;

std::vector<RestOutcome> rest(CaseRun& run, const BalanceSetups& setups, const std::string& claim) {
  std::vector<std::pair<std::string, Problem>> scenes;
  for (const BalanceSetup& setup : setups) {
    scenes.emplace_back(balance_words(setup), balance_problem(setup));
  }
  return check_gauntlet_rest(run, scenes,
                             {.claim = claim, .source = kBalanceSource, .settled = 4.0});
}

Case balance(const char* name, const char* title, CaseSet set, const BalanceSetups& setups,
             const std::string& claim) {
  return {.name = name, .title = title, .set = set, .suite = "stability", .run = [=](CaseRun& run) {
            rest(run, setups, claim);
          }};
}

BalanceSetups vertex_on_flat() {
  return {{.foot = Foot::kSpike, .offset = {7e-3, 4e-3}},
          {.foot = Foot::kSpike, .offset = {6e-3, 0.0}, .foot_yaw = 20.0},
          {.foot = Foot::kSpike}};
}

BalanceSetups spike_on_spike() {
  return {{.perch = Perch::kSpike},
          {.perch = Perch::kSpike, .offset = {2e-3, 1e-3}, .foot_yaw = 20.0}};
}

BalanceSetups spike_in_wedge(double friction) {
  return {{.perch = Perch::kValley, .friction = friction},
          {.perch = Perch::kValley, .foot_yaw = 10.0, .perch_yaw = 40.0, .friction = friction}};
}

BalanceSetups wedge_on_wedge() {
  return {{.foot = Foot::kRidge, .perch = Perch::kRidge, .perch_yaw = 90.0},
          {.foot = Foot::kRidge, .perch = Perch::kRidge, .foot_yaw = 15.0, .perch_yaw = 65.0}};
}

BalanceSetups hook() {
  return {{.foot = Foot::kNone, .perch = Perch::kRidge},
          {.foot = Foot::kNone, .perch = Perch::kRidge, .offset = {-2e-3, 0.0}},
          {.foot = Foot::kNone, .perch = Perch::kRidge, .foot_yaw = 12.0, .perch_yaw = 20.0}};
}

}  // namespace

std::vector<Case> cases_gauntlet_balance() {
  return {balance("gauntlet/vertex-on-flat",
                  "a body that balances on one vertex: over a face, an inner edge, a vertex",
                  CaseSet::kQuick, vertex_on_flat(), "a body that touches at one vertex rests"),
          balance("gauntlet/spike-on-spike", "a body that balances tip on tip", CaseSet::kDefault,
                  spike_on_spike(), "a spike on a blunt spike rests"),
          balance("gauntlet/spike-in-wedge", "a spike in a groove too slippery for one side",
                  CaseSet::kDefault, spike_in_wedge(0.3), "a spike in a groove rests"),
          balance("gauntlet/spike-in-wedge/rough", "a spike in a groove of which one side holds it",
                  CaseSet::kDefault, spike_in_wedge(0.8), "a spike in a groove rests"),
          balance("gauntlet/wedge-on-wedge", "a body that balances ridge across ridge",
                  CaseSet::kDefault, wedge_on_wedge(), "a ridge across a ridge rests"),
          balance("gauntlet/hook", "a hook hung over an edge", CaseSet::kDefault, hook(),
                  "a hook hung over an edge rests")};
}

}  // namespace stiction
