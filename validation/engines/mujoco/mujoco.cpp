// SPDX-License-Identifier: GPL-3.0-or-later
// MuJoCo behind the engine protocol.
#include <cstdio>
#include <cstdlib>

#include "validation/engines/mujoco/simulation.h"
#include "validation/engines/world_functions.h"

namespace {

using stiction_mujoco::Saved, stiction_mujoco::Simulation;

Simulation& as_simulation(void* self) { return *static_cast<Simulation*>(self); }

size_t contacts(void* self, stiction_contact* contacts, size_t room) {
  return as_simulation(self).contacts(contacts, room);
}
void* save(void* self) { return as_simulation(self).save(); }
void restore(void* self, const void* saved) {
  as_simulation(self).restore(*static_cast<const Saved*>(saved));
}
void forget(void*, void* saved) { delete static_cast<Saved*>(saved); }

// In place of MuJoCo's own, which write a file into the working folder.
void warn(const char* words) { std::fprintf(stderr, "MuJoCo: %s\n", words); }
void fail(const char* words) {
  warn(words);
  std::exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  mju_user_warning = warn;
  mju_user_error = fail;
  const stiction_setting settings[] = {
      {"dt", "time step, s (default 0.002)"},
      {"integrator", "Euler (default), implicit"},
      {"cone", "of friction: pyramidal (default), elliptic"},
      {"solver", "Newton (default), CG, PGS"},
      {"iterations", "of the solver, at most (default 100)"},
      {"tolerance", "at which the solver ends (default 1e-8)"},
      {"noslip_iterations", "of the pass that removes slip, at most (default 0)"},
      {"noslip_tolerance", "at which that pass ends (default 1e-6)"},
      {"impratio", "frictional over normal impedance (default 1)"},
      {"solref", "of contacts: time constant in s, damping ratio (default 0.02,1)"},
      {"solimp", "of contacts (default 0.9,0.95,0.001,0.5,2)"},
      {}};
  const stiction_configuration configurations[] = {
      {"default", "", "the defaults of its XML"},
      {"best",
       "cone=elliptic noslip_iterations=30 noslip_tolerance=1e-12 solref=0.006,1 "
       "solimp=0,0.95,0.001,0.5,1",
       "our search at dt=0.002 (least sum of decades of creep, threshold, acceleration, stop and "
       "ball pyramid; of those within 0.3 decades the one in which a box sinks least): elliptic "
       "cone, solref 0.004 to 0.05 s at ratio 0.3 to 10, solimp d0 0 to 0.99, dmax 0.95 to 0.999, "
       "width 0.0001 to 0.01 m, power 1 to 4, impratio 0.001 to 100, noslip 3 and 30 at 1e-6 and "
       "1e-12"},
      {}};
  const char* const ladder[] = {"dt=0.002",   "dt=0.001",    "dt=0.0005",
                                "dt=0.00025", "dt=0.000125", nullptr};
  stiction_engine engine = stiction::world_functions<Simulation>();
  engine.name = "mujoco";
  engine.version = "2.2.2 (Debian, double precision)";
  engine.description = "MuJoCo: soft contacts by convex optimisation, optionally without slip";
  engine.can = "boxes balls body_contact varying_gravity oscillation drag loads spin";
  engine.settings = settings;
  engine.configurations = configurations;
  engine.ladder = ladder;
  engine.symplectic_euler = 1;
  engine.contacts = contacts;
  engine.save = save;
  engine.restore = restore;
  engine.forget = forget;
  return stiction_engine_main(&engine, argc, argv);
}
