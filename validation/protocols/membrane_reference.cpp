// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/membrane_reference.h"

#include <algorithm>
#include <cmath>

namespace stiction {

namespace {

// tan θ of gravity, which goes along a line from the first slope's to the full one's.
double tangent_at(const MembraneSetup& setup, double share) {
  const auto part = [&](double tan_slope, double& down, double& across) {
    const double cosine = 1.0 / std::hypot(1.0, tan_slope);
    down = tan_slope * cosine;
    across = cosine;
  };
  double first_down = 0.0, first_across = 0.0, down = 0.0, across = 0.0;
  part(kMembraneFirstTangent, first_down, first_across);
  part(setup.tan_slope, down, across);
  return std::lerp(first_down, down, share) / std::lerp(first_across, across, share);
}

// The string under gravity on such a slope, stretched by its tension.
reference::MembraneProblem string_at(MembraneSetup setup, double tan_slope) {
  setup.tan_slope = tan_slope;
  reference::MembraneProblem string = membrane_string(setup);
  string.length *= 1.0 + string.tension / (setup.modulus * setup.width * setup.thickness);
  return string;
}

}  // namespace

MembraneReference membrane_reference(const MembraneSetup& setup, double end, double interval,
                                     int parts) {
  const double part = (kMembraneTilted - kMembraneLoaded) / parts;
  // A place that moves with the material; friction carries the box along as the strip stretches.
  double share = setup.start / setup.length, speed = 0.0;
  std::vector<double> time{kMembraneLoaded}, place, velocity{0.0};
  place.push_back(share * string_at(setup, tangent_at(setup, 0.0)).length);
  const double mass = setup.box_mass;
  for (int k = 0; k < parts; ++k) {
    reference::MembraneProblem string = string_at(setup, tangent_at(setup, (k + 0.5) / parts));
    string.start = share * string.length;
    string.speed = speed;
    const reference::MembraneMotion motion =
        reference::membrane_motion(string, reference::MembraneLaw::full, part, 1);
    const reference::MembraneSample& last = motion.samples.back();
    share = last.position / string.length;
    speed = last.velocity;
    time.push_back(kMembraneLoaded + (k + 1) * part);
    place.push_back(last.position);
    velocity.push_back(speed);
  }
  reference::MembraneProblem string = string_at(setup, setup.tan_slope);
  string.start = share * string.length;
  string.speed = speed;
  const double left = end - kMembraneTilted;
  const int count = std::max(1, static_cast<int>(std::lround(left / part)));
  for (const reference::MembraneSample& sample :
       reference::membrane_motion(string, reference::MembraneLaw::full, left, count).samples) {
    if (sample.time == 0.0) continue;
    time.push_back(kMembraneTilted + sample.time);
    place.push_back(sample.position);
    velocity.push_back(sample.velocity);
  }
  MembraneReference found;
  found.length = string.length;
  std::size_t k = 0;
  for (int sample = 0; kMembraneLoaded + sample * interval <= end + 1e-9; ++sample) {
    const double at = std::min(kMembraneLoaded + sample * interval, time.back());
    while (k + 2 < time.size() && time[k + 1] < at) ++k;
    const double share_of_part = (at - time[k]) / (time[k + 1] - time[k]);
    const double v = std::lerp(velocity[k], velocity[k + 1], share_of_part);
    found.time.push_back(at);
    found.place.push_back(std::lerp(place[k], place[k + 1], share_of_part));
    found.kinetic.push_back(0.5 * mass * v * v);
  }
  return found;
}

}  // namespace stiction
