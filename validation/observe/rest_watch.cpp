// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/rest_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "solver/demand.h"
#include "validation/estimate/spread.h"
#include "validation/observe/energy_watch.h"
#include "validation/observe/observe.h"

namespace stiction {

namespace {

double mass_of(const Problem& problem) {
  double mass = 0.0;
  for (const ProblemBody& body : problem.bodies) mass += body.mass;
  return mass;
}

struct Moved {
  double distance = 0.0;  // m
  std::size_t body = 0;
};

class RestRun {
 public:
  RestRun(CaseRun& run, const RestScene& scene, double finer, double given_up)
      : scene_(scene), given_up_(given_up) {
    Accuracy accuracy = scene.accuracy;
    accuracy.finer *= finer;
    simulation_ = run.simulate(scene.problem, accuracy);
    start_ = places();
  }

  Simulation& simulation() { return *simulation_; }

  void settle() { advance(scene_.settled, 200, nullptr, nullptr); }

  // Goes on to `end` (s) and says what happened since it was settled.
  RestOutcome watch(double end, const std::string& how) {
    EnergyWatch energy(scene_.settled, end, mass_of(scene_.problem), rest_speed());
    for (const auto& [time, kinetic] : seen_) energy.add(time, kinetic);
    if (settled_.empty()) settled_ = places();
    RestOutcome outcome;
    outcome.words = scene_.words + (how.empty() ? "" : ", " + how);
    advance(end, 2 * EnergyWatch::kSamples, &energy, &outcome);
    const Moved drift = farthest(settled_), moved = farthest(start_);
    outcome.drift = drift.distance;
    outcome.drifter = scene_.problem.bodies[drift.body].name;
    outcome.moved = moved.distance;
    outcome.growth = energy.growth();
    outcome.growth_allowed = EnergyWatch::allowance();
    outcome.kinetic = energy.second_half();
    outcome.broken = broken_;
    outcome.contacts = contacts_if_told(simulation_->engine());
    for (std::size_t b = 0; b < scene_.problem.bodies.size(); ++b) {
      outcome.motion.push_back(simulation_->engine().body(b));
    }
    if (!broken_.empty()) {
      outcome.drift = outcome.growth = outcome.fastest_slip =
          std::numeric_limits<double>::infinity();
    }
    return outcome;
  }

  void add_series(CaseRun& run) const {
    run.add(kinetic_);
    run.add(slip_);
    run.add(far_);
  }

 private:
  // Coordinates round by half a unit in the last place of the scene's width, which a step turns into a
  // speed.
  double rest_speed() const {
    const double width = bounds_of(scene_.problem).sizes().maxCoeff();
    constexpr double kHalfUlp = 0.5 * std::numeric_limits<double>::epsilon();
    return std::max(EnergyWatch::kRestSpeed, kHalfUlp * width / simulation_->engine().time_step());
  }

  std::vector<Vec3> places() const {
    std::vector<Vec3> all;
    for (std::size_t b = 0; b < scene_.problem.bodies.size(); ++b) {
      all.push_back(simulation_->engine().body(b).position);
    }
    return all;
  }

  Moved farthest(const std::vector<Vec3>& from) const {
    const std::vector<Vec3> now = places();
    Moved moved;
    for (std::size_t b = 0; b < now.size(); ++b) {
      const double distance = (now[b] - from[b]).norm();
      if (distance > moved.distance) moved = {distance, b};
    }
    return moved;
  }

  void advance(double end, int samples, EnergyWatch* energy, RestOutcome* outcome) {
    const double begin = simulation_->time();
    const int every = std::max(samples / 100, 1);  // of a series and of the slip
    for (int k = 1; k <= samples && broken_.empty(); ++k) {
      try {
        simulation_->advance_to(begin + (end - begin) * k / samples);
      } catch (const InputError& error) {
        broken_ = error.what();
        return;
      }
      const double time = simulation_->time();
      const double kinetic = simulation_->engine().kinetic_energy();
      if (energy) {
        energy->add(time, kinetic);
        seen_.emplace_back(time, kinetic);
      }
      if (k % every != 0) continue;
      const double slip = slips_of(simulation_->engine().contacts()).fastest;
      if (outcome && k > samples - samples / 10) {
        outcome->fastest_slip = std::max(outcome->fastest_slip, slip);
      }
      const Moved moved = farthest(start_);
      for (Series* series : {&kinetic_, &slip_, &far_}) series->x.push_back(time);
      kinetic_.y.push_back(kinetic);
      slip_.y.push_back(slip);
      far_.y.push_back(moved.distance);
      if (moved.distance > given_up_) {
        broken_ = fmt::format("given up at {:.2f} s: '{}' has moved {:.0f} mm", time,
                              scene_.problem.bodies[moved.body].name, 1e3 * moved.distance);
      }
    }
  }

