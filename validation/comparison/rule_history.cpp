// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/rule_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/demand.h"
#include "solver/friction/catalog.h"
#include "validation/comparison/comparison.h"

namespace stiction {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A body that has left its place by so much of its size did not hold. A load that turns makes a box
// lean by a hundredth of it, and what slides is a body's size away within the steps watched.
constexpr double kLost = 0.05;

std::vector<Vec3> places(const Engine& engine, std::size_t bodies) {
  std::vector<Vec3> all;
  for (std::size_t b = 0; b < bodies; ++b) all.push_back(engine.body(b).position);
  return all;
}

double farthest(const Engine& engine, const std::vector<Vec3>& from) {
  double distance = 0.0;
  for (std::size_t b = 0; b < from.size(); ++b) {
    distance = std::max(distance, (engine.body(b).position - from[b]).norm());
  }
  return distance;
}

void look(Engine& engine, const ComparisonScene& scene, const std::vector<Vec3>& settled,
          RuleHistory& history) {
  for (std::uint64_t k = 0; k < scene.steps; ++k) {
    engine.advance(1);
    const std::vector<ContactSample> contacts = engine.contacts();
    history.turnover.add(contacts);
    history.slips.push_back(slips_of(contacts));
    history.kinetic.push_back(engine.kinetic_energy());
  }
  history.moved = farthest(engine, settled);
  if (history.moved > kLost * scene.size) {
    history.failure = fmt::format("a body moved by {:.2g} mm", 1e3 * history.moved);
  }
}

// A history that plots well: every step at first, then ever fewer.
Series thinned(const std::string& name, const std::string& unit, const std::vector<double>& y) {
  Series series{name, unit, "step", "1", {}, {}};
  double next = 1.0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const auto step = static_cast<double>(k + 1);
    if (step < next && k + 1 < y.size()) continue;
    next = std::max(step + 1.0, 1.03 * step);
    series.x.push_back(step);
    series.y.push_back(y[k]);
  }
  return series;
}

}  // namespace

double RuleHistory::steps_to(double slip, double ContactSlips::*whose) const {
  if (!failure.empty() || slips.empty() || slips.back().*whose > slip) return kInfinity;
  return static_cast<double>(last_above(slip, whose) + 1);
}

double RuleHistory::steps_from(double above, double slip, double ContactSlips::*whose) const {
  const std::size_t begin = last_above(above, whose);
  return begin == 0 && start.*whose < above ? std::nan("")
                                            : steps_to(slip, whose) - static_cast<double>(begin);
}

std::size_t RuleHistory::last_above(double slip, double ContactSlips::*whose) const {
  auto above = slips.size();
  while (above > 0 && slips[above - 1].*whose <= slip) --above;
  return above;
}

double RuleHistory::creep() const {
  if (slips.empty()) return kInfinity;
  const std::size_t last = std::max<std::size_t>(1, slips.size() / 10);
  double sum = 0.0;
  for (std::size_t k = slips.size() - last; k < slips.size(); ++k) {
    if (slips[k].contacts == 0) return kInfinity;  // it has taken off
    sum += slips[k].mean;
  }
  return sum / static_cast<double>(last);
}

double RuleHistory::path() const {
  double sum = 0.0;
  for (const ContactSlips& slip : slips) sum += slip.mean * time_step;
  return sum;
}

