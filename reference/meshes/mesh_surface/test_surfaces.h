// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "reference/meshes/closed_surface.h"

/// Surfaces for the tests of this folder, and files of them.
namespace stiction::reference {

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

inline Triangles cube(double edge) {
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

inline Triangles torus(double big, double small, int around, int across) {
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

}  // namespace stiction::reference
