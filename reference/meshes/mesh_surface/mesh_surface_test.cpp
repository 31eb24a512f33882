// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's mesher as cases call it: through the program.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <vector>

#include "reference/meshes/ball_mesh.h"
#include "reference/meshes/closed_surface.h"
#include "reference/meshes/filled_surface.h"
#include "reference/process/child.h"

namespace stiction::reference {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

struct Triangles {
  std::vector<Vector3d> points;
  std::vector<Eigen::Vector3i> faces;

  /// One quadrilateral, cut along its shorter way.
  void quad(int a, int b, int c, int d) {
    faces.emplace_back(a, b, c);
    faces.emplace_back(a, c, d);
  }

  void append(const Triangles& other, const Vector3d& shift, bool inside_out = false) {
    const Eigen::Vector3i offset = Eigen::Vector3i::Constant(static_cast<int>(points.size()));
    for (const Vector3d& p : other.points) points.emplace_back(p + shift);
    for (const Eigen::Vector3i& f : other.faces) {
      const Eigen::Vector3i face = f + offset;
      faces.emplace_back(inside_out ? face.reverse().eval() : face);
    }
  }
};

Triangles cube(double edge) {
  Triangles t;
  for (int k = 0; k < 8; ++k) {
    t.points.emplace_back(edge * (k & 1), edge * ((k >> 1) & 1), edge * ((k >> 2) & 1));
  }
  t.quad(0, 2, 3, 1);
  t.quad(4, 5, 7, 6);
  t.quad(0, 1, 5, 4);
  t.quad(2, 6, 7, 3);
  t.quad(0, 4, 6, 2);
  t.quad(1, 3, 7, 5);
  return t;
}

Triangles torus(double big, double small, int around, int across) {
  Triangles t;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2.0 * std::numbers::pi * i / around;
      const double v = 2.0 * std::numbers::pi * j / across;
      const double ring = big + small * std::cos(v);
      t.points.emplace_back(ring * std::cos(u), ring * std::sin(u), small * std::sin(v));
      const int next_i = (i + 1) % around;
      const int next_j = (j + 1) % across;
      t.quad(i * across + j, next_i * across + j, next_i * across + next_j, i * across + next_j);
    }
  }
  return t;
}

class ClosedSurface : public testing::Test {
 protected:
  /// Each test its own folder, so that tests may run side by side.
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("stiction_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
    forget_meshes();
  }
  // So that the mesher is asked, not what is remembered of it.
  void forget_meshes() const {
    std::filesystem::remove_all(folder_ / "cache");
    setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  std::filesystem::path write_off(const std::string& name, const Triangles& t) const {
    std::ofstream file(folder_ / name);
    file.precision(17);
    file << "OFF\n" << t.points.size() << ' ' << t.faces.size() << " 0\n";
    for (const Vector3d& p : t.points) file << p.transpose() << '\n';
    for (const Eigen::Vector3i& f : t.faces) file << "3 " << f.transpose() << '\n';
    return folder_ / name;
  }

  std::filesystem::path write_obj(const std::string& name, const Triangles& t) const {
    std::ofstream file(folder_ / name);
    for (const Vector3d& p : t.points) file << "v " << p.transpose() << '\n';
    for (const Eigen::Vector3i& f : t.faces) {
      file << "f " << (f.array() + 1).matrix().transpose() << '\n';
    }
    return folder_ / name;
  }

  std::filesystem::path write_ply(const std::string& name, const Triangles& t) const {
    std::ofstream file(folder_ / name);
    file << "ply\nformat ascii 1.0\nelement vertex " << t.points.size()
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
         << t.faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vector3d& p : t.points) file << p.transpose() << '\n';
    for (const Eigen::Vector3i& f : t.faces) file << "3 " << f.transpose() << '\n';
    return folder_ / name;
  }

  std::filesystem::path write_stl(const std::string& name, const Triangles& t) const {
    std::ofstream file(folder_ / name);
    file << "solid body\n";
    for (const Eigen::Vector3i& f : t.faces) {
      file << "facet normal 0 0 0\nouter loop\n";
      for (const int corner : f) {
        file << "vertex " << t.points[static_cast<std::size_t>(corner)].transpose() << '\n';
      }
      file << "endloop\nendfacet\n";
    }
    file << "endsolid body\n";
    return folder_ / name;
  }

