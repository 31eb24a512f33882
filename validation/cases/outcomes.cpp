// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of a scene at its threshold, asked of ten that differ in their last bits: a frequency,
// not one run. Beside the threshold all must agree.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "validation/protocols/ball_pyramid_run.h"
#include "validation/protocols/incline_run.h"
#include "validation/protocols/incline_threshold.h"
#include "validation/stability/outcome_frequency.h"

namespace stiction {

namespace {

// Beside a threshold, or at it.
struct Level {
  std::string words;    // "tan θ = μ (1 + 1e-06)"
  double x = 0.0;       // where it stands in the diagram
  bool beyond = false;  // the threshold
  bool decided = true;  // farther from it than it is known to
};

// Where the threshold lies, and what comes out beyond it.
struct Question {
  const char* what;      // "slides"
  const char* x_name;    // of the diagram
  const char* source;    // of the threshold
  const char* known_to;  // how far it is known
};

// `ask`: whether it comes out so, of a level and on a perturbed engine.
void check_shares(CaseRun& run, const Question& question, const std::vector<Level>& levels,
                  const std::function<bool(CaseRun&, const Level&)>& ask) {
  Series series{.name = fmt::format("share that {}", question.what),
                .unit = "1",
                .x_name = question.x_name,
                .x_unit = "1"};
  for (const Level& level : levels) {
    const OutcomeFrequency found =
        outcome_frequency(run, [&](CaseRun& part) { return ask(part, level); });
    series.x.push_back(level.x);
    series.y.push_back(found.share());
    Claim claim{.quantity = fmt::format("share that {}, {}", question.what, level.words),
                .unit = "1",
                .statement =
                    "beside its threshold a scene comes out one way, whatever its last "
                    "bits",
                .formula = level.beyond ? "share = 1" : "share = 0",
                .source = question.source,
                .kind = ReferenceKind::kAnalytic,
                .expected = level.beyond ? 1.0 : 0.0,
                .scale = 1.0,
                .tolerance = 0.0,
                .reason = fmt::format("a count; {}", question.known_to)};
    const std::string words = fmt::format("{} of {}", found.yes, found.runs);
    if (level.decided) {
      run.check(std::move(claim), found.share(), words);
    } else {
      claim.statement = "at its threshold its last bits may decide";
      claim.tolerance = 1.0;
      claim.reason = "told, not claimed: nearer to the threshold than it is known";
      run.show(std::move(claim), found.share(), words);
    }
  }
  run.add(std::move(series));
}

void run_slope(CaseRun& run) {
  InclineSetup setup;
  setup.azimuth = radians(30.0);
  setup.yaw = radians(20.0);
  std::vector<Level> levels;
  for (const double offset : {-1e-6, -1e-9, 0.0, 1e-9, 1e-6}) {
    const char sign = offset < 0.0 ? '-' : '+';
    levels.push_back({offset == 0.0 ? std::string("tan θ = μ")
                                    : fmt::format("tan θ = μ (1 {} {:g})", sign, std::abs(offset)),
                      offset, offset > 0.0, std::abs(offset) > 1e-8});
  }
  check_shares(run,
               {"slides", "tan θ/μ − 1", "Coulomb's law",
                "the critical slope is held to 1e-8 of μ (incline/threshold)"},
               levels, [&](CaseRun& part, const Level& level) {
                 InclineSetup sloped = setup;
                 sloped.tan_slope = setup.friction * (1.0 + level.x);
                 return !incline_holds(part, sloped).holds;
               });
}

// The paper's pyramid at its two μ and between them, as paper/fig7-four-balls has it.
void run_four_balls(CaseRun& run) {
  BallPyramidSetup setup;
  setup.frequency = 5;
  setup.elasticity.youngs_modulus = 3e5;
  setup.drag.rate = 12.0;
  std::vector<Level> levels;
  for (const double friction : {0.20, 0.21, 0.22, 0.23, 0.24}) {
    const bool papers = friction == 0.20 || friction == 0.24;
    levels.push_back({fmt::format("μ = {:.2f}", friction), friction, friction > 0.22, papers});
  }
  check_shares(run,
               {"stands", "μ", "[Lazarevych2009], sec. 5, Fig. 7",
                "the paper's two μ lie on either side of ≈ 0.22"},
               levels, [&](CaseRun& part, const Level& level) {
                 return BallPyramidRun(part, setup).continue_with(level.x, false).stands;
               });
}

}  // namespace

std::vector<Case> cases_outcomes() {
  return {{.name = "outcomes/slope",
           .title = "a box at its critical slope, ten times with other last bits",
           .suite = "stability",
           .run = run_slope},
          {.name = "outcomes/four-balls",
           .title = "the paper's pyramid of four balls at and between its two μ, ten times each",
           .set = CaseSet::kFull,
           .suite = "stability",
           .run = run_four_balls}};
}

}  // namespace stiction
