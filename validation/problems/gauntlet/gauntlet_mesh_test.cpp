// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/gauntlet/gauntlet_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <ostream>
#include <tuple>

#include "reference/meshes/box_mesh.h"

namespace stiction {
namespace {

struct KnownMesh {
  const char* name;
  TetMesh mesh;
  double volume;          // m³, by its formula
  bool symmetric = true;  // about the planes x = 0 and y = 0
};
void PrintTo(const KnownMesh& shape, std::ostream* out) { *out << shape.name; }

// A quarter of each vertex's tetrahedra, by its place to a nanometre.
std::map<std::tuple<long, long, long>, double> lumped(const TetMesh& mesh, double sign_x,
                                                      double sign_y) {
  const auto rounded = [](double x) { return std::lround(1e9 * x); };
  std::map<std::tuple<long, long, long>, double> masses;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    for (const int v : mesh.tetrahedra.col(e)) {
      const Vec3 at = mesh.vertices.col(v);
      masses[{rounded(sign_x * at.x()), rounded(sign_y * at.y()), rounded(at.z())}] +=
          0.25 * signed_volume(mesh, e);
    }
  }
  return masses;
}

class GauntletMesh : public testing::TestWithParam<KnownMesh> {};

TEST_P(GauntletMesh, IsClosedAndPositive) {
  const reference::MeshCertificate found = reference::certify(GetParam().mesh);
  EXPECT_EQ(found.non_positive_tetrahedra, 0);
  EXPECT_EQ(found.non_manifold_faces, 0);
  EXPECT_EQ(found.unused_vertices, 0);
  EXPECT_TRUE(found.boundary_closed);
  EXPECT_EQ(found.boundary_euler_characteristic, 2);
}

TEST_P(GauntletMesh, HasTheVolumeOfItsFormula) {
  const auto [centre, volume] = centre_and_volume(GetParam().mesh);
  EXPECT_NEAR(volume, GetParam().volume, 1e-12 * GetParam().volume);  // a few hundred roundings
}

TEST_P(GauntletMesh, HasMassesAsSymmetricAsItsShape) {
  const KnownMesh& shape = GetParam();
  if (!shape.symmetric) return;
  const auto own = lumped(shape.mesh, 1.0, 1.0);
  for (const auto& mirrored : {lumped(shape.mesh, -1.0, 1.0), lumped(shape.mesh, 1.0, -1.0)}) {
    ASSERT_EQ(mirrored.size(), own.size());
    for (const auto& [place, mass] : own) {
      ASSERT_EQ(mirrored.count(place), 1u);
      EXPECT_NEAR(mirrored.at(place), mass, 1e-12 * mass);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, GauntletMesh,
    testing::Values(
        KnownMesh{"spike", spike_bed_mesh({}), 0.03 * 0.03 * (0.02 + 0.02 / 3.0)},
        KnownMesh{"spikes_down", spike_bed_mesh({.pads_x = 2, .pads_y = 3, .height = -0.01}),
                  6 * 0.03 * 0.03 * (0.02 + 0.01 / 3.0)},
        KnownMesh{"wedge", wedge_mesh({}), 0.06 * 0.06 * (0.02 + 0.01)},
        KnownMesh{"wedge_down", wedge_mesh({.height = -0.01}), 0.06 * 0.06 * (0.02 + 0.005)},
        KnownMesh{"ridged_block", ridged_mesh({.height = -0.015}),
                  0.08 * (0.108 * 0.02 + 2 * 0.5 * 0.036 * 0.015)},
        KnownMesh{"valley", valley_mesh({.depth = 0.01}), 0.06 * 0.06 * (0.02 + 0.005)},
        KnownMesh{"flat", flat_mesh(0.3, 0.02, 4, false), 0.3 * 0.3 * 0.02},
        KnownMesh{"irregular_flat", flat_mesh(0.3, 0.02, 15, true), 0.3 * 0.3 * 0.02, false},
        KnownMesh{"hook", balancer_mesh(Foot::kNone), 22 * 0.02 * 0.02 * 0.04},
        KnownMesh{"balancer_on_a_spike", balancer_mesh(Foot::kSpike),
                  22 * 0.02 * 0.02 * 0.04 + 0.04 * 0.04 * 0.02 / 3.0},
        KnownMesh{"balancer_on_a_ridge", balancer_mesh(Foot::kRidge),
                  22 * 0.02 * 0.02 * 0.04 + 0.04 * 0.04 * 0.02 / 2.0}),
    [](const auto& instance) { return instance.param.name; });

TEST(GauntletBalancer, HasItsCentreOfMassBelowItsTip) {
  for (const Foot foot : {Foot::kNone, Foot::kSpike, Foot::kRidge}) {
    const Vec3 centre = centre_and_volume(balancer_mesh(foot)).first;
    EXPECT_NEAR(centre.x(), 0.0, 1e-15);
    EXPECT_NEAR(centre.y(), 0.0, 1e-15);
    EXPECT_LT(centre.z(), -0.015);
  }
}

TEST(GauntletFlat, IsFlat) {
  for (const bool irregular : {false, true}) {
    const TetMesh mesh = flat_mesh(0.3, 0.02, 15, irregular);
    for (const auto& at : mesh.vertices.colwise()) {
      EXPECT_TRUE(at.z() == 0.0 || at.z() == -0.02);
    }
  }
}

}  // namespace
}  // namespace stiction
