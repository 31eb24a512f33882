// SPDX-License-Identifier: GPL-3.0-or-later
// The Open Dynamics Engine behind the engine protocol.
#include <algorithm>

#include "validation/engines/ode/world.h"
#include "validation/engines/world_functions.h"

namespace {

using stiction::ode::World;

World& world(void* self) { return *static_cast<World*>(self); }

size_t contacts(void* self, stiction_contact* contacts, size_t room) {
  const auto all = world(self).contacts();
  std::copy_n(all.begin(), std::min(room, all.size()), contacts);
  return all.size();
}

void* save(void* self) { return new World::State(world(self).save()); }

void restore(void* self, const void* saved) {
  world(self).restore(*static_cast<const World::State*>(saved));
}

void forget(void*, void* saved) { delete static_cast<World::State*>(saved); }

const stiction_configuration kConfigurations[] = {
    {"quick step",
     "step=quick dt=0.02 iterations=20 over_relaxation=1.3 cfm=1e-5 soft_cfm=0.01 "
     "max_correcting_velocity=0.1 surface_layer=0.001 linear_damping=1e-5 angular_damping=0.005",
     "its example demo_boxstack, but for that one's bouncing and its boundless friction"},
    {"exact", "step=exact dt=0.01",
     "all else as dWorldCreate sets it in double precision; its manual calls this step accurate"},
    {"best",
     "step=quick dt=0.005 iterations=500 over_relaxation=1.3 cfm=1e-12 "
     "friction_direction=predicted finite_rotation=1",
     "our search on creep, threshold, acceleration and stopping of a box (azimuth 30°, yaw 20°) "
     "and four balls: step × friction_direction at dt 0.01; at dt 0.005 and "
     "friction_direction=predicted, exact: cfm 1e-5 to 1e-15 and 0, erp 0.05 to 0.8, max_contacts "
     "4 and 8, max_correcting_velocity 0.1, surface_layer 1e-5, finite_rotation; quick: iterations "
     "20 to 500 × over_relaxation 1 and 1.3 × erp 0.05 and 0.2, then iterations 200 and 500 × "
     "over_relaxation × cfm 1e-12, 1e-14 and 0"},
    {}};

const char* const kLadder[] = {"dt=0.02 iterations=20",     "dt=0.01 iterations=50",
                               "dt=0.005 iterations=100",   "dt=0.0025 iterations=200",
                               "dt=0.00125 iterations=500", nullptr};

}  // namespace

int main(int argc, char** argv) {
  stiction_engine engine = stiction::world_functions<World>();
  engine.name = "ode";
  engine.version = "0.16.2, double precision";
  engine.description = "Open Dynamics Engine, rigid bodies";
  engine.can =
      "boxes balls body_contact moving_obstacles steady_motion oscillation pair_friction "
      "restitution "
      "varying_gravity drag loads spin";
  engine.settings = stiction::ode::kSettings;
  engine.configurations = kConfigurations;
  engine.ladder = kLadder;
  engine.symplectic_euler = 1;
  engine.contacts = contacts;
  engine.save = save;
  engine.restore = restore;
  engine.forget = forget;
  return stiction_engine_main(&engine, argc, argv);
}
