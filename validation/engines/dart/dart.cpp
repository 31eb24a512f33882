// SPDX-License-Identifier: GPL-3.0-or-later
// DART behind the engine protocol.
#include "validation/engines/dart/simulation.h"
#include "validation/engines/world_functions.h"

namespace {

using stiction_dart::Simulation;

Simulation& as_simulation(void* self) { return *static_cast<Simulation*>(self); }

size_t contacts(void* self, stiction_contact* contacts, size_t room) {
  return as_simulation(self).contacts(contacts, room);
}

}  // namespace

int main(int argc, char** argv) {
  const stiction_setting settings[] = {
      {"dt", "time step, s (default 0.001)"},
      {"solver", "dantzig (default; PGS where it fails), pgs"},
      {"iterations", "of PGS, at most (default 30)"},
      {"tolerance", "change of an impulse, N s, at which PGS ends (default 1e-6)"},
      {"relative_tolerance", "the same over the impulse (default 1e-3)"},
      {"detector", "fcl (default; shapes are meshes), fcl-primitive, dart"},
      {"erp", "share of the depth that a step removes (default 0.01)"},
      {"error_allowance", "depth that is left, m (default 0)"},
      {"max_erv", "speed at which depth is removed, at most, m/s (default 0.001)"},
      {"cfm", "constraint force mixing, over the diagonal, from 1e-9 (default 1e-5)"},
      {"obstacle_width", "of the box that stands for a half-space, m (default 1000)"},
      {}};
  const stiction_configuration configurations[] = {
      {"default", "", "as dart::simulation::World is made: Dantzig, FCL with shapes as meshes"},
      {"pgs", "solver=pgs", "the same with DART's other solver, as that is made"},
      {"best",
       "detector=dart solver=pgs iterations=1000 tolerance=1e-9 relative_tolerance=1e-12 cfm=1e-9",
       "our search at dt=0.001 (sum of decades of creep, threshold, acceleration, stop and ball "
       "pyramid): detector dart and fcl-primitive, Dantzig and PGS with 100 to 1000 iterations, "
       "cfm 1e-9 to 1e-5, erp 0.01 and 0.1"},
      {}};
  const char* const ladder[] = {"dt=0.001",    "dt=0.0005",    "dt=0.00025",
                                "dt=0.000125", "dt=0.0000625", nullptr};
  stiction_engine engine = stiction::world_functions<Simulation>();
  engine.name = "dart";
  engine.version = DART_VERSION " (Debian, double precision)";
  engine.description = "DART: boxed linear complementarity in velocities, friction by a pyramid";
  engine.can = "boxes balls body_contact varying_gravity oscillation drag loads spin";
  engine.settings = settings;
  engine.configurations = configurations;
  engine.ladder = ladder;
  engine.contacts = contacts;
  return stiction_engine_main(&engine, argc, argv);
}