RuleHistory run_rule(CaseRun& run, const ComparisonScene& scene, const Settings& extra) {
  RuleHistory history;
  Settled start;
  Settings over = scene.settings;
  const bool settles_itself = !run.engine().program.empty() && scene.settled > 0.0;
  try {
    if (settles_itself) {
      demand(scene.released == 0.0, "a program begins in states at rest alone");
      over["settled"] = fmt::format("{}", scene.settled);
    } else {
      start = settled_without_memory(run.engine(), scene, contacts_of(run.settings()));
    }
  } catch (const InputError& error) {
    history.failure = error.what();
    history.same_hash = true;  // nothing was timed
    return history;
  }
  for (const auto& [name, value] : extra) over[name] = value;
  Settings settings = run.settings();
  for (const auto& [name, value] : over) settings[name] = value;
  const auto looked_at = run.engine().make(settings);
  looked_at->load(scene.problem, {});
  history.start = start.slips;
  if (start.state) looked_at->restore(start.state);
  history.time_step = looked_at->time_step();
  const auto timed = run.simulate_with(over, scene.problem);
  if (start.state) timed->engine().restore(start.state);
  try {
    timed->engine().advance(scene.steps);
  } catch (const InputError& error) {
    history.failure = error.what();
  }
  try {
    look(*looked_at, scene, places(*looked_at, scene.problem.bodies.size()), history);
  } catch (const InputError& error) {
    history.failure = error.what();
  }
  history.same_hash = looked_at->state_hash() == timed->engine().state_hash();
  return history;
}

void check_same_hash(CaseRun& run, bool same) {
  run.check({.quantity = "state hash of the timed run ≠ that of the logged one",
             .unit = "1",
             .statement = "what is timed is what is looked at",
             .source = "the same steps from the same state",
             .kind = ReferenceKind::kExactComputed,
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "yes or no"},
            same ? 0.0 : 1.0);
}

void report_history(CaseRun& run, const RuleHistory& history) {
  check_same_hash(run, history.same_hash);
  const bool held = history.failure.empty();
  run.add(Figure{kStartSlip, "m/s", "that friction has to take away", history.start.mean});
  run.add(Figure{kStepsTo6, "1", "static friction is found again soon", history.steps_to(1e-6)});
  run.add(Figure{kStepsTo9, "1", "static friction is found again soon", history.steps_to(1e-9)});
  run.add(Figure{kFastestTo9, "1", "… by the fastest of the contacts too",
                 history.steps_to(1e-9, &ContactSlips::fastest)});
  run.add(Figure{kCreep, "m/s", "what is held does not creep", history.creep()});
  run.add(Figure{kSlipped, "m", "little is lost before friction is found: sum over the steps",
                 held ? history.path() : kInfinity});
  run.add(Figure{"kinetic energy", "J", "what is held comes to rest: at the end",
                 history.kinetic.empty() ? kInfinity : history.kinetic.back()});
  run.add(Figure{"moved", "m", "what is held stays: farthest body, from the settled state",
                 history.moved});
  run.add(Figure{kSliding, "1", "contacts of which the rule says so at the end",
                 history.slips.empty() ? std::nan("") : history.slips.back().sliding});
  run.add(Figure{"memory", "B", "kept of a contact from step to step",
                 static_cast<double>(friction_memory_bytes(run.settings().at("rule")))});
  if (!held) run.add(Failure{history.failure});
  const Turnover& turnover = history.turnover;
  run.note(fmt::format(
      "Of {:.0f} contacts that carry a load, {} changed their facet and {} lost "
      "their load, summed over {} steps.",
      turnover.mean_loaded(), turnover.facet_changes(), turnover.losses(), history.slips.size()));
  std::vector<double> mean, fastest;
  for (const ContactSlips& slips : history.slips) {
    mean.push_back(slips.mean);
    fastest.push_back(slips.fastest);
  }
  if (mean.empty()) return;
  run.add(thinned("mean contact slip", "m/s", mean));
  run.add(thinned("fastest contact slip", "m/s", fastest));
  run.add(thinned("kinetic energy", "J", history.kinetic));
}

void report_from_sliding(CaseRun& run, const RuleHistory& history) {
  run.add(Figure{kFrom3, "1", "static friction is found within the paper's 8 to 16 steps",
                 history.steps_from(1e-3, 1e-9, &ContactSlips::mean)});
  run.add(Figure{kFastestFrom3, "1", "… by the fastest of the contacts too",
                 history.steps_from(1e-3, 1e-9, &ContactSlips::fastest)});
}

}  // namespace stiction
