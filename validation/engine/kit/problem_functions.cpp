// SPDX-License-Identifier: BSD-3-Clause
// What a problem says at a time: the functions of stiction_engine.h.
#include <cmath>
#include <cstddef>

#include "validation/engine/kit/stiction_engine.h"

namespace {

double smooth_step(double s) { return s * s * s * (10.0 + s * (6.0 * s - 15.0)); }

void add_keyframes(const stiction_keyframes* keyframes, double t, double value[3]) {
  const std::size_t count = keyframes->count;
  if (count == 0) return;
  std::size_t next = 0;
  while (next < count && keyframes->time[next] <= t) ++next;
  const std::size_t before = next == 0 ? 0 : next - 1, after = next == count ? count - 1 : next;
  double s = 0.0;
  if (before != after) {
    s = smooth_step((t - keyframes->time[before]) /
                    (keyframes->time[after] - keyframes->time[before]));
  }
  for (int i = 0; i < 3; ++i) {
    const double from = keyframes->value[before][i], to = keyframes->value[after][i];
    value[i] += from + s * (to - from);
  }
}

bool is_zero(const double vector[3]) {
  return vector[0] == 0.0 && vector[1] == 0.0 && vector[2] == 0.0;
}

void add_oscillation(const stiction_oscillation& one, double t, double value[3]) {
  constexpr double kTwoPi = 6.283185307179586;
  if (is_zero(one.amplitude) || !(t > one.begins)) return;
  const double grown =
      t < one.full_from ? smooth_step((t - one.begins) / (one.full_from - one.begins)) : 1.0;
  const double sine = std::sin(kTwoPi * one.frequency * (t - one.begins) + one.phase);
  for (int i = 0; i < 3; ++i) value[i] += grown * sine * one.amplitude[i];
}

}  // namespace

void stiction_at(const stiction_keyframes* keyframes, double t, double value[3]) {
  for (int i = 0; i < 3; ++i) value[i] = 0.0;
  add_keyframes(keyframes, t, value);
  add_oscillation(keyframes->oscillation, t, value);
  for (int i = 0; i < 3; ++i) value[i] += t * keyframes->velocity[i];
}

int stiction_moves(const stiction_keyframes* motion) {
  return motion->count > 0 || stiction_varies(motion);
}

int stiction_varies(const stiction_keyframes* keyframes) {
  return keyframes->count > 1 || !is_zero(keyframes->velocity) ||
         !is_zero(keyframes->oscillation.amplitude);
}

double stiction_friction(const stiction_problem* problem, size_t body, size_t other,
                         int against_body) {
  for (std::size_t k = 0; k < problem->pair_friction_count; ++k) {
    const stiction_pair_friction& one = problem->pair_friction[k];
    if ((one.against_body != 0) != (against_body != 0)) continue;
    if (one.body == body && one.other == other) return one.friction;
    if (against_body && one.body == other && one.other == body) return one.friction;
  }
  return against_body ? problem->friction : problem->obstacles[other].friction;
}

double stiction_drag(const stiction_problem* problem, double t) {
  if (t <= problem->drag_full_until) return problem->drag_rate;
  if (t >= problem->drag_ends) return 0.0;
  const double s = (t - problem->drag_full_until) / (problem->drag_ends - problem->drag_full_until);
  return problem->drag_rate * (1.0 - smooth_step(s));
}

int stiction_has_loads(const stiction_problem* problem, size_t body) {
  for (std::size_t k = 0; k < problem->load_count; ++k) {
    if (problem->loads[k].body == body) return 1;
  }
  for (std::size_t k = 0; k < problem->spring_count; ++k) {
    if (problem->springs[k].body == body) return 1;
  }
  return 0;
}

void stiction_load(const stiction_problem* problem, size_t body, double t, const double position[3],
                   double force[3], double couple[3]) {
  for (int i = 0; i < 3; ++i) force[i] = couple[i] = 0.0;
  for (std::size_t k = 0; k < problem->load_count; ++k) {
    const stiction_body_load& load = problem->loads[k];
    if (load.body != body) continue;
    double part[3];
    stiction_at(&load.force, t, part);
    for (int i = 0; i < 3; ++i) force[i] += part[i];
    stiction_at(&load.couple, t, part);
    for (int i = 0; i < 3; ++i) couple[i] += part[i];
  }
  for (std::size_t k = 0; k < problem->spring_count; ++k) {
    const stiction_spring& one = problem->springs[k];
    if (one.body != body) continue;
    double stretch = 0.0;
    for (int i = 0; i < 3; ++i) {
      stretch += one.axis[i] * (one.anchor[i] + t * one.anchor_velocity[i] - position[i]);
    }
    for (int i = 0; i < 3; ++i) force[i] += one.stiffness * stretch * one.axis[i];
  }
}