  const RestScene& scene_;
  double given_up_;
  CaseRun::Running simulation_;
  std::vector<Vec3> start_, settled_;
  std::vector<std::pair<double, double>> seen_;  // time and kinetic energy since settled
  std::string broken_;
  Series kinetic_{"kinetic energy", "J", "time", "s", {}, {}};
  Series slip_{"fastest contact slip", "m/s", "time", "s", {}, {}};
  Series far_{"farthest body", "m", "time", "s", {}, {}};
};

}  // namespace

std::vector<RestOutcome> watch_rest(CaseRun& run, const RestScene& scene, const Asked& asked,
                                    double given_up, bool shown) {
  std::vector<RestOutcome> outcomes;
  {
    RestRun once(run, scene, 1.0, given_up);
    if (shown) once.simulation().record_frames(0.1);
    once.settle();
    outcomes.push_back(once.watch(scene.settled + scene.window, ""));
    if (asked.twice_the_window) {
      outcomes.push_back(once.watch(scene.settled + 2.0 * scene.window, "twice the window"));
    }
    if (shown) once.add_series(run);
  }
  if (asked.half_the_step) {
    RestRun fine(run, scene, 2.0, given_up);
    fine.settle();
    outcomes.push_back(fine.watch(scene.settled + scene.window, "half the step"));
  }
  return outcomes;
}

void check_rest(CaseRun& run, const std::vector<RestOutcome>& outcomes, const RestBounds& bounds) {
  const auto spread = [&](auto value) { return spread_of(outcomes, value); };
  const Spread drift = spread([](const RestOutcome& o) { return o.drift; });
  const Spread slip = spread([](const RestOutcome& o) { return o.fastest_slip; });
  const Spread growth = spread([](const RestOutcome& o) { return o.growth / o.growth_allowed; });
  const auto at_rest = [&](const RestOutcome& o) {
    return o.drift <= bounds.drift && o.fastest_slip <= bounds.slip && o.growth <= o.growth_allowed;
  };
  if (outcomes.size() > 1) {
    const auto count = static_cast<double>(outcomes.size());
    const auto resting =
        static_cast<double>(std::count_if(outcomes.begin(), outcomes.end(), at_rest));
    const auto first = std::find_if_not(outcomes.begin(), outcomes.end(), at_rest);
    run.check({.quantity = "share at rest",
               .unit = "1",
               .statement = bounds.claim,
               .formula = "drift, slip and growth of energy within the bounds below",
               .source = bounds.source,
               .kind = ReferenceKind::kAnalytic,
               .expected = 1.0,
               .tolerance = 0.5 / count,
               .reason = "a count: half a run"},
              resting / count,
              first == outcomes.end() ? "" : "first that does not: " + first->words);
    run.note(fmt::format("{:.0f} of {:.0f} at rest; drift {}; slip {}", resting, count,
                         spread_words(drift, "m"), spread_words(slip, "m/s")));
  }
  const RestOutcome& farthest = outcomes[drift.worst_at];
  run.check({.quantity = "drift at rest",
             .unit = "m",
             .statement = bounds.claim + ": nothing moves",
             .formula = "x(end of the window) − x(its begin) = 0",
             .source = bounds.source,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = bounds.drift,
             .reason = bounds.drift_reason},
            drift.worst, farthest.words + ", " + farthest.drifter);
  run.check({.quantity = "fastest contact slip",
             .unit = "m/s",
             .statement = bounds.claim + ": no contact slips",
             .formula = "u = 0",
             .source = bounds.source,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = bounds.slip,
             .reason = bounds.slip_reason},
            slip.worst, outcomes[slip.worst_at].words);
  const RestOutcome& growing = outcomes[growth.worst_at];
  run.check({.quantity = "growth of kinetic energy",
             .unit = "1",
             .statement = bounds.claim + ": it gains no energy",
             .formula = "max(0, ⟨K⟩(second half)/⟨K⟩(first half) − 1) = 0",
             .source = "static equilibrium: nothing does work on what rests",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = growing.growth_allowed,
             .reason = "an undamped vibration's mean over n samples scatters so: 3/√1000; what "
                       "moves at less than 1e-12 m/s counts as zero"},
            std::max(0.0, growing.growth), growing.words);
  for (const RestOutcome& outcome : outcomes) {
    if (!outcome.broken.empty()) run.note(outcome.words + ": " + outcome.broken);
  }
}

}  // namespace stiction
