// SPDX-License-Identifier: GPL-3.0-or-later
// Sliding over the inner edges of a flat: a box, tips, ridges.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "validation/core/check_worst.h"
#include "validation/problems/gauntlet/slider_problem.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

// What presses a body changes its height: N = m (g + dv_z/dt), so that Coulomb's law says
//
//   v_x + μ v_z = v₀ − μ ∫ g dt,   x + μ z = x₀ + μ z₀ + v₀ t − μ ∫∫ g dt²
//
// of its centre, however it is deformed, as long as every contact slides along x.
struct Slide {
  std::string words;
  double step = 0.0;      // s
  double speed = 0.0;     // error of what is lost under full gravity, 1
  double distance = 0.0;  // largest error, m
  double sideways = 0.0;  // largest speed across, m/s
  double turned = 0.0;    // largest about the vertical, rad
  double hop = 0.0;       // largest vertical speed under full gravity, m/s
};

Slide slide(CaseRun& run, const SliderSetup& setup, double finer) {
  const auto simulation = run.simulate(slider_problem(setup), {.finer = finer});
  simulation->record_frames(5e-3);
  const Engine& engine = simulation->engine();
  Slide found;
  found.words = slider_words(setup) + (finer > 1.0 ? ", half the step" : "");
  found.step = engine.time_step();
  const Vec3 along(1.0, 0.0, setup.friction);
  const double start = along.dot(engine.body(0).position);
  simulation->advance_to(setup.ramp);
  const double begin = simulation->time(), before = along.dot(engine.body(0).velocity);
  for (int k = 0; k <= 100; ++k) {
    simulation->advance_to(begin + (setup.duration - begin) * k / 100.0);
    const BodyMotion now = engine.body(0);
    const Vec3 ahead = now.rotation * Vec3::UnitX();
    found.sideways = std::max(found.sideways, std::abs(now.velocity.y()));
    found.turned = std::max(found.turned, std::abs(std::atan2(ahead.y(), ahead.x())));
    found.hop = std::max(found.hop, std::abs(now.velocity.z()));
    found.distance = std::max(found.distance, std::abs(along.dot(now.position) - start -
                                                       slid(setup, simulation->time()).distance));
  }
  const double lost = setup.friction * kStandardGravity * (simulation->time() - begin);
  found.speed = std::abs(before - along.dot(engine.body(0).velocity) - lost) / lost;
  run.note(fmt::format(
      "{}: speed lost off by {:.2e}, distance by {:.2e} m; sideways {:.2e} m/s, "
      "turned {:.2e}, hop {:.2e} m/s",
      found.words, found.speed, found.distance, found.sideways, found.turned, found.hop));
  return found;
}

void run_slides(CaseRun& run, Slider slider) {
  std::vector<Slide> all;
  for (const auto& [azimuth, irregular, finer] :
       {std::tuple{0.0, false, 1.0}, {30.0, false, 2.0}, {45.0, true, 1.0}}) {
    all.push_back(
        slide(run, {.slider = slider, .azimuth = azimuth, .irregular = irregular}, finer));
  }
  const SliderSetup setup{.slider = slider};
  const double braked = setup.friction * kStandardGravity;
  const double step = all.front().step;
  const double loosened =
      load_ratio(setup) * kStandardGravity * step / slid(setup, setup.duration).speed;
  check_worst(
      run, all,
      {.quantity = "speed lost, error",
       .unit = "1",
       .statement = "inner edges do not brake: friction takes μ g",
       .formula = "(v_x + μ v_z)(t) − (v_x + μ v_z)(T) = −μ g (t − T)",
       .source = "Coulomb's law",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = 0.5 * loosened * loosened,
       .reason = "a velocity loses the same every step, so there is no truncation error; what "
                 "carries the body, let go for a step, vibrates at n g Δt (n the load "
                 "ratio), across the way as well: half the square of that over v"},
      [](const Slide& s) { return s.speed; });
  check_worst(
      run, all,
      {.quantity = "distance, error",
       .unit = "m",
       .statement = "… at any time",
       .formula = "x + μ z = x₀ + μ z₀ + v₀ t − μ g (T²/7 + T (t − T)/2 + (t − T)²/2)",
       .source = "Coulomb's law",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = step * (setup.speed - slid(setup, setup.duration).speed),
       .reason = "truncation of first order: a speed that is a step late, times its change"},
      [](const Slide& s) { return s.distance; });
  check_worst(run, all,
              {.quantity = "speed across the way",
               .unit = "m/s",
               .statement = "… nor do they push sideways",
               .formula = "v_y = 0",
               .source = "a flat's normal is the same in all its triangles",
               .kind = ReferenceKind::kAnalytic,
               .expected = 0.0,
               .tolerance = 0.1 * braked * step,
               .reason = "a tenth of what friction does in a step, which is where forces that "
                         "differ from triangle to triangle by a standing depth leave it"},
              [](const Slide& s) { return s.sideways; });
  check_worst(run, all,
              {.quantity = "turn about the vertical",
               .unit = "rad",
               .statement = "… nor turn what slides",
               .formula = "yaw = 0",
               .source = "symmetry about the way",
               .kind = ReferenceKind::kAnalytic,
               .expected = 0.0,
               .tolerance = 0.1 * braked * step * setup.duration / 0.03,
               .reason = "that speed at half the body's length, 30 mm, all the time"},
              [](const Slide& s) { return s.turned; });
  check_worst(run, all,
              {.quantity = "vertical speed",
               .unit = "m/s",
               .statement = "… nor lift it",
               .formula = "v_z = 0 under full gravity",
               .source = "a flat has no bumps",
               .kind = ReferenceKind::kAnalytic,
               .expected = 0.0,
               .tolerance = kStandardGravity * step,
               .reason = "a step of free fall: no contact is lost for longer"},
              [](const Slide& s) { return s.hop; });
}

Case sliding(const char* name, const char* title, Slider slider) {
  return {.name = name,
          .title = title,
          .set = CaseSet::kDefault,
          .suite = "stability",
          .run = [slider](CaseRun& run) { run_slides(run, slider); }};
}

}  // namespace

std::vector<Case> cases_gauntlet_sliding() {
  return {
      sliding("gauntlet/sliding/box", "a box slides over the inner edges of a flat", Slider::kBox),
      sliding("gauntlet/sliding/spikes", "four tips slide over the inner edges of a flat",
              Slider::kSpikes),
      sliding("gauntlet/sliding/wedges", "two ridges slide over the inner edges of a flat",
              Slider::kRidges)};
}

}  // namespace stiction
