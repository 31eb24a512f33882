// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/incline_threshold.h"

#include <fmt/format.h>

#include <cmath>

#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

constexpr double kRelativeWidth = 1e-8;  // of the bracket, to μ

void run_threshold(CaseRun& run, const InclineSetup& setup) {
  const double mu = setup.friction;
  const Bracket bracket = incline_threshold(run, setup, kRelativeWidth * mu);
  run.check({.quantity = "critical tan θ",
             .unit = "1",
             .statement = "a box sticks if and only if tan θ ≤ μ",
             .formula = "tan θ_c = μ",
             .source = "Coulomb's law; [Lazarevych2009], sec. 5",
             .kind = ReferenceKind::kAnalytic,
             .expected = mu,
             .relative = true,
             .tolerance = 1e-8,
             .reason = "half the bracket (5e-9), and as much again for vibrations: 1e-8 of the "
                       "load is 1e-7 m/s² or 3e-8 m/s in the 0.3 s observed, where vibrations have "
                       "decayed below 1e-11 m/s",
             .headline = "critical slope on a half-space, tan θ"},
            bracket.middle());
  // Shown only: the search ends at the width that it was asked for, so it can't fail.
  run.show({.quantity = "bracket width",
            .unit = "1",
            .statement = "how far the threshold is resolved",
            .source = "search",
            .kind = ReferenceKind::kAnalytic,
            .reason = "not judged: the search ends at the width that it was asked for"},
           bracket.width());
  run.note(
      fmt::format("bracket on tan θ: holds at {:.11g}, slides at {:.11g}; θ_c − atan μ = "
                  "{:+.1e}°; {} runs",
                  bracket.holds, bracket.fails,
                  (std::atan(bracket.middle()) - std::atan(mu)) * 180.0 / std::numbers::pi,
                  bracket.evaluations));
}

}  // namespace

std::vector<Case> cases_incline_threshold() {
  std::vector<Case> cases;
  const auto add = [&](double mu, double azimuth, double yaw, CaseSet set) {
    InclineSetup setup;
    setup.friction = mu;
    setup.azimuth = radians(azimuth);
    setup.yaw = radians(yaw);
    Case one{.name = fmt::format("incline/threshold/mu={}/azimuth={}/yaw={}", mu, azimuth, yaw),
             .title = fmt::format("critical slope at μ = {}, falling to {}°, box yawed by {}°", mu,
                                  azimuth, yaw),
             .set = set,
             .run = [setup](CaseRun& run) { run_threshold(run, setup); }};
    cases.push_back(std::move(one));
  };
  for (const double mu : {0.1, 0.3, 0.5, 0.6, 0.9}) {
    for (const double azimuth : {0.0, 30.0, 45.0}) {
      add(mu, azimuth, 0.0, mu == 0.3 && azimuth == 30.0 ? CaseSet::kQuick : CaseSet::kDefault);
    }
    add(mu, 30.0, 20.0, CaseSet::kDefault);
  }
  return cases;
}

}  // namespace stiction
