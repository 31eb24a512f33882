// SPDX-License-Identifier: GPL-3.0-or-later
// Bullet's deformable bodies (finite elements) behind the engine protocol.
#include <algorithm>

#include "validation/engines/bullet_deformable/world.h"
#include "validation/engines/world_functions.h"

namespace {

using Eigen::Map, Eigen::Vector3d;
using stiction::bullet_deformable::SoftMesh, stiction::bullet_deformable::World;

#ifdef BT_USE_DOUBLE_PRECISION
#define PRECISION "double"
#define NAME "bullet_deformable_double"
#else
#define PRECISION "single"
#define NAME "bullet_deformable"
#endif

World& world(void* self) { return *static_cast<World*>(self); }

void momenta(void* self, double linear[3], double angular[3]) {
  Vector3d p, l;
  world(self).momenta(p, l);
  Map<Vector3d>{linear} = p;
  Map<Vector3d>{angular} = l;
}

size_t surface(void* self, size_t body, uint32_t (*triangles)[3], size_t room) {
  const SoftMesh& mesh = world(self).mesh(body);
  for (size_t k = 0; k < std::min(room, mesh.surface.size()); ++k) {
    std::copy_n(mesh.surface[k].begin(), 3, triangles[k]);
  }
  return mesh.surface.size();
}

size_t vertices(void* self, size_t body, double (*positions)[3], size_t room) {
  const size_t count = world(self).mesh(body).nodes.size();
  for (size_t k = 0; k < std::min(room, count); ++k) {
    Map<Vector3d>{positions[k]} = world(self).node(body, k);
  }
  return count;
}

const stiction_configuration kConfigurations[] = {
    {"implicit",
     "implicit=1 projection=1 dt=0.004166666666666667 iterations=100 erp=0.3 max_correction=200 "
     "residual=0.001",
     "its implicit demo Collide, at the 1/240 s of the other deformable demos; damping is the "
     "material's, not the demo's"},
    {"explicit", "implicit=0 projection=1 iterations=100 erp=0.3 max_correction=200 residual=0.001",
     "setImplicit(false) as in its demo VolumetricDeformable, with the contacts of Collide; dt a "
     "fifth of sound's time over an edge"},
    {}};

const char* const kLadder[] = {"dt=0.001", "dt=0.0005", "dt=0.00025", "dt=0.000125", nullptr};

}  // namespace

int main(int argc, char** argv) {
  stiction_engine engine = stiction::world_functions<World>();
  engine.name = NAME;
  engine.version = "3.24, " PRECISION " precision";
  engine.description = "Bullet's deformable bodies (finite elements), " PRECISION " precision";
  engine.can =
      "boxes balls convex_meshes meshes deformable body_contact moving_obstacles steady_motion "
      "oscillation varying_gravity "
      "drag loads";
  engine.settings = stiction::bullet_deformable::kSettings;
  engine.configurations = kConfigurations;
  engine.ladder = kLadder;
  engine.momenta = momenta;
  engine.surface = surface;
  engine.vertices = vertices;
  return stiction_engine_main(&engine, argc, argv);
}
