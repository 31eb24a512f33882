// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/filled_surface.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace stiction::reference {
namespace {

FilledSurface tetrahedron() {
  FilledSurface filled;
  filled.given_triangles = 4;
  filled.given_volume = 1.0 / 3.0;
  filled.mesh.vertices.resize(3, 4);
  filled.mesh.vertices << 0.1, -0.0, 1e300, std::nextafter(1.0, 2.0),  //
      std::numeric_limits<double>::denorm_min(), 1.0 / 3.0, -1e-300, 2.0, 0.0, 0.0, 0.0, 1.0;
  filled.mesh.tetrahedra.resize(4, 1);
  filled.mesh.tetrahedra << 3, 0, 2, 1;
  return filled;
}

TEST(FilledSurface, ReadsBackTheSameBits) {
  const FilledSurface filled = tetrahedron();
  const FilledSurface again = filled_surface_from(to_text(filled));
  EXPECT_EQ(again.given_triangles, 4);
  EXPECT_EQ(again.given_volume, filled.given_volume);
  EXPECT_TRUE(again.mesh.tetrahedra == filled.mesh.tetrahedra);
  ASSERT_EQ(again.mesh.vertices.cols(), 4);
  for (Eigen::Index k = 0; k < 12; ++k) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(again.mesh.vertices.reshaped()[k]),
              std::bit_cast<std::uint64_t>(filled.mesh.vertices.reshaped()[k]))
        << k;
  }
}

TEST(FilledSurface, MayHaveNoTetrahedra) {
  EXPECT_EQ(filled_surface_from(to_text({12, 1.0, {}})).mesh.tetrahedra.cols(), 0);
}

TEST(FilledSurface, IsRefusedUnlessItIsWhole) {
  const std::string text = to_text(tetrahedron());
  for (std::size_t length = 0; length + 1 < text.size(); ++length) {
    EXPECT_THROW(filled_surface_from(text.substr(0, length)), std::invalid_argument)
        << text.substr(0, length);
  }
}

TEST(FilledSurface, IsRefusedWithTheReason) {
  struct Fault {
    const char *from, *to, *reason;
  };
  for (const Fault& fault :
       {Fault{"surface 1", "surface 2", "'1' is missing"}, Fault{"1e+300", "nan", "not finite"},
        Fault{"1e+300", "1e+30x", "'1e+30x' is no number"},
        Fault{"3 0 2 1", "3 0 2 4", "no such vertex"}, Fault{"3 0 2 1", "3 0 2 -1", "no such"},
        Fault{"vertices 4", "vertices 4000000000000", "shorter than it says"},
        Fault{"vertices 4", "vertices -4", "shorter than it says"}}) {
    std::string text = to_text(tetrahedron());
    ASSERT_NE(text.find(fault.from), std::string::npos) << fault.from;
    text.replace(text.find(fault.from), std::string(fault.from).size(), fault.to);
    try {
      filled_surface_from(text);
      ADD_FAILURE() << fault.to;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(fault.reason), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace stiction::reference