  static void expect_refused(const std::filesystem::path& file, SurfaceFlaw flaw,
                             const std::string& reason) {
    try {
      body_of_closed_surface(file);
      ADD_FAILURE() << file << " was accepted";
    } catch (const SurfaceError& error) {
      EXPECT_EQ(error.flaw(), flaw) << error.what();
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }

  std::filesystem::path folder_;
};

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

Triangles box(double x, double y, double z) {
  Triangles t = cube(1.0);
  for (Vector3d& p : t.points) p = p.cwiseProduct(Vector3d(x, y, z));
  return t;
}

// reference/meshes/mesh_size.h promises it.
TEST_F(ClosedSurface, HowManyTetrahedraIsToldWithinAFactorOfTwo) {
  for (const Vector3d& size :
       {Vector3d(1, 1, 1), Vector3d(1, 1, 0.02), Vector3d(1, 0.02, 0.02), Vector3d(1, 0.5, 0.05)}) {
    for (const double cell : {0.2, 0.1}) {
      double told = 0.0;
      const auto file = write_off("box.off", box(size.x(), size.y(), size.z()));
      const Ended ended = run_child({find_mesher(mesher_places()).string(), "--cell-size",
                                     std::to_string(cell), file.string()});
      std::string word;
      std::istringstream(ended.errors) >> word >> told;
      EXPECT_EQ(word, kExpected);
      const auto made =
          static_cast<double>(filled_surface_from(ended.output).mesh.tetrahedra.cols());
      EXPECT_LT(std::abs(std::log2(made / told)), 1.0)
          << size.transpose() << ", cell " << cell << ": " << told << " told, " << made << " made";
    }
  }
}

// A plate of 1 mm took nine minutes without a word.
TEST_F(ClosedSurface, WhatWouldTakeTooLongIsRefusedAtOnce) {
  const auto began = std::chrono::steady_clock::now();
  expect_refused(write_off("plate.off", box(1, 1, 0.001)), SurfaceFlaw::too_large,
                 "it is about 0.001 m thin, which no cell_size helps");
  try {
    body_of_closed_surface(write_off("cube.off", cube(1000.0)), {.cell_size = 1.0, .unit = 1e-3});
    ADD_FAILURE() << "it was meshed";
  } catch (const SurfaceError& error) {
    EXPECT_EQ(error.flaw(), SurfaceFlaw::too_large);
    EXPECT_NE(std::string(error.what()).find("choose a cell_size of 0.03 m or more"),
              std::string::npos)
        << error.what();
  }
  // Most of it is thick, so that the mean tells nothing of its thin part.
  Triangles mixed = cube(1.0);
  mixed.append(box(1.0, 1.0, 0.001), Vector3d(2.0, 0.0, 0.0));
  try {
    body_of_closed_surface(write_off("mixed.off", mixed), {.most_tetrahedra = 20'000});
    ADD_FAILURE() << "it was meshed";
  } catch (const SurfaceError& error) {
    EXPECT_EQ(error.flaw(), SurfaceFlaw::too_large);
    EXPECT_NE(std::string(error.what()).find("thin or fine parts"), std::string::npos);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  EXPECT_LT(took.count(), 60.0);
}

TEST_F(ClosedSurface, TellsWhatItDoesWhileItDoesIt) {
  std::vector<MeshingProgress> told;
  SurfaceOptions options{.cell_size = 0.04};
  options.progress = [&](const MeshingProgress& now) { told.push_back(now); };
  const auto file = write_off("cube.off", cube(1.0));
  const SurfaceBody body = body_of_closed_surface(file, options);
  ASSERT_GT(told.size(), 2u);
  EXPECT_GT(told.back().seconds, told.front().seconds);
  EXPECT_NEAR(told.back().tetrahedra, 5.0 / std::pow(0.04, 3), 1.0);
  told.clear();
  const SurfaceBody again = body_of_closed_surface(file, options);
  EXPECT_TRUE(told.empty()) << "it is remembered";
  EXPECT_TRUE(again.mesh.vertices == body.mesh.vertices);
  EXPECT_TRUE(again.mesh.tetrahedra == body.mesh.tetrahedra);
  EXPECT_EQ(again.report.given_triangles, 12);
}

}  // namespace
}  // namespace stiction::reference
