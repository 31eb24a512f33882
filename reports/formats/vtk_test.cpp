// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/vtk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "reports/recording/test_recording.h"

namespace stiction {
namespace {

using ::testing::HasSubstr;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++found;
  }
  return found;
}

TEST(Vtk, BodiesHaveTheirPointsAndTriangles) {
  const Recording recording = sliding_box();
  const std::string text = vtp_bodies(recording, recording.frames[0]);
  EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"8\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
                              "NumberOfStrips=\"0\" NumberOfPolys=\"12\""));
  EXPECT_THAT(text, HasSubstr("-0.1 -0.1 0\n0.1 -0.1 0\n"));
  EXPECT_THAT(text, HasSubstr("0 2 1\n0 3 2\n"));
  EXPECT_THAT(text, HasSubstr("\n36\n</DataArray>"));
}

TEST(Vtk, CornersOfASecondBodyFollowThoseOfTheFirst) {
  Recording recording = sliding_box();
  recording.bodies.push_back({"sheet", 3, {{0, 1, 2}}});
  for (Frame& frame : recording.frames) frame.positions.resize(11, Triple{0.0, 0.0, 1.0});
  EXPECT_THAT(vtp_bodies(recording, recording.frames[0]), HasSubstr("\n8 9 10\n"));
}

TEST(Vtk, ContactsCarryForcesAndState) {
  const Recording recording = sliding_box();
  const std::string slipping = vtp_contacts(recording.frames[0]);
  EXPECT_THAT(slipping, HasSubstr("Name=\"friction_force\" NumberOfComponents=\"3\" "
                                  "format=\"ascii\">\n-1.22625 0 0\n"));
  EXPECT_THAT(slipping,
              HasSubstr("Name=\"sticks\" NumberOfComponents=\"1\" format=\"ascii\">\n0\n"));
  EXPECT_THAT(vtp_contacts(recording.frames.back()),
              HasSubstr("Name=\"sticks\" NumberOfComponents=\"1\" format=\"ascii\">\n1\n"));
}

TEST(Vtk, CollectionNamesAFileForEachFrame) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "stiction_vtk_test";
  std::filesystem::remove_all(folder);
  const Recording recording = sliding_box();
  write_vtk(folder, "box", recording);
  std::ifstream stream(folder / "box.pvd");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_EQ(count(text, "<DataSet "), 2 * recording.frames.size());
  EXPECT_THAT(text, HasSubstr("timestep=\"0.4\" part=\"0\" file=\"box/bodies_0040.vtp\""));
  EXPECT_TRUE(std::filesystem::exists(folder / "box" / "contacts_0040.vtp"));
  EXPECT_THROW(write_vtk(folder, "../box", recording), std::invalid_argument);
  EXPECT_THROW(write_vtk("/proc/none", "box", recording), std::runtime_error);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace stiction
