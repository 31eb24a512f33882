// SPDX-License-Identifier: BSD-3-Clause
#include "solver/options.h"

#include <cmath>
#include <sstream>

#include "solver/demand.h"
#include "solver/friction/catalog.h"

namespace stiction {

void check_options(const Options& options) {
  std::ostringstream wrong;
  const double dt = options.time_step;
  if (!(dt > 0.0) || !std::isfinite(dt)) {
    wrong << "the time step must be positive and finite, not " << dt << " s";
  } else if (!is_friction_rule(options.rule)) {
    wrong << "unknown friction rule '" << options.rule << "'; there are: " << friction_rule_list();
  } else if (options.sweeps < 0) {
    wrong << "sweeps are counted from 1 (0: as many as the rule needs), not " << options.sweeps;
  } else if (!(options.pairs.harmonic_gain > 0.0 && options.pairs.harmonic_gain < 4.0 / 3.0)) {
    wrong << "the harmonic gain must lie between 0 and 4/3, above which normal forces diverge, not "
          << options.pairs.harmonic_gain;
  } else if (!(options.pairs.hysteresis >= 0.0) || !std::isfinite(options.pairs.hysteresis)) {
    wrong << "the hysteresis must be non-negative and finite, not " << options.pairs.hysteresis;
  } else if (!(options.pairs.tie_margin >= 0.0 && options.pairs.tie_margin < 1.0)) {
    wrong << "the tie margin must lie in [0, 1), not " << options.pairs.tie_margin;
  } else if (!(options.pairs.border_margin >= 0.0 && options.pairs.border_margin < 1.0)) {
    wrong << "the border margin must lie in [0, 1), not " << options.pairs.border_margin;
  } else if (!(options.pairs.depth_noise >= 0.0 && options.pairs.depth_noise < 1.0)) {
    wrong << "the depth noise must lie in [0, 1), not " << options.pairs.depth_noise;
  } else {
    wrong << refusal_of(options.rule, friction_rule_parameters(options.rule), options.friction);
  }
  if (!wrong.str().empty()) throw InputError(wrong.str());
}

void check_options(const Options& options, const Scene& scene) {
  check_options(options);
  std::ostringstream wrong;
  const double dt = options.time_step;
  if (dt > scene.stable_time_step) {
    wrong << "the time step " << dt << " s is above the stability limit " << scene.stable_time_step
          << " s, set by tetrahedron " << scene.stiffest_element << " (body '"
          << scene.stiffest_body << "')";
  } else if (!(scene.drag.rate * dt < 1.0)) {
    wrong << "a drag of " << scene.drag.rate << " 1/s would reverse velocities in a step of " << dt
          << " s";
  }
  if (!wrong.str().empty()) throw InputError(wrong.str());
}

}  // namespace stiction
