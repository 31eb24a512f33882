// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "validation/engine/engine.h"
#include "validation/problems/slopes/incline_problem.h"

/// For the tests of this folder.
namespace stiction::test {

/// The engine, with a problem loaded.
inline std::unique_ptr<Engine> loaded(const Problem& problem, const Settings& settings = {}) {
  std::unique_ptr<Engine> engine = find_engine("stiction").make(settings);
  engine->load(problem, {});
  return engine;
}

/// A box on a slope, sliding downhill at `speed` (m/s).
inline InclineSetup slope(double tan_slope, double speed = 0.0) {
  InclineSetup setup;
  setup.tan_slope = tan_slope;
  setup.azimuth = 0.5;
  setup.speed = speed;
  return setup;
}

}  // namespace stiction::test
