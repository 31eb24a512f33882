// SPDX-License-Identifier: GPL-3.0-or-later
// Bullet's rigid bodies behind the engine protocol.
#include <algorithm>

#include "validation/engines/bullet/world.h"
#include "validation/engines/world_functions.h"

namespace {

using stiction::bullet::World;

#ifdef BT_USE_DOUBLE_PRECISION
#define PRECISION "double"
#define NAME "bullet_double"
#else
#define PRECISION "single"
#define NAME "bullet"
#endif

World& world(void* self) { return *static_cast<World*>(self); }

size_t contacts(void* self, stiction_contact* contacts, size_t room) {
  const auto all = world(self).contacts();
  std::copy_n(all.begin(), std::min(room, all.size()), contacts);
  return all.size();
}

const stiction_configuration kConfigurations[] = {
    {"default", "dt=0.016666666666666666 iterations=10",
     "its hello-world example: 60 steps a second, a box of 100 m as ground; all else as Bullet "
     "sets it"},
    {"best",
     "dt=0.004166666666666667 iterations=100 friction_directions=2 erp=0.0125 warm_start=0.85",
     "our search on creep, threshold, acceleration and stopping of a box (azimuth 30°, yaw 20°) "
     "and four balls: one dial at a time (ground, plane_points, ground_size 10 to 100, "
     "friction_directions, directions_along_slip, friction_anchors, interleaved, random_order, "
     "solver, erp, contact_breaking 0.002 and 0.02), then at dt 1/240 iterations 50 and 200 × erp "
     "0.0125 to 0.2 × warm_start 0 to 1 × split_threshold -0.04 and 0, and at 1/960 a part of it"},
    {}};

const char* const kLadder[] = {
    "dt=0.016666666666666666 iterations=10",   "dt=0.008333333333333333 iterations=20",
    "dt=0.004166666666666667 iterations=40",   "dt=0.0020833333333333333 iterations=80",
    "dt=0.0010416666666666667 iterations=160", nullptr};

}  // namespace

int main(int argc, char** argv) {
  stiction_engine engine = stiction::world_functions<World>();
  engine.name = NAME;
  engine.version = "3.24, " PRECISION " precision";
  engine.description = "Bullet's rigid bodies, " PRECISION " precision";
  engine.can =
      "boxes balls convex_meshes body_contact moving_obstacles steady_motion oscillation "
      "pair_friction "
      "restitution varying_gravity drag loads spin";
  engine.settings = stiction::bullet::kSettings;
  engine.configurations = kConfigurations;
  engine.ladder = kLadder;
#ifdef BT_USE_DOUBLE_PRECISION
  engine.symplectic_euler = 1;  // in single precision only to 1e-7
#endif
  engine.contacts = contacts;
  return stiction_engine_main(&engine, argc, argv);
}
