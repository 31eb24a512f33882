// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/problems/gauntlet/gauntlet_mesh.h"

namespace stiction {

enum class Slider {
  kBox,     ///< its lower face
  kSpikes,  ///< four tips, 40 mm apart
  kRidges   ///< two edges across the way, 72 mm apart
};

/// A body that slides along x over the inner edges of a flat that is made of many triangles and held
/// at every vertex. Gravity grows from 0 to g in T:
///
///   v(t) = v₀ − μ g (t − T/2),   x(t) = v₀ t − μ g (T²/7 + T (t − T)/2 + (t − T)²/2)   for t ≥ T
///
/// by the integrals of the smooth step 6s⁵ − 15s⁴ + 10s³ from 0 to 1, 1/2 and 1/7.
struct SliderSetup {
  Slider slider = Slider::kBox;
  double azimuth = 0.0;    ///< of the flat's mesh about the vertical, degrees
  bool irregular = false;  ///< its inner vertices are moved within its plane
  double speed = 1.0;      ///< v₀, m/s
  double friction = 0.3;   ///< μ
  double ramp = 0.1;       ///< T, s
  double duration = 0.25;  ///< s: it still moves, at 0.41 m/s
};

/// Bodies: slider (0), flat (1), whose upper face is z = 0.
Problem slider_problem(const SliderSetup& setup);

/// The flat's cells, m.
inline constexpr double kFlatCell = 0.02;

struct Slid {
  double distance;  ///< m
  double speed;     ///< m/s
};
/// At a time ≥ T while it still slides, s.
Slid slid(const SliderSetup& setup, double time);

/// The slider's mass over that of its lowest vertices, as its mesh spreads it: so many times g falls
/// towards the flat what carries it.
double load_ratio(const SliderSetup& setup);

std::string slider_words(const SliderSetup& setup);

}  // namespace stiction
