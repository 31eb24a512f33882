// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/pyramid_rest.h"

#include "validation/observe/observe.h"

namespace stiction {

std::vector<Vec3> box_places(const Engine& engine, const PyramidSetup& setup) {
  std::vector<Vec3> all;
  for (int b = 0; b < box_count(setup); ++b) {
    all.push_back(engine.body(static_cast<std::size_t>(b)).position);
  }
  return all;
}

BoxMoved farthest_box(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  BoxMoved moved;
  for (std::size_t b = 0; b < from.size(); ++b) {
    const double distance = (to[b] - from[b]).norm();
    if (distance > moved.distance) moved = {distance, static_cast<int>(b) + 1};
  }
  return moved;
}

void PyramidSeries::sample(const Simulation& simulation, const PyramidSetup& setup,
                           const std::vector<Vec3>& start) {
  const Engine& engine = simulation.engine();
  time.push_back(simulation.time());
  kinetic.push_back(engine.kinetic_energy());
  slip.push_back(fastest_slip(engine));
  moved.push_back(farthest_box(start, box_places(engine, setup)).distance);
}

void PyramidSeries::add_to(CaseRun& run) const {
  run.add(Series{"kinetic energy", "J", "time", "s", time, kinetic});
  run.add(Series{"fastest contact slip", "m/s", "time", "s", time, slip});
  run.add(Series{"farthest box", "m", "time", "s", time, moved});
}

namespace {

// Slips of the joints along the slope over a window, downhill positive, m: each box against the
// mean of those that it stands on (the slab is held).
std::vector<double> joint_slips(const PyramidSetup& setup, const std::vector<Vec3>& from,
                                const std::vector<Vec3>& to) {
  std::vector<double> slips;
  const auto moved = [&](int b) {
    return (to[static_cast<std::size_t>(b)] - from[static_cast<std::size_t>(b)]).x();
  };
  int box = 0, first_below = 0;
  for (int row = 0; row < setup.rows; ++row) {
    const int first = box;
    for (int k = 0; k < setup.rows - row; ++k, ++box) {
      const double below =
          row == 0 ? 0.0 : 0.5 * (moved(first_below + k) + moved(first_below + k + 1));
      slips.push_back(moved(box) - below);
    }
    first_below = first;
  }
  return slips;
}

}  // namespace

PyramidAtRest pyramid_at_rest(CaseRun& run, const PyramidSetup& setup, double window, double finer,
                              PyramidSeries* series) {
  const auto simulation = run.simulate(pyramid_problem(setup), {.finer = finer});
  if (series) simulation->record_frames(0.05);
  const Engine& engine = simulation->engine();
  const std::vector<Vec3> start = box_places(engine, setup);
  const auto moved = [&] { return farthest_box(start, box_places(engine, setup)); };
  const auto advance_while_whole = [&](double end, int samples) {
    const double begin = simulation->time();
    for (int k = 1; k <= samples && moved().distance < 0.5 * setup.width; ++k) {
      simulation->advance_to(begin + (end - begin) * k / samples);
      if (series) series->sample(*simulation, setup, start);
    }
  };
  PyramidAtRest found;
  found.dt = engine.time_step();
  advance_while_whole(kTilts, 24);
  found.before_tilt = moved().distance;
  advance_while_whole(setup.settled, 76);
  const std::vector<Vec3> settled = box_places(engine, setup);
  advance_while_whole(setup.settled + window, 100);
  found.whole = moved();
  found.fastest = fastest_slip(engine);
  found.kinetic = engine.kinetic_energy();
  if (found.whole.distance > 0.5 * setup.width) {
    found.broken_at = simulation->time();
  } else {
    found.slips = joint_slips(setup, settled, box_places(engine, setup));
  }
  return found;
}

}  // namespace stiction
