// SPDX-License-Identifier: GPL-3.0-or-later
// What closed surfaces make of their mesher, whatever it does. Its own tests: mesh_surface/.
#include "reference/meshes/closed_surface.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "reference/meshes/box_mesh.h"
#include "reference/meshes/filled_surface.h"

namespace stiction::reference {
namespace {

namespace fs = std::filesystem;

class Mesher : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("stiction mesher " +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::create_directories(folder_);
  }
  void TearDown() override {
    unsetenv("STICTION_MESHER");
    fs::remove_all(folder_);
  }

  fs::path script(const std::string& name, const std::string& lines) const {
    const fs::path file = folder_ / name;
    std::ofstream(file) << "#!/bin/sh\n" << lines << '\n';
    fs::permissions(file, fs::perms::owner_all);
    return file;
  }

  /// The mesher does what these lines of shell say.
  void mesher_does(const std::string& lines) const {
    setenv("STICTION_MESHER", script("mesher", lines).c_str(), 1);
  }

  void mesher_writes(const FilledSurface& filled) const {
    std::ofstream(folder_ / "answer") << to_text(filled);
    mesher_does("cat '" + (folder_ / "answer").string() + "'");
  }

  static std::string sentence(const SurfaceOptions& options = {}) {
    try {
      body_of_closed_surface("part.stl", options);
    } catch (const MesherError& error) {
      return error.what();
    }
    return "it made a body";
  }

  fs::path folder_;
};

TEST_F(Mesher, GivesTheMeshThatIsMeasured) {
  mesher_writes({12, 1.0, box_mesh({1.0, 1.0, 1.0}, {1, 1, 1})});
  const SurfaceBody body = body_of_closed_surface("part.stl");
  EXPECT_EQ(body.report.given_triangles, 12);
  EXPECT_EQ(body.report.given_volume, 1.0);
  EXPECT_EQ(body.report.vertices, 8);
  EXPECT_EQ(body.report.tetrahedra, 5);
  EXPECT_EQ(body.report.surface_triangles, 12);
  EXPECT_EQ(body.report.volume, 1.0);
  // Twelve edges of 1 m, six diagonals; a sum of eighteen doubles.
  EXPECT_NEAR(body.report.mean_edge, (12.0 + 6.0 * std::sqrt(2.0)) / 18.0, 1e-15);
}

TEST_F(Mesher, IsToldTheFileAndTheOptionsToTheBit) {
  mesher_does("echo \"$@\" >&2; exit 2");
  EXPECT_EQ(sentence({.cell_size = 0.1,
                      .facet_distance = std::nextafter(0.1, 1.0),
                      .feature_angle = 30.0,
                      .seed = 7,
                      .unit = 1e-3,
                      .most_tetrahedra = 5000}),
            "part.stl: the mesher failed: --cell-size 0.1 --facet-distance 0.10000000000000002 "
            "--feature-angle 30 --seed 7 --most-tetrahedra 5000 --unit 0.001 -- part.stl");
}

TEST_F(Mesher, RefusesASurfaceInItsOwnWords) {
  for (int flaw = 0; flaw < kSurfaceFlaws; ++flaw) {
    mesher_does("echo a warning >&2; echo 'part.stl: it is odd' >&2; exit " +
                std::to_string(kFirstFlaw + flaw));
    try {
      body_of_closed_surface("part.stl");
      ADD_FAILURE() << flaw << " was accepted";
    } catch (const SurfaceError& error) {
      EXPECT_EQ(static_cast<int>(error.flaw()), flaw);
      EXPECT_STREQ(error.what(), "part.stl: it is odd");
    }
  }
}

TEST_F(Mesher, ThatCrashesCostsItsSurfaceOnly) {
  mesher_does("kill -SEGV $$");
  EXPECT_EQ(sentence(), "part.stl: the mesher ended with signal 11 (Segmentation fault)");
  mesher_does("kill -KILL $$");
  EXPECT_EQ(sentence(),
            "part.stl: the mesher was killed (signal 9), as happens when memory runs out: choose a "
            "larger cell_size");
  mesher_does("exit 3");
  EXPECT_EQ(sentence(), "part.stl: the mesher failed: exit code 3");
  mesher_does("exit 99");
  EXPECT_EQ(sentence(), "part.stl: the mesher failed: exit code 99");
  mesher_does("exec sleep 60");
  EXPECT_EQ(sentence({.time_limit = 0.1}),
            "part.stl: the mesher was stopped after 0.1 s, still reading or checking the "
            "triangles: give a surface of fewer, or raise time_limit");
  mesher_does("echo expected 185185 0.03 >&2; exec sleep 60");
  EXPECT_EQ(
      sentence({.unit = 0.1, .time_limit = 0.5}),
      "part.stl: the mesher was stopped after 0.5 s: choose a larger cell_size, such as 0.006 "
      "m, or raise time_limit");
}

TEST_F(Mesher, ThatWritesNoWholeMeshIsFoundOut) {
  mesher_does("echo stiction filled surface 2");
  EXPECT_EQ(sentence(), "part.stl: the mesher wrote no mesh: '1' is missing");
  // A crash after half of the answer, and an answer that is no sound mesh.
  mesher_writes({12, 1.0, box_mesh({1.0, 1.0, 1.0}, {1, 1, 1})});
  mesher_does("head -n 5 '" + (folder_ / "answer").string() + "'");
  EXPECT_NE(sentence().find("the mesher wrote no mesh: "), std::string::npos) << sentence();
  for (const bool inverted : {false, true}) {
    FilledSurface filled{12, 1.0, {}};
    if (inverted) {
      filled.mesh = box_mesh({1.0, 1.0, 1.0}, {1, 1, 1});
      filled.mesh.tetrahedra.row(0).swap(filled.mesh.tetrahedra.row(1));
    }
    mesher_writes(filled);
    EXPECT_THROW(body_of_closed_surface("part.stl"), SurfaceError);
  }
}

TEST_F(Mesher, ThatIsMissingIsSaid) {
  setenv("STICTION_MESHER", (folder_ / "nowhere").c_str(), 1);
  EXPECT_EQ(sentence(), "part.stl: the mesher can't be run: there is no program '" +
                            (folder_ / "nowhere").string() + "'");
  EXPECT_THROW(find_mesher({.folders = {folder_}}), MesherError);
  EXPECT_THROW(find_mesher({.folders = {folder_}, .builder = "/bin/false"}), MesherError);
  EXPECT_THROW(find_mesher({.folders = {folder_}, .builder = "/bin/true"}), MesherError);
}

TEST_F(Mesher, IsBuiltWhenItIsFirstCalledFor) {
  const fs::path builder = script("builder",
                                  "[ \"$*\" = mesher ] && cd \"$(dirname \"$0\")\" && "
                                  "cp builder mesh_surface");
  EXPECT_EQ(find_mesher({.folders = {folder_}, .builder = builder}), folder_ / "mesh_surface");
  EXPECT_EQ(find_mesher({.folders = {folder_}}), folder_ / "mesh_surface");
}

TEST_F(Mesher, RefusesOptionsThatMakeNoSense) {
  mesher_does("kill -SEGV $$");  // it is not even asked
  EXPECT_THROW(body_of_closed_surface("part.stl", {.cell_size = -1.0}), std::invalid_argument);
  EXPECT_THROW(body_of_closed_surface("part.stl",
                                      {.facet_distance = std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
  EXPECT_THROW(body_of_closed_surface("part.stl", {.time_limit = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace stiction::reference
