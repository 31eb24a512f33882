// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stiction::reference {
namespace {

using testing::HasSubstr;

MeshSize box(double x, double y, double z, double cell) {
  return {x * y * z, 2.0 * (x * y + y * z + z * x), cell};
}

// A cube is a third of its edge "thick": 2 a³ / 6 a².
TEST(MeshSize, IsSetByTheCellOrByTheThickness) {
  EXPECT_DOUBLE_EQ(box(1, 1, 1, 0.1).thickness(), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(box(1, 1, 1, 0.1).tetrahedra(), 5000.0);
  EXPECT_DOUBLE_EQ(box(1, 1, 1, 0.05).tetrahedra(), 40000.0);
  const MeshSize plate = box(1, 1, 0.001, 0.2);
  EXPECT_NEAR(plate.tetrahedra(), 5e6, 0.05e6) << "as if of cells as large as it is thick";
  EXPECT_EQ(plate.tetrahedra(), box(1, 1, 0.001, 2.0).tetrahedra());
}

TEST(MeshSize, TheAdviceIsEnough) {
  const MeshSize fine = box(1, 1, 1, 0.001);
  EXPECT_THAT(fine.advice(200'000), HasSubstr("choose a cell_size of 0.03 m or more"));
  EXPECT_LE(box(1, 1, 1, 0.03).tetrahedra(), 200'000);
  EXPECT_THAT(fine.advice(200'000, 1e-3), HasSubstr("cell_size of 3e-05 m or more"));
  EXPECT_THAT(box(1, 1, 0.001, 0.2).advice(200'000),
              HasSubstr("0.001 m thin, which no cell_size helps"));
}

TEST(MeshSize, CountsAreReadAtAGlance) {
  EXPECT_EQ(in_words(1234.4), "1234");
  EXPECT_EQ(in_words(200'000), "200 000");
  EXPECT_EQ(in_words(52'007), "52 007");
  EXPECT_EQ(in_words(5.16e6), "5.16 million");
  EXPECT_EQ(in_words(1e300), "1.0e+300");
}

}  // namespace
}  // namespace stiction::reference
