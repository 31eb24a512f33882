// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/user_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "validation/judge/verdict.h"
#include "validation/user/quantity.h"

namespace stiction {

namespace {

constexpr int kSeriesSamples = 200;
constexpr int kMostBisections = 100;

// A problem as it ran: a value a check.
struct Observed {
  std::vector<double> values{};
  std::vector<Series> series{};
};

std::uint64_t step_at(double time, double time_step) {
  return static_cast<std::uint64_t>(std::llround(time / time_step));
}

// Times that the engine's steps cannot tell apart would compare a state with itself.
void refuse_times(const UserProblem& user, double time_step) {
  for (const UserCheck& one : user.checks) {
    const bool window = one.over_window();
    if (step_at(window ? one.from : 0.0, time_step) < step_at(one.at, time_step)) continue;
    const std::string fault =
        window ? fmt::format("from = {:g} s and at = {:g} s are the same step", one.from, one.at)
               : fmt::format("at = {:g} s is the start", one.at);
    throw InputError(
        fmt::format("{}: {}: the engine's steps of {:g} s are too long for it; set 'dt' in "
                    "[engine] or take other times",
                    one.place, fault, time_step));
  }
}

double measured(const UserWatch& watch, const Sample& from, const Sample& at) {
  return watch.observable->measure(from, at, watch.direction);
}

std::vector<double> times_of(const UserProblem& user) {
  std::vector<double> times;
  const double duration = user.problem.duration;
  for (int k = 0; k <= kSeriesSamples; ++k) times.push_back(duration * k / kSeriesSamples);
  for (const UserCheck& one : user.checks) times.insert(times.end(), {one.from, one.at});
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// What one check has seen so far.
struct Looked {
  std::uint64_t from = 0, at = 0;  // steps
  Sample first{}, last{};
  std::optional<double> extreme{};
  std::optional<std::uint64_t> unsettled{};  // the last step above `settles_below`
};

// What the checks see while a problem runs.
class Looks {
 public:
  Looks(const UserProblem& user, double time_step) : user_(user), time_step_(time_step) {
    for (const UserCheck& one : user.checks) {
      looked_.push_back({step_at(one.from, time_step), step_at(one.at, time_step), {}, {}, {}, {}});
    }
  }

  // Whether some check looks at every step up to this one.
  bool each_step_until(std::uint64_t step) const {
    for (std::size_t k = 0; k < looked_.size(); ++k) {
      const bool within = looked_[k].from < step && step <= looked_[k].at;
      if (within && user_.checks[k].at_each_step()) return true;
    }
    return false;
  }

  void look(Moment& moment, std::uint64_t step) {
    for (std::size_t k = 0; k < looked_.size(); ++k) {
      const UserCheck& one = user_.checks[k];
      Looked& looked = looked_[k];
      if (one.at_each_step()) {
        // Before the first step no contact has been looked for.
        const bool begun = step > 0 || !one.watch.contacts;
        if (begun && looked.from <= step && step <= looked.at) {
          const Sample now = moment.sample(one.watch);
          if (one.settles_below) {
            if (!settled(one, now)) looked.unsettled = step;
          } else {
            widen(one, looked, now);
          }
        }
        continue;
      }
      if (step == looked.from) looked.first = moment.sample(one.watch);
      if (step == looked.at) looked.last = moment.sample(one.watch);
    }
  }

  std::vector<double> values() const {
    std::vector<double> values;
    for (std::size_t k = 0; k < looked_.size(); ++k) {
      const Looked& looked = looked_[k];
      const UserCheck& one = user_.checks[k];
      if (one.settles_below) {
        values.push_back(settling_time(looked));
        continue;
      }
      const double value = one.extreme == Extreme::kNone
                               ? measured(one.watch, looked.first, looked.last)
                               : looked.extreme.value_or(std::numeric_limits<double>::quiet_NaN());
      const double period = one.watch.observable->period;
      const double expected = one.claim.expected;
      values.push_back(period > 0.0 ? expected + std::remainder(value - expected, period) : value);
    }
    return values;
  }

 private:
  // What is no number has not settled, nor has the slip of what touches nothing.
  static bool settled(const UserCheck& one, const Sample& now) {
    return std::abs(measured(one.watch, now, now)) <= *one.settles_below;
  }

  double settling_time(const Looked& looked) const {
    if (!looked.unsettled) return 0.0;
    if (*looked.unsettled >= looked.at) return std::numeric_limits<double>::infinity();
    return static_cast<double>(*looked.unsettled + 1 - looked.from) * time_step_;
  }

  // A value that is no number stays: no check holds with it.
  static void widen(const UserCheck& one, Looked& looked, const Sample& now) {
    if (one.watch.observable->needs_contact && now.contacts.empty()) return;
    const double value = measured(one.watch, now, now);
    const double sign = one.extreme == Extreme::kLargest ? 1.0 : -1.0;
    if (!looked.extreme || std::isnan(value) || sign * value > sign * *looked.extreme) {
      looked.extreme = value;
    }
  }

  const UserProblem& user_;
  double time_step_;
  std::vector<Looked> looked_;
};

Observed observe(CaseRun& run, const UserProblem& user, const Settings& over) {
  const CaseRun::Running simulation = run.simulate_with(over, user.problem);
  const double time_step = simulation->engine().time_step();
  steps_of(user, time_step);
  refuse_times(user, time_step);
  simulation->record_frames(user.problem.duration / kSeriesSamples);
  Observed seen;
  const bool contacts = run.engine().manifest.contacts;
  seen.series = {{"kinetic energy", "J", "time", "s", {}, {}}};
  if (contacts) seen.series.push_back({"fastest contact slip", "m/s", "time", "s", {}, {}});
  const std::size_t own = seen.series.size();
  for (const UserSeries& one : user.series) {
    seen.series.push_back({one.name, shown_unit(one.watch.observable->unit), "time", "s", {}, {}});
  }
  Looks looks(user, time_step);
  for (const double time : times_of(user)) {
    const std::uint64_t target = step_at(time, time_step);
    const Engine& engine = simulation->engine();
    if (looks.each_step_until(target)) {
      while (engine.steps_done() + 1 < target) {
        simulation->advance(1);
        Moment moment(engine, user.problem, simulation->time());
        looks.look(moment, engine.steps_done());
      }
    }
    simulation->advance_to(time);
    Moment moment(engine, user.problem, simulation->time());
    looks.look(moment, target);
    for (Series& one : seen.series) one.x.push_back(simulation->time());
    seen.series[0].y.push_back(engine.kinetic_energy());
    if (contacts) seen.series[1].y.push_back(fastest_slip(engine));
    for (std::size_t k = 0; k < user.series.size(); ++k) {
      const Sample now = moment.sample(user.series[k].watch);
      seen.series[own + k].y.push_back(measured(user.series[k].watch, now, now));
    }
  }
  seen.values = looks.values();
  return seen;
}

// The run's settings with those of the file that a variation changes.
Settings varied_settings(const UserVariation& vary, const UserProblem& there) {
  constexpr std::string_view kEngine = "engine.";
  if (!vary.what.starts_with(kEngine)) return {};
  const std::string name = vary.what.substr(kEngine.size());
  return {{name, there.settings.at(name)}};
}

void run_once(CaseRun& run, const UserProblem& user) {
  Observed seen = observe(run, user, {});
  for (std::size_t k = 0; k < seen.values.size(); ++k) {
    const UserCheck& one = user.checks[k];
    if (one.watch.observable->needs_contact && std::isnan(seen.values[k])) {
      run.note(fmt::format("{}: there was no contact, so there is no {}", one.claim.quantity,
                           one.watch.observable->name));
    }
    run.check(one.claim, seen.values[k]);
  }
  for (Series& one : seen.series) run.add(std::move(one));
}

void run_sweep(CaseRun& run, const UserSweep& sweep) {
  for (const double value : sweep.values) {
    const UserProblem there = sweep.vary.with(value);
    const std::string where = " at " + value_text(sweep.vary.what, sweep.vary.unit, value);
    Observed seen = observe(run, there, varied_settings(sweep.vary, there));
    for (std::size_t k = 0; k < seen.values.size(); ++k) {
      Claim claim = there.checks[k].claim;
      claim.quantity += where;
      run.check(std::move(claim), seen.values[k]);
    }
    for (Series& one : seen.series) {
      one.name += where;
      run.add(std::move(one));
    }
  }
}

// Of the checks at one value: the worst error over its tolerance.
struct Worst {
  double share = -1.0;
  std::string words{};
  bool holds = true;
};

Worst worst_at(CaseRun& run, const UserVariation& vary, double value) {
  const UserProblem there = vary.with(value);
  const Observed seen = observe(run, there, varied_settings(vary, there));
  Worst worst;
  for (std::size_t k = 0; k < seen.values.size(); ++k) {
    const Judgement found = judge(there.checks[k].claim, seen.values[k], 1.0);
    const bool holds = found.verdict == Verdict::kPass;
    const double share = found.of_tolerance;
    if (worst.holds && (!holds || !(share <= worst.share))) {
      worst = {
          share,
          fmt::format("{} is {:.4g} {}", found.claim.quantity, seen.values[k], found.claim.unit),
          holds};
    }
  }
  return worst;
}

void run_threshold(CaseRun& run, const UserThreshold& one) {
  std::vector<std::pair<double, double>> points;
  const auto holds_at = [&](double value, bool expected, bool known) {
    const Worst worst = worst_at(run, one.vary, value);
    points.emplace_back(value, worst.share);
    if (known && worst.holds != expected) {
      throw InputError(fmt::format(
          "{}: at {} {}: {}", one.place, value_text(one.vary.what, one.vary.unit, value),
          expected ? "a check fails already" : "every check still holds", worst.words));
    }
    return worst.holds;
  };
  double holds = one.holds_at, fails = one.fails_at;
  holds_at(holds, true, true);
  holds_at(fails, false, true);
  for (int k = 0; k < kMostBisections && std::abs(fails - holds) > one.within; ++k) {
    const double middle = 0.5 * (holds + fails);
    (holds_at(middle, true, false) ? holds : fails) = middle;
  }
  if (!(std::abs(fails - holds) <= one.within)) {
    throw InputError(
        fmt::format("{}: after {} bisections the threshold is only known to lie between "
                    "{} and {}: bring 'holds_at' and 'fails_at' together",
                    one.place, kMostBisections, value_text(one.vary.what, one.vary.unit, holds),
                    value_text(one.vary.what, one.vary.unit, fails)));
  }
  run.check(one.claim, 0.5 * (holds + fails));
  run.note(fmt::format("holds at {}, fails at {}", value_text(one.vary.what, one.vary.unit, holds),
                       value_text(one.vary.what, one.vary.unit, fails)));
  std::sort(points.begin(), points.end());
  Series series{"worst error over its tolerance", "1", one.vary.what, one.claim.unit, {}, {}};
  for (const auto& [value, share] : points) {
    series.x.push_back(value);
    series.y.push_back(share);
  }
  run.add(std::move(series));
}

}  // namespace

std::uint64_t steps_of(const UserProblem& user, double time_step) {
  constexpr double kMost = 9e15;  // exact in a double
  const double steps = user.problem.duration / time_step;
  if (!(steps < kMost)) {
    throw InputError(
        fmt::format("{}: a duration of {:g} s is {:.1g} steps of {:g} s: more than can "
                    "be counted",
                    user.file, user.problem.duration, steps, time_step));
  }
  if (!(steps > 1.0 - 1e-9)) {
    throw InputError(
        fmt::format("{}: the duration, {:g} s, is shorter than a step of the engine, "
                    "{:g} s: nothing would be simulated",
                    user.file, user.problem.duration, time_step));
  }
  return static_cast<std::uint64_t>(std::llround(steps));
}

int simulations_of(const UserProblem& user) {
  if (user.sweep) return static_cast<int>(user.sweep->values.size());
  if (!user.threshold) return 1;
  const UserThreshold& one = *user.threshold;
  const double halvings =
      std::log2(std::max(1.0, std::abs(one.fails_at - one.holds_at) / one.within));
  return 2 + static_cast<int>(std::min<double>(kMostBisections, std::ceil(halvings)));
}

void run_user_problem(CaseRun& run, const UserProblem& user) {
  if (user.threshold) return run_threshold(run, *user.threshold);
  if (user.sweep) return run_sweep(run, *user.sweep);
  run_once(run, user);
}

}  // namespace stiction
