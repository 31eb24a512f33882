// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/soft_balls.h"

#include <cmath>
#include <numbers>

namespace stiction::reference {

HertzContact hertz_contact(double force, double radius, double modulus) {
  HertzContact contact;
  contact.patch = std::cbrt(0.75 * force * radius / modulus);
  contact.approach = contact.patch * contact.patch / radius;
  return contact;
}

SoftFourBallThreshold soft_four_ball_threshold(const SoftFourBalls& balls) {
  const double r = balls.radius, top_radius = balls.ratio * balls.radius;
  const double lower =
      balls.gravity * balls.density * 4.0 / 3.0 * std::numbers::pi * r * r * r;  // weight, N
  const double top = lower * std::pow(balls.ratio, 3);
  const double plane =
      balls.youngs_modulus / (1.0 - balls.poisson_ratio * balls.poisson_ratio);  // Pa
  SoftFourBallThreshold threshold;
  threshold.between = hertz_contact(top / 3.0, r * top_radius / (r + top_radius), 0.5 * plane);
  threshold.ground = hertz_contact(lower + top / 3.0, r, plane);
  const double apart = r + top_radius - threshold.between.approach;
  threshold.friction = std::tan(0.5 * std::asin(2.0 * r / std::numbers::sqrt3 / apart));
  return threshold;
}

}  // namespace stiction::reference
