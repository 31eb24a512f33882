// SPDX-License-Identifier: BSD-3-Clause
// The least engine: rigid bodies that slide on half-spaces and do not turn, by symplectic Euler.
#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "stiction_engine.h"

using Eigen::Map, Eigen::Vector3d;

namespace {

struct Slider {
  const stiction_problem* problem;
  double dt, t = 0.0;
  std::vector<Vector3d> x{}, v{};
};

void* load(const stiction_problem* problem) {
  auto* self = new Slider{problem, stiction_number("dt", 1e-3) / problem->finer};
  for (size_t b = 0; b < problem->body_count; ++b) {
    self->x.emplace_back(problem->bodies[b].position);
    self->v.emplace_back(problem->bodies[b].velocity);
  }
  return self;
}

double time_step(void* self) { return static_cast<Slider*>(self)->dt; }

void touch(Slider& s, size_t b, size_t o) {
  const stiction_obstacle& plane = s.problem->obstacles[o];
  const Vector3d n(plane.normal), gap = s.x[b] - Vector3d(plane.point);
  const double reach = 0.5 * s.problem->bodies[b].size[2];  // it lies flat
  const double push = -std::max(n.dot(gap) - reach, 0.0) / s.dt - n.dot(s.v[b]);
  if (push <= 0.0) return;
  s.v[b] += push * n;
  const Vector3d slip = s.v[b] - n.dot(s.v[b]) * n;
  const double most = stiction_friction(s.problem, b, o, 0) * push;
  s.v[b] -= slip.norm() > most ? Vector3d(most * slip.normalized()) : slip;
}

void advance(void* self, uint64_t steps) {
  auto& s = *static_cast<Slider*>(self);
  for (; steps > 0; --steps, s.t += s.dt) {
    Vector3d g;
    stiction_at(&s.problem->gravity, s.t, g.data());
    for (size_t b = 0; b < s.x.size(); ++b) {
      s.v[b] += s.dt * g;
      for (size_t o = 0; o < s.problem->obstacle_count; ++o) touch(s, b, o);
      s.x[b] += s.dt * s.v[b];
    }
  }
}

void body(void* self, size_t b, stiction_body_state* state) {
  const auto& s = *static_cast<Slider*>(self);
  Map<Vector3d>(state->position) = s.x[b];
  Map<Vector3d>(state->velocity) = s.v[b];
  std::copy_n(s.problem->bodies[b].rotation, 4, state->rotation);
}

}  // namespace

int main(int argc, char** argv) {
  const stiction_setting settings[] = {{"dt", "time step, s (default 1e-3)"}, {}};
  const stiction_engine engine = {.name = "minimal",
                                  .version = "1",
                                  .description = "boxes that slide on half-spaces and do not turn",
                                  .can = "boxes varying_gravity oscillation pair_friction",
                                  .settings = settings,
                                  .symplectic_euler = 1,
                                  .load = load,
                                  .time_step = time_step,
                                  .advance = advance,
                                  .body = body};
  return stiction_engine_main(&engine, argc, argv);
}
