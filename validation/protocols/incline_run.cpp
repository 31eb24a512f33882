// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/incline_run.h"

#include "validation/observe/observe.h"

namespace stiction {

InclineRun::InclineRun(CaseRun& run, const InclineSetup& setup, const Problem& problem,
                       const Accuracy& accuracy)
    : simulation_(run.simulate(problem, accuracy)),
      frame_(incline_frame(setup)),
      start_(0.0),
      tells_contacts_(run.engine().manifest.contacts) {
  start_ = travel();
}

double InclineRun::travel() const {
  return frame_.downhill.dot(engine().body(0).position) - start_;
}

double InclineRun::speed() const { return frame_.downhill.dot(engine().body(0).velocity); }

void InclineSeries::sample(const InclineRun& run) {
  time_.push_back(run.time());
  kinetic_.push_back(run.engine().kinetic_energy());
  if (run.tells_contacts()) slip_.push_back(fastest_slip(run.engine()));
  speed_.push_back(run.speed());
}

void InclineSeries::add_to(CaseRun& run) const {
  run.add({"kinetic energy", "J", "time", "s", time_, kinetic_});
  if (!slip_.empty()) run.add({"fastest contact slip", "m/s", "time", "s", time_, slip_});
  run.add({"downhill speed", "m/s", "time", "s", time_, speed_});
}

void advance_sampled(InclineRun& run, double end, int samples, InclineSeries& series) {
  const double begin = run.time();
  for (int k = 1; k <= samples; ++k) {
    run.advance_to(begin + (end - begin) * k / samples);
    series.sample(run);
  }
}

}  // namespace stiction
