// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "reference/limit_analysis.h"
#include "reference/limit_scenes.h"
#include "validation/ball_pyramid_problem.h"
#include "validation/case_run.h"
#include "validation/energy_watch.h"
#include "validation/incline_problem.h"
#include "validation/methods.h"
#include "validation/threshold.h"

namespace stiction {

namespace {

// μ under which the pyramid is loaded and settles: above every threshold found. From that state
// each question continues with its own μ.
constexpr double kSettling = 0.3;
constexpr double kSettled = 1.2;  // s: 0.3 s after the drag has faded out
constexpr double kWatched = 5.0;  // s: at μ = 0.20 the top has sunk by 25 mm within 0.3 s
constexpr double kSunk = 0.05;    // of r

struct Outcome {
  bool stands = true;
  double sunk = 0.0;         // m
  double spread = 0.0;       // m
  double ground_slip = 0.0;  // while it breaks, by normal force, m/s
  double outward = 0.0;      // … of the lower balls' centres, m/s
  double growth = 0.0;       // of the kinetic energy, second half of the window against the first
  // At the end, if it stands:
  double rigid = 0.0;                  // critical μ of smooth balls with centres there
  reference::LimitBracket contacts{};  // … of the contacts that carry a load
};

double mean_ground_slip(const Engine& engine) {
  double slip = 0.0, force = 0.0;
  for (const ContactSample& contact : engine.contacts()) {
    if (contact.against_body) continue;
    slip += contact.normal_force * contact.slip.norm();
    force += contact.normal_force;
  }
  return force > 0.0 ? slip / force : 0.0;
}

class Pyramid {
 public:
  Pyramid(CaseRun& run, const BallPyramidSetup& setup) : run_(run), setup_(setup) {
    setup_.friction = kSettling;
    const auto settling = simulate(setup_.friction);
    Series kinetic{"kinetic energy while settling", "J", "time", "s", {}, {}};
    for (int k = 1; k <= 100; ++k) {
      settling->advance_to(kSettled * k / 100.0);
      kinetic.x.push_back(settling->time());
      kinetic.y.push_back(settling->engine().energies().kinetic);
    }
    run.add(kinetic);
    start_ = settling->engine().save();
    shape_ = pyramid_shape(settling->engine());
    note_settled(settling->engine(), kinetic);
  }

  // Lowers μ to `friction` in the settled state and watches; the record gets the histories on
  // demand.
  Outcome continue_with(double friction, bool keep_series) {
    const auto simulation = simulate(friction);
    Engine& engine = simulation->engine();
    engine.restore(start_);
    simulation->record_frames(0.02);
    const std::string at = fmt::format("μ = {:.2f}", friction);
    Series height{"top ball sunk, " + at, "m", "time", "s", {}, {}};
    Series slip{"ground slip, " + at, "m/s", "time", "s", {}, {}};
    Series speed{"lower balls' speed, " + at, "m/s", "time", "s", {}, {}};
    Outcome outcome;
    int breaking = 0;
    EnergyWatch energy(kSettled, kSettled + kWatched, pyramid_mass());
    for (int k = 1; k <= 2 * EnergyWatch::kSamples; ++k) {
      simulation->advance_to(kSettled + kWatched * k / (2.0 * EnergyWatch::kSamples));
      energy.add(simulation->time(), engine.energies().kinetic);
      if (k % 2 != 0) continue;  // every 5 ms
      const PyramidShape shape = pyramid_shape(engine);
      outcome.sunk = shape_.top_height - shape.top_height;
      outcome.spread = shape.spread - shape_.spread;
      const double slipping = mean_ground_slip(engine);
      height.x.push_back(simulation->time());
      height.y.push_back(outcome.sunk);
      slip.x.push_back(simulation->time());
      slip.y.push_back(slipping);
      speed.x.push_back(simulation->time());
      speed.y.push_back(shape.speed);
      if (outcome.sunk <= kSunk * setup_.radius) continue;
      outcome.stands = false;
      outcome.ground_slip += slipping;
      outcome.outward += shape.speed;
      ++breaking;
      if (outcome.sunk > 5.0 * kSunk * setup_.radius) break;
    }
    if (breaking > 0) {
      outcome.ground_slip /= breaking;
      outcome.outward /= breaking;
    }
    outcome.growth = energy.growth();
    if (outcome.stands) {
      outcome.rigid = pyramid_shape(engine).critical_friction();
      outcome.contacts = reference::critical_friction(limit_problem(engine, setup_));
    }
    if (keep_series) {
      run_.add(height);
      run_.add(slip);
      run_.add(speed);
    }
    return outcome;
  }

 private:
  double pyramid_mass() const {
    double mass = 0.0;
    for (const ProblemBody& body : ball_pyramid_problem(setup_).bodies) mass += body.mass;
    return mass;
  }

