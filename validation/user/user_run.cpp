// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/user_run.h"

#include <algorithm>
#include <utility>

namespace stiction {

void run_user_problem(CaseRun& run, const UserProblem& user) {
  constexpr int kSeriesSamples = 200;
  const double duration = user.problem.duration;
  std::vector<double> times;
  for (int k = 0; k <= kSeriesSamples; ++k) times.push_back(duration * k / kSeriesSamples);
  for (const UserCheck& one : user.checks) times.insert(times.end(), {one.from, one.at});
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());

  const CaseRun::Running simulation = run.simulate(user.problem);
  Series kinetic{"kinetic energy", "J", "time", "s", {}, {}};
  Series slip{"fastest contact slip", "m/s", "time", "s", {}, {}};
  std::vector<std::pair<Sample, Sample>> seen(user.checks.size());
  for (const double time : times) {
    simulation->advance_to(time);
    const Engine& engine = simulation->engine();
    kinetic.x.push_back(simulation->time());
    kinetic.y.push_back(engine.energies().kinetic);
    slip.x.push_back(simulation->time());
    slip.y.push_back(fastest_slip(engine));
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const UserCheck& one = user.checks[k];
      if (time == one.from) seen[k].first = sample_of(engine, simulation->time(), one.body);
      if (time == one.at) seen[k].second = sample_of(engine, simulation->time(), one.body);
    }
  }
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const UserCheck& one = user.checks[k];
    run.check(one.claim, one.observable->measure(seen[k].first, seen[k].second, one.direction));
  }
  run.add(std::move(kinetic));
  run.add(std::move(slip));
}

}  // namespace stiction
