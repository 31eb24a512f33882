// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/wall_rest.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "validation/protocols/paper_figure.h"

namespace stiction {

namespace {

const char* const kSource = "static equilibrium: every joint is pressed by what stands on it";

struct Farthest {
  double way = 0.0;  // m
  std::string body{};
  void see(double other, const std::string& name) {
    if (other > way) {
      way = other;
      body = name;
    }
  }
};

std::vector<Vec3> places(const Engine& engine, std::size_t count) {
  std::vector<Vec3> all;
  for (std::size_t b = 0; b < count; ++b) all.push_back(engine.body(b).position);
  return all;
}

}  // namespace

void check_wall(CaseRun& run, const WallSetup& setup, double settled, const Accuracy& accuracy) {
  const Problem problem = wall_problem(setup);
  const std::size_t count = problem.bodies.size();
  const auto simulation = run.simulate(problem, accuracy);
  simulation->record_frames(0.05);
  const Engine& engine = simulation->engine();
  const std::vector<Vec3> start = places(engine, count);
  const std::vector<std::size_t> top = top_course(setup);
  const auto fallen = [&] {
    double worst = 0.0;
    for (const std::size_t b : top) {
      const double fall = start[b].z() - engine.body(b).position.z();
      if (std::abs(fall) > std::abs(worst)) worst = fall;
    }
    return worst;
  };
  Series fall{"fall of the topmost course", "m", "time", "s", {}, {}};
  Series kinetic{"kinetic energy", "J", "time", "s", {}, {}};
  const auto advance = [&](double end) {
    const double begin = simulation->time();
    constexpr int kSamples = 50;
    for (int k = 1; k <= kSamples; ++k) {
      simulation->advance_to(begin + (end - begin) * k / kSamples);
      for (Series* series : {&fall, &kinetic}) series->x.push_back(simulation->time());
      fall.y.push_back(fallen());
      kinetic.y.push_back(engine.kinetic_energy());
    }
  };
  advance(settled);
  const std::vector<Vec3> before = places(engine, count);
  advance(2.0 * settled);
  const std::vector<Vec3> after = places(engine, count);
  run.add(fall);
  run.add(kinetic);

  Farthest moved, aside;
  double mass = 0.0;
  for (std::size_t b = 0; b < count; ++b) {
    const std::string& name = problem.bodies[b].name;
    moved.see((after[b] - before[b]).norm(), name);
    aside.see((after[b] - start[b]).head<2>().norm(), name);
    mass += problem.bodies[b].mass;
  }
  const bool elastic = run.engine().manifest.deformable;
  const double steps = 2.0 * settled / engine.time_step();
  const double height = setup.courses * setup.edge;
  const double ulp = std::numeric_limits<double>::epsilon() * height;
  const Claim common{.quantity = "fall of the topmost course",
                     .unit = "m",
                     .source = kSource,
                     .kind = ReferenceKind::kAnalytic};
  Claim claim = common;
  if (elastic) {
    claim.statement = "elastic bricks come down by what their weight presses them together";
    claim.formula = "ρ g/E · (H z − ½(z² + h²/12)), z = H − h/2";
    claim.expected = elastic_fall(setup, engine.fineness());
    claim.relative = true;
    const double cells = engine.fineness() > 0 ? engine.fineness() : 4;
    const double mesh = 0.25 / (cells * cells);
    claim.tolerance = mesh + setup.joint / setup.edge;
    claim.reason = fmt::format(
        "a mesh of c elements along a brick: ¼/c² = {:.1g} (of second order; c = 4 where the "
        "engine has no such number); joints that carry nothing: {:.1g} of the area",
        mesh, setup.joint / setup.edge);
  } else {
    claim.statement = "rigid bricks stay where they were laid";
    claim.formula = "z(end) = z(0)";
    claim.expected = 0.0;
    claim.tolerance = steps * 0.5 * ulp;
    claim.reason = "round-off: half a unit in the last place of a height, every step";
  }
  run.check(claim, fallen());
  run.check({.quantity = "creep",
             .unit = "m/s",
             .statement = "once settled nothing moves: mean speed of what moves most",
             .formula = "v = 0",
             .source = kSource,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = kStaticSlip,
             .reason = "the paper's 1e-9 m/s of static contacts"},
            moved.way / settled, moved.body);
  run.check({.quantity = "farthest way to the side",
             .unit = "m",
             .statement = "nothing falls: no brick has gone to a side",
             .formula = "x(end) = x(0), y(end) = y(0)",
             .source = kSource,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.01 * setup.edge,
             .reason = "a hundredth of a brick; where it stands within that is the joint's rest of "
                       "the settling, which friction keeps"},
            aside.way, aside.body);
  run.check({.quantity = "kinetic energy at the end",
             .unit = "J",
             .statement = "… and all is at rest",
             .formula = "½Σmv² = 0",
             .source = kSource,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.5 * mass * kStaticSlip * kStaticSlip,
             .reason = "½ m v² of all at the paper's 1e-9 m/s"},
            engine.kinetic_energy());
}

}  // namespace stiction
