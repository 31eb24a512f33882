// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's mesher as cases call it: through the program.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <vector>

#include "reference/meshes/ball_mesh.h"
#include "reference/meshes/filled_surface.h"
#include "reference/meshes/mesh_surface/test_surfaces.h"
#include "reference/process/child.h"

namespace stiction::reference {
namespace {

using Eigen::Index;

void expect_well_shaped(const SurfaceReport& report) {
  // Perturbation stops at 10°; a sliver of that angle has a largest angle of at most 170° − and an
  // altitude of sin 10° times a triangle's, about 0.1 of a mean edge where edges are half as long.
  EXPECT_GE(report.quality.min_dihedral_angle, 9.5);
  EXPECT_LE(report.quality.max_dihedral_angle, 170.0);
  EXPECT_GE(report.quality.min_altitude, 0.05 * report.mean_edge);
}

TEST_F(ClosedSurface, CubeKeepsItsCornersAndVolume) {
  const SurfaceBody body = body_of_closed_surface(write_off("cube.off", cube(0.1)));
  // Edges are features and faces are flat, so that only rounding is left: vertices on a face are
  // found by intersection, to about 1e-16 of the size each.
  EXPECT_NEAR(body.report.volume, 1e-3, 1e-14);
  EXPECT_NEAR(body.report.given_volume, 1e-3, 1e-17);
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d c = 0.1 * Vector3d(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
    EXPECT_LT((body.mesh.vertices.colwise() - c).colwise().norm().minCoeff(), 1e-15);
  }
  expect_well_shaped(body.report);
}

TEST_F(ClosedSurface, AllFourFormatsGiveTheSameBody) {
  const Triangles t = cube(0.5);
  const SurfaceBody off = body_of_closed_surface(write_off("a.off", t));
  for (const auto& file : {write_obj("a.obj", t), write_ply("a.ply", t), write_stl("a.STL", t)}) {
    const SurfaceBody body = body_of_closed_surface(file);
    EXPECT_EQ(body.report.given_triangles, 12) << file;
    EXPECT_NEAR(body.report.volume, off.report.volume, 1e-12) << file;
  }
}

TEST_F(ClosedSurface, TheSameBitsAgain) {
  const auto file = write_off("torus.off", torus(1.0, 0.4, 24, 12));
  const SurfaceBody one = body_of_closed_surface(file, {.cell_size = 0.3});
  forget_meshes();
  const SurfaceBody two = body_of_closed_surface(file, {.cell_size = 0.3});
  EXPECT_TRUE(one.mesh.vertices == two.mesh.vertices);
  EXPECT_TRUE(one.mesh.tetrahedra == two.mesh.tetrahedra);
}

TEST_F(ClosedSurface, CurvedBodiesStayWithinTheDistanceAskedFor) {
  const TetMesh ball = ball_mesh({.radius = 0.5, .frequency = 8});
  Triangles sphere;
  for (Index v = 0; v < ball.vertices.cols(); ++v) sphere.points.emplace_back(ball.vertices.col(v));
  const Eigen::Matrix3Xi surface = surface_triangles(ball.tetrahedra);
  for (Index f = 0; f < surface.cols(); ++f) sphere.faces.emplace_back(surface.col(f));
  for (const double distance : {0.02, 0.005}) {
    const SurfaceBody body = body_of_closed_surface(write_off("ball.off", sphere),
                                                    {.cell_size = 0.2, .facet_distance = distance});
    // Area 4 π R² times the distance bounds the volume between the two surfaces.
    EXPECT_NEAR(body.report.volume, body.report.given_volume, std::numbers::pi * distance);
    EXPECT_GT(body.report.quality.min_altitude, 0.0);
    expect_well_shaped(body.report);
  }
}

TEST_F(ClosedSurface, HolesAndHandlesAreKept) {
  const SurfaceBody ring =
      body_of_closed_surface(write_off("torus.off", torus(1.0, 0.4, 24, 12)), {.cell_size = 0.25});
  EXPECT_NEAR(ring.report.volume, ring.report.given_volume, 0.05 * ring.report.given_volume);
  Triangles hollow = cube(1.0);
  hollow.append(cube(0.4), Vector3d::Constant(0.3), true);
  const SurfaceBody shell = body_of_closed_surface(write_off("hollow.off", hollow));
  EXPECT_NEAR(shell.report.given_volume, 1.0 - 0.064, 1e-12);
  EXPECT_NEAR(shell.report.volume, 1.0 - 0.064, 1e-10);
}

TEST_F(ClosedSurface, RefusesFilesThatSayNothing) {
  expect_refused(folder_ / "nowhere.off", SurfaceFlaw::missing_file, "no such file");
  expect_refused(write("a.txt", "OFF\n"), SurfaceFlaw::unknown_format, ".stl");
  expect_refused(write("b.off", "no surface at all\n"), SurfaceFlaw::unreadable, "off");
  expect_refused(write("c.off", "OFF\n0 0 0\n"), SurfaceFlaw::empty, "no triangles");
}

TEST_F(ClosedSurface, RefusesSurfacesThatBoundNothing) {
  Triangles t = cube(1.0);
  t.faces.pop_back();
  expect_refused(write_off("open.off", t), SurfaceFlaw::not_closed, "not closed");

  t = cube(1.0);
  t.faces[0].reverseInPlace();
  expect_refused(write_off("mixed.off", t), SurfaceFlaw::not_manifold, "oriented differently");

  t = cube(1.0);
  for (Eigen::Vector3i& face : t.faces) face.reverseInPlace();
  expect_refused(write_off("inwards.off", t), SurfaceFlaw::not_bounding, "look inwards");

  t = cube(1.0);
  t.append(cube(1.0), Vector3d::Constant(0.5));
  expect_refused(write_off("crossing.off", t), SurfaceFlaw::self_intersecting, "intersects itself");

  t = cube(1.0);
  t.append(cube(0.4), Vector3d::Constant(0.3));  // nested, but not a hole
  expect_refused(write_off("nested.off", t), SurfaceFlaw::not_bounding, "contradict");

  t = cube(1.0);
  t.points[7] = t.points[6];
  expect_refused(write_off("flat.off", t), SurfaceFlaw::degenerate, "no area");

  t = cube(1.0);
  t.append(cube(1.0), Vector3d::Constant(1.0));  // the corner (1, 1, 1) belongs to both
  expect_refused(write_off("corner.off", t), SurfaceFlaw::not_manifold, "vertex only");

  expect_refused(write("quads.off",
                       "OFF\n8 6 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
                       "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"),
                 SurfaceFlaw::not_triangles, "4 corners");
}

TEST_F(ClosedSurface, TheProgramAloneSaysWhoseFaultItIs) {
  const auto mesh_surface = [](const std::vector<std::string>& arguments) {
    std::vector<std::string> words = {find_mesher(mesher_places()).string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_child(words);
  };
  const std::string file = write_off("cube.off", cube(1.0)).string();
  const Ended filled = mesh_surface({file});
  EXPECT_EQ(filled.code, kFilled);
  EXPECT_GT(filled_surface_from(filled.output).mesh.tetrahedra.cols(), 0);
  const Ended refused = mesh_surface({"nowhere.off"});
  EXPECT_EQ(refused.code, kFirstFlaw + static_cast<int>(SurfaceFlaw::missing_file));
  EXPECT_EQ(refused.errors, "nowhere.off: there is no such file\n");
  const Ended odd = mesh_surface({"--cell-size", "-1", file});
  EXPECT_EQ(odd.code, kMesherFailed);
  EXPECT_EQ(odd.errors, "cell_size must be finite, ≥ 0\n");
  EXPECT_EQ(mesh_surface({}).code, kMesherFailed);
  EXPECT_EQ(mesh_surface({"--help"}).code, kFilled);
}

// 40 MB of address space are too little for a million tetrahedra.
TEST_F(ClosedSurface, WithoutMemoryCostsItsSurfaceOnly) {
  const auto file = write_off("cube.off", cube(1.0));
  const auto starved = folder_ / "starved";
  std::ofstream(starved) << "#!/bin/sh\nulimit -v 40000\nexec '"
                         << find_mesher(mesher_places()).string() << "' \"$@\"\n";
  std::filesystem::permissions(starved, std::filesystem::perms::owner_all);
  setenv("STICTION_MESHER", starved.c_str(), 1);
  try {
    body_of_closed_surface(file, {.cell_size = 0.01, .most_tetrahedra = 10'000'000});
    ADD_FAILURE() << "it was enough";
  } catch (const MesherError& error) {
    EXPECT_NE(std::string(error.what()).find("the mesher failed: memory ran out"),
              std::string::npos)
        << error.what();
  }
  unsetenv("STICTION_MESHER");
}

}  // namespace
}  // namespace stiction::reference