  std::unique_ptr<Simulation> simulate(double friction) {
    BallPyramidSetup setup = setup_;
    setup.friction = friction;
    return run_.simulate(ball_pyramid_problem(setup),
                         {{"ball", fmt::format("{}", setup.frequency)}});
  }

  void note_settled(const Engine& engine, const Series& kinetic) {
    double slip = 0.0;
    int between = 0, ground = 0, slipping = 0;
    for (const ContactSample& contact : engine.contacts()) {
      if (!(contact.normal_force > 0.0)) continue;
      (contact.against_body ? between : ground) += 1;
      slipping += !contact.sticks;
      slip = std::max(slip, contact.slip.norm());
    }
    const auto late = kinetic.y.end() - 10;
    run_.note(fmt::format(
        "settled at μ = {}: {} contacts between balls, {} on the ground, {} of them slip, fastest "
        "{:.1e} m/s; kinetic energy up to {:.1e} J in the last 0.12 s. Balls of few facets still "
        "roll towards facets that fit into each other better",
        kSettling, between, ground, slipping, slip, *std::max_element(late, kinetic.y.end())));
  }

  CaseRun& run_;
  BallPyramidSetup setup_;
  Snapshot start_;
  PyramidShape shape_;
};

// Half-width e of the facets of frequency n over the radius: 0.087, 0.043, 0.022 at n = 4, 8, 16.
// Over so much the ground's pressure can move outwards under a lower ball, which lowers the
// critical μ by 0.82 e/r (balance of moments of a lower ball, as for four_ball_thresholds).
double facet(const BallPyramidSetup& setup) { return 0.344 / setup.frequency; }

// Half angle of a lower ball's patch on the ground by Hertz, rad.
double ground_patch(const BallPyramidSetup& setup) {
  const double r = setup.radius;
  const double ball = setup.density * 4.0 / 3.0 * std::numbers::pi * r * r * r;  // kg
  const double force = kStandardGravity * ball * (1.0 + std::pow(setup.ratio, 3) / 3.0);
  const double nu = setup.elasticity.poisson_ratio;
  const double modulus = setup.elasticity.youngs_modulus / (1.0 - nu * nu);
  return std::cbrt(3.0 * force * r / (4.0 * modulus)) / r;
}

void check_paper(CaseRun& run, Pyramid& pyramid, const BallPyramidSetup& setup) {
  const Outcome above = pyramid.continue_with(0.24, true);
  const Outcome below = pyramid.continue_with(0.20, true);
  run.check({.quantity = "stands at μ = 0.24",
             .unit = "1",
             .claim = "the pyramid is stable for μ = 0.24",
             .source = "[Lazarevych2009], sec. 5, Fig. 7",
             .kind = ReferenceKind::kExternal,
             .value = above.stands ? 1.0 : 0.0,
             .expected = 1.0,
             .tolerance = 0.0,
             .reason = "yes or no",
             .worst = fmt::format("top ball sank {:.2f} mm in {} s", 1e3 * above.sunk, kWatched)});
  if (above.stands)
    run.check({.quantity = "growth of kinetic energy at μ = 0.24",
               .unit = "1",
               .claim = "… and while it stands it gains no energy",
               .formula = "max(0, ⟨K⟩(second half)/⟨K⟩(first half) − 1) = 0",
               .source = "static equilibrium: nothing does work on what rests",
               .kind = ReferenceKind::kAnalytic,
               .value = std::max(0.0, above.growth),
               .expected = 0.0,
               .tolerance = EnergyWatch::allowance(),
               .reason = "an undamped vibration's mean over 1000 samples scatters so: 3/√1000"});
  run.check({.quantity = "stands at μ = 0.20",
             .unit = "1",
             .claim = "it breaks for μ = 0.20: the top ball sinks and parts the lower ones",
             .source = "[Lazarevych2009], sec. 5, Fig. 7",
             .kind = ReferenceKind::kExternal,
             .value = below.stands ? 1.0 : 0.0,
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "yes or no",
             .worst = fmt::format("top ball sank {:.2f} mm, lower balls moved out {:.2f} mm",
                                  1e3 * below.sunk, 1e3 * below.spread)});
  if (below.stands) return;
  const double angle = ground_patch(setup) + facet(setup);
  run.check({.quantity = "ground slip ÷ outward speed at μ = 0.20",
             .unit = "1",
             .claim = "while it breaks the lower balls roll, they do not slide on the ground",
             .formula = "⟨u⟩/⟨v⟩ = 0",
             .source = "[Lazarevych2009], sec. 5; μ_ground = 0.1411 < 0.20",
             .kind = ReferenceKind::kAnalytic,
             .value = below.ground_slip / below.outward,
             .expected = 0.0,
             .tolerance = 0.5 * angle * angle,
             .reason = "the patch, of Hertz radius a and out to the facet's edge e beyond, is flat "
                       "where the rolling ball is round: speeds across it differ by "
                       "1 − cos((a + e)/r); sliding would give 1"});
}

void check_threshold(CaseRun& run, Pyramid& pyramid, const BallPyramidSetup& setup, double width) {
  Outcome last;
  const Bracket bracket = find_threshold(kSettling, 0.16, width, [&](double friction) {
    const Outcome outcome = pyramid.continue_with(friction, false);
    if (outcome.stands) last = outcome;
    return outcome.stands;
  });
  const double smooth = reference::four_ball_thresholds(setup.ratio).ball;
  const double flattening = std::max(0.0, last.rigid - smooth);
  run.check(
      {.quantity = "critical μ",
       .unit = "1",
       .claim = "the pyramid breaks below the friction that smooth rigid balls need",
       .formula = "μ_b = tan(θ/2), sin θ = (2/√3)/(1 + R/r)",
       .source = "[Lazarevych2009], sec. 5: ≈ 0.22; derived in full",
       .kind = ReferenceKind::kAnalytic,
       .value = bracket.middle(),
       .expected = smooth,
       .tolerance = 0.82 * facet(setup) + flattening + 0.5 * bracket.width(),
       .reason = fmt::format(
           "a facet of half-width e shifts it by 0.82 e/r = {:.3f}; flattened balls have "
           "nearer centres and need {:.4f} more; half the bracket",
           0.82 * facet(setup), flattening),
       .worst = fmt::format("stands at {:.4f}, breaks at {:.4f}", bracket.holds, bracket.fails)});
  run.check({.quantity = "critical μ below the exact bound of its contacts",
             .unit = "1",
             .claim = "nothing rests with less friction than the contacts it has can do with",
             .formula = "max(0, μ_LP − μ_stands) = 0",
             .source = "limit analysis, proved in rationals, of the contact points at the end",
             .kind = ReferenceKind::kExactComputed,
             .value = std::isnan(bracket.holds)
                          ? bracket.holds
                          : std::max(0.0, last.contacts.lower - bracket.holds),
             .expected = 0.0,
             .tolerance = width,
             .reason = "the bracket's width: the contacts at rest differ between its two ends",
             .worst = fmt::format("μ_LP = {:.5f}", last.contacts.upper)});
  run.note(fmt::format(
      "critical μ in [{:.4f}, {:.4f}]; smooth rigid balls {:.4f}, with their centres where these "
      "balls have them {:.4f}; exact limit analysis of the contacts at the lowest μ that stands: "
      "{:.5f}. That lies lower because it may load each contact point as it likes, and a patch "
      "then resists rolling; elastic pressure does not",
      std::min(bracket.holds, bracket.fails), std::max(bracket.holds, bracket.fails), smooth,
      last.rigid, last.contacts.upper));
}

void run_four_balls(CaseRun& run, const BallPyramidSetup& setup, double width) {
  Pyramid pyramid(run, setup);
  check_paper(run, pyramid, setup);
  const auto method = run.settings().find("method");
  const bool is_old = method != run.settings().end() && method->second == "old";
  if (width > 0.0 && !is_old) check_threshold(run, pyramid, setup, width);
}

BallPyramidSetup balls(int frequency) {
  BallPyramidSetup setup;
  setup.frequency = frequency;
  // So soft that the patches span several facets; 1e6 Pa needs 642 surface vertices for that.
  setup.elasticity.youngs_modulus = 3e5;
  setup.elasticity.damping_time = frequency == 4 ? 3e-4 : 2e-4;
  return setup;
}

Case threshold(int frequency, double width) {
  return {.name = fmt::format("paper/fig7-four-balls/threshold/n={}", frequency),
          .title = fmt::format("least friction of a pyramid of four balls of {} surface vertices",
                               10 * frequency * frequency + 2),
          .set = CaseSet::kFull,
          .variants = {{{"method", "paper"}}, {{"method", "quiet"}}},
          .run = [=](CaseRun& run) { run_four_balls(run, balls(frequency), width); }};
}

}  // namespace

std::vector<Case> cases_four_balls() {
  return {{.name = "paper/fig7-four-balls",
           .title = "a pyramid of four balls of 162 surface vertices stands at μ = 0.24, breaks at "
                    "0.20",
           .variants = method_variants(),
           .run = [](CaseRun& run) { run_four_balls(run, balls(4), 0.0); }},
          threshold(4, 0.005),
          threshold(5, 0.005),
          threshold(6, 0.005),
          threshold(8, 0.005)};
}

}  // namespace stiction
