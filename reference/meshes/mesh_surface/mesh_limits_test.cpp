// SPDX-License-Identifier: GPL-3.0-or-later
// How large a mesh may be and how long it may take, and what is told of it meanwhile.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "reference/meshes/filled_surface.h"
#include "reference/meshes/mesh_surface/test_surfaces.h"
#include "reference/process/child.h"

namespace stiction::reference {
namespace {

using MeshLimits = ClosedSurface;

Triangles box(double x, double y, double z) {
  Triangles t = cube(1.0);
  for (Vector3d& p : t.points) p = p.cwiseProduct(Vector3d(x, y, z));
  return t;
}

// reference/meshes/mesh_size.h promises it.
TEST_F(MeshLimits, HowManyTetrahedraIsToldWithinAFactorOfTwo) {
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

// A plate of 1 mm was still being meshed after four minutes without a word.
TEST_F(MeshLimits, WhatWouldTakeTooLongIsRefusedAtOnce) {
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

// Without its limit the mesher reads all of these 24 MB, and then finds no triangle.
TEST_F(MeshLimits, AFileThatTakesTooLongToReadIsRefusedAtTheLimit) {
  std::string text;
  for (int k = 0; k < 3'000'000; ++k) text += "v 0 0 0\n";
  const auto file = write("long.obj", text);
  for (const char* const limit : {"0.05", "0.2"}) {
    const auto began = std::chrono::steady_clock::now();
    const Ended ended =
        run_child({find_mesher(mesher_places()).string(), "--reading-limit", limit, file.string()});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    EXPECT_EQ(ended.code, kFirstFlaw + static_cast<int>(SurfaceFlaw::unreadable));
    EXPECT_EQ(ended.errors, file.string() + ": reading it took longer than " + limit +
                                " s: give a surface of fewer triangles, or as binary STL\n");
    EXPECT_GE(took.count(), std::stod(limit));
  }
}

// Thin needles along a diagonal, side by side: the boxes around any two of their triangles overlap, so
// that each pair is looked at.
TEST_F(MeshLimits, ASurfaceThatTakesTooLongToCheckIsGivenUpInASentence) {
  Triangles needles;
  for (int k = 0; k < 3000; ++k) {
    Triangles needle;
    needle.points = {{0, 0, 0}, {1e-5, 0, 0}, {0, 1e-5, 0}, {1, 1, 1}};
    needle.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    needles.append(needle, Vector3d(1e-4 * k, -1e-4 * k, 0.0));
  }
  try {
    body_of_closed_surface(write_off("needles.off", needles), {.time_limit = 1.0});
    ADD_FAILURE() << "it was meshed";
  } catch (const MesherError& error) {
    EXPECT_NE(
        std::string(error.what())
            .find(
                "the mesher was stopped after 1 s, still reading or checking the triangles: give a "
                "surface of fewer, or raise time_limit"),
        std::string::npos)
        << error.what();
  }
}

TEST_F(MeshLimits, TellsWhatItDoesWhileItDoesIt) {
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
