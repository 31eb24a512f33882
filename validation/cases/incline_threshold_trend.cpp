// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "validation/protocols/incline_run.h"
#include "validation/protocols/incline_threshold.h"

namespace stiction {

namespace {

// Start-up slip at 99 % of the critical slope: how far the box moves while it is loaded, m.
double start_up_slip(CaseRun& run, InclineSetup setup, const Accuracy& accuracy) {
  setup.tan_slope = 0.99 * setup.friction;
  InclineRun incline(run, setup, settled_incline_problem(setup), accuracy);
  incline.advance_to(1.4);
  return incline.travel();
}

// One threshold, and the start-up slip beside it, for each value of a parameter.
struct Trend {
  std::string parameter;
  std::string unit;
  std::vector<double> values;
  std::function<void(double, InclineSetup&, Accuracy&)> apply;
};

void run_trend(CaseRun& run, const Trend& trend) {
  constexpr double kWidth = 1e-6;
  Series error{"threshold error", "1", trend.parameter, trend.unit, trend.values, {}};
  Series slip{"start-up slip at 99 %", "m", trend.parameter, trend.unit, trend.values, {}};
  for (const double value : trend.values) {
    InclineSetup setup;
    setup.azimuth = radians(30.0);
    Accuracy accuracy;
    trend.apply(value, setup, accuracy);
    const double mu = setup.friction;
    const Bracket bracket = incline_threshold(run, setup, kWidth * mu, accuracy);
    error.y.push_back(bracket.middle() / mu - 1.0);
    slip.y.push_back(start_up_slip(run, setup, accuracy));
    run.check({.quantity = fmt::format("critical tan θ at {} = {:.3g} {}", trend.parameter, value,
                                       trend.unit),
               .unit = "1",
               .statement = "the threshold does not depend on time step, mesh or stiffness",
               .formula = "tan θ_c = μ",
               .source = "Coulomb's law",
               .kind = ReferenceKind::kAnalytic,
               .expected = mu,
               .relative = true,
               .tolerance = kWidth,
               .reason = "the bracket's width"},
              bracket.middle());
  }
  const std::size_t last = slip.y.size() - 1;
  run.note(fmt::format(
      "what does depend on it is the start-up slip: {:.2e} m at {:.3g} {}, "
      "{:.2e} m at {:.3g} {}",
      slip.y.front(), slip.x.front(), trend.unit, slip.y[last], slip.x[last], trend.unit));
  run.add(std::move(error));
  run.add(std::move(slip));
}

}  // namespace

std::vector<Case> cases_incline_threshold_trend() {
  const std::vector<Trend> trends = {
      {"resolution in time",
       "s",
       {2e-4, 1e-4, 5e-5},
       [](double value, InclineSetup&, Accuracy& accuracy) { accuracy.time = value; }},
      {"resolution in space",
       "1",
       {2, 3, 4},
       [](double value, InclineSetup& setup, Accuracy& accuracy) {
         // The same time for all, below the stability limit of the finest mesh.
         setup.elasticity.youngs_modulus = 2.5e5;
         accuracy = {.fineness = static_cast<int>(value), .time = 1e-4};
       }},
      {"Young's modulus",
       "Pa",
       {1e5, 5e5, 1e6},
       [](double value, InclineSetup& setup, Accuracy&) {
         setup.must_deform = true;
         setup.elasticity.youngs_modulus = value;
         // The same damping ratio for each stiffness, so that all settle in time.
         setup.elasticity.damping_time = 1e-3 * std::sqrt(5e5 / value);
       }},
  };
  const std::vector<std::string> names = {"time", "space", "stiffness"};
  std::vector<Case> cases;
  for (std::size_t k = 0; k < trends.size(); ++k) {
    cases.push_back({.name = "incline/threshold-trend/" + names[k],
                     .title = "critical slope against " + trends[k].parameter,
                     .run = [trend = trends[k]](CaseRun& run) { run_trend(run, trend); }});
  }
  return cases;
}

}  // namespace stiction
