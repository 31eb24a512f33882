// SPDX-License-Identifier: GPL-3.0-or-later
// Files that no honest program wrote: whatever they hold, the mesher says one sentence of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "reference/meshes/closed_surface.h"
#include "reference/meshes/filled_surface.h"
#include "reference/process/child.h"

namespace stiction::reference {
namespace {

using testing::HasSubstr;

struct SurfaceFile {
  const char* name;
  std::string bytes;
};

constexpr double kPoints[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

template <class Number>
std::string raw(Number number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

std::string words(const auto& three, double shift = 0.0) {
  std::string line;
  for (const auto one : three) line += std::to_string(static_cast<int>(one + shift)) + " ";
  return line;
}

std::string ply_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

// A tetrahedron in every way that is read.
std::vector<SurfaceFile> tetrahedra() {
  std::string off = "OFF\n4 4 0\n", obj, ply = ply_header("ascii"), stl = "solid body\n";
  std::string binary_ply = ply_header("binary_little_endian");
  std::string binary_stl(80, 'x');
  binary_stl += raw(std::uint32_t{4});
  for (const auto& point : kPoints) {
    off += words(point) + "\n";
    obj += "v " + words(point) + "\n";
    ply += words(point) + "\n";
    for (const double one : point) binary_ply += raw(static_cast<float>(one));
  }
  for (const auto& face : kFaces) {
    off += "3 " + words(face) + "\n";
    obj += "f " + words(face, 1.0) + "\n";
    ply += "3 " + words(face) + "\n";
    binary_ply += raw(std::uint8_t{3});
    for (const int one : face) binary_ply += raw(one);
    stl += "facet normal 0 0 0\nouter loop\n";
    for (int k = 0; k < 3; ++k) binary_stl += raw(0.0F);
    for (const int corner : face) {
      stl += "vertex " + words(kPoints[corner]) + "\n";
      for (const double one : kPoints[corner]) binary_stl += raw(static_cast<float>(one));
    }
    stl += "endloop\nendfacet\n";
    binary_stl += raw(std::uint16_t{0});
  }
  return {{"a.off", off},
          {"a.obj", obj},
          {"a.ply", ply},
          {"b.ply", binary_ply},
          {"a.stl", stl + "endsolid body\n"},
          {"b.stl", binary_stl}};
}

// One to three bytes or pieces changed, left out, doubled or put in.
std::string mutated(std::string bytes, std::mt19937& chance) {
  static const std::vector<std::string> pieces = {"9999999999",
                                                  "-1",
                                                  "nan",
                                                  "1e400",
                                                  "element face 3\n",
                                                  "property list uchar uchar q\n",
                                                  std::string("\0\0\xff\xff", 4)};
  const auto below = [&](std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(0, most)(chance);
  };
  for (std::size_t left = 1 + below(2); left > 0; --left) {
    const std::size_t at = below(bytes.size()), length = 1 + below(19);
    const std::size_t what = below(4);
    if (what == 0 && at < bytes.size()) bytes[at] = static_cast<char>(below(255));
    if (what == 1) bytes.erase(at, length);
    if (what == 2) bytes.insert(at, bytes.substr(at, length));
    if (what == 3) bytes.insert(at, pieces[below(pieces.size() - 1)]);
    if (what == 4) bytes.resize(at);
  }
  return bytes;
}

class HostileSurface : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "hostile_surface_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    mesher_ = find_mesher(mesher_places()).string();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  // How the mesher ends with such a file, with a tenth of the memory that it would give itself.
  Ended mesh(const std::string& name, const std::string& bytes) const {
    const std::string file = write(name, bytes).string();
    return run_child(
        {"sh", "-c", "ulimit -v 400000; exec \"$@\"", "sh", mesher_, "--cell-size", "0.5", file},
        {.time_limit = 20.0});
  }

  static bool is_refusal(const Ended& ended) {
    const int flaw = ended.code - kFirstFlaw;
    return flaw >= 0 && flaw < kSurfaceFlaws && ended.errors.find('\n') + 1 == ended.errors.size();
  }

  std::filesystem::path folder_;
  std::string mesher_;
};

TEST_F(HostileSurface, EachWayToWriteATetrahedronIsRead) {
  for (const SurfaceFile& file : tetrahedra()) {
    const Ended ended = mesh(file.name, file.bytes);
    EXPECT_EQ(ended.code, kFilled) << file.name << ": " << ended.errors;
  }
}

// CGAL's readers fall over some of these: of 200 PLY files two end them with a segmentation fault.
TEST_F(HostileSurface, WhateverIsChangedIsMeshedOrRefusedInASentence) {
  for (const SurfaceFile& file : tetrahedra()) {
    std::mt19937 chance(7);
    for (int k = 0; k < 200; ++k) {
      const std::string bytes = mutated(file.bytes, chance);
      const Ended ended = mesh(file.name, bytes);
      ASSERT_FALSE(ended.timed_out) << file.name << ", change " << k;
      EXPECT_TRUE(ended.code == kFilled || is_refusal(ended))
          << file.name << ", change " << k << ": exit code " << ended.code << ", " << ended.errors
          << "\n"
          << testing::PrintToString(bytes);
    }
  }
}

TEST_F(HostileSurface, ReadersThatFallOverRefuseTheFile) {
  for (const std::string& header :
       {std::string("ply\n"), std::string("ply\nformat ascii 1.0\nend_header\n"),
        std::string("ply\nformat binary_little_endian 1.0\nelement face 1\nend_header\n"),
        std::string("ply\nformat ascii 1.0\nelement vertex 1\nend_header\n1\n"),
        std::string("ply\nformat ascii 1.0\nproperty float x\nend_header\n")}) {
    const Ended ended = mesh("header.ply", header);
    EXPECT_TRUE(is_refusal(ended)) << ended.code << ": " << ended.errors << header;
  }
}

// Products of such lengths are no numbers: CGAL's mesher ended with SIGFPE in GMP.
TEST_F(HostileSurface, LengthsThatCannotBeComputedWithAreRefused) {
  const auto said = [&](const std::string& coordinate) {
    const Ended ended =
        mesh("small.off", "OFF\n4 4 0\n0 0 0\n1 0 " + coordinate +
                              "\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    EXPECT_TRUE(ended.code == kFilled || is_refusal(ended)) << ended.code << ": " << ended.errors;
    return ended.errors;
  };
  EXPECT_THAT(said("1e-320"), HasSubstr("write it as 0"));
  EXPECT_THAT(said("-1e-61"), HasSubstr("a coordinate is -1e-61 and others 1, which"));
  EXPECT_THAT(said("1e200"), HasSubstr("its largest coordinate is 1e+200, which"));
  EXPECT_THAT(said("1e21"), HasSubstr("write it in another unit"));
  EXPECT_THAT(said("1e-59"), HasSubstr("expected"));
}

// CGAL's mesher had no end of the first, and overran its stack with the second.
TEST_F(HostileSurface, CornersThatAreNearlyOneAreRefused) {
  for (const std::string near : {"1e-20", "1e-40"}) {
    const Ended ended = mesh("near.off", "OFF\n5 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + near + " " +
                                             near + " " + near +
                                             "\n3 0 2 4\n3 2 1 4\n3 1 0 4\n3 0 1 3\n"
                                             "3 0 3 2\n3 1 2 3\n");
    EXPECT_TRUE(is_refusal(ended)) << ended.code << ": " << ended.errors;
    EXPECT_THAT(ended.errors, HasSubstr("apart and its largest coordinate is 1: make them one"));
  }
}

// A count that the file cannot hold is refused before memory is asked for.
TEST_F(HostileSurface, CountsBeyondTheFileAreRefused) {
  const std::string rest = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto said = [&](const std::string& name, const std::string& bytes) {
    const auto began = std::chrono::steady_clock::now();
    const Ended ended = mesh(name, bytes);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    EXPECT_TRUE(is_refusal(ended)) << ended.code << ": " << ended.errors;
    EXPECT_LT(took.count(), 2.0);
    return ended.errors;
  };
  EXPECT_THAT(said("v.off", "OFF\n300000000 1 0\n" + rest), HasSubstr("has 300000000 vertices"));
  EXPECT_THAT(said("f.off", "OFF 3 # three\n300000000 0\n" + rest),
              HasSubstr("has 300000000 faces"));
  EXPECT_THAT(said("v.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nend_header\n"),
              HasSubstr("has 4000000000 vertices"));
  EXPECT_THAT(said("f.ply", "ply\nformat ascii 1.0\nelement face 99999\nend_header\n"),
              HasSubstr("has 99999 faces"));
  EXPECT_THAT(said("b.stl", std::string(80, 'x') + raw(std::uint32_t{0xffffffff}) + rest),
              HasSubstr("has 4294967295 triangles"));
  EXPECT_THAT(said("long.off", "OFF\n" + std::string(300, '9') + "\x1b[2J 1 0\n" + rest),
              HasSubstr("says that it has more vertices"));
  EXPECT_THAT(said("binary.off", "OFF BINARY\n" + rest), HasSubstr("only text can be read"));
  // The corners of a face are counted too, where no header tells of them.
  EXPECT_THAT(said("c.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n900000000 0 1 2\n"),
              HasSubstr("can't be read as off"));
}

// Nothing of it is read: a gap takes no room on the disk.
TEST_F(HostileSurface, AFileOfManyGigabytesIsRefused) {
  const auto file = write("gap.obj", "v 0 0 0\n");
  std::filesystem::resize_file(file, std::uintmax_t{10} << 30);
  const Ended ended = run_child({mesher_, file.string()}, {.time_limit = 20.0});
  EXPECT_TRUE(is_refusal(ended)) << ended.code;
  EXPECT_THAT(ended.errors, HasSubstr("it has 10 737 MB; at most 500 are read"));
  EXPECT_THROW(body_of_closed_surface(file), SurfaceError);
}

}  // namespace
}  // namespace stiction::reference
