// SPDX-License-Identifier: BSD-3-Clause
#include "solver/mesh/numbering.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace stiction {

namespace {

// Spreads the low 21 bits of `x` so that two zero bits follow each.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

// Vertices on a regular grid lie on the borders of no cell but the outermost: a quarter of a cell keeps
// their rounding from choosing.
std::vector<std::uint64_t> morton_codes(const Eigen::Matrix3Xd& vertices) {
  const Eigen::Vector3d low = vertices.rowwise().minCoeff();
  const double extent = (vertices.rowwise().maxCoeff() - low).maxCoeff();
  const double scale = extent > 0.0 ? 2097151.0 / extent : 0.0;
  std::vector<std::uint64_t> codes(static_cast<std::size_t>(vertices.cols()));
  for (Eigen::Index v = 0; v < vertices.cols(); ++v) {
    const Eigen::Vector3d cell = ((vertices.col(v) - low) * scale).array() + 0.25;
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      // Not so where the extent is beyond all numbers, or so small that the scale is.
      const bool is_cell = cell[axis] >= 0.0 && cell[axis] < 2097152.0;
      code |= spread_bits(is_cell ? static_cast<std::uint64_t>(cell[axis]) : 0) << axis;
    }
    codes[static_cast<std::size_t>(v)] = code;
  }
  return codes;
}

// The place of each of so many numbers where they are put in order.
template <class Before>
std::vector<std::int32_t> places_by(std::size_t count, const Before& before) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), before);
  std::vector<std::int32_t> place(count);
  for (std::size_t k = 0; k < count; ++k) place[order[k]] = static_cast<std::int32_t>(k);
  return place;
}

}  // namespace

Numbering spatial_numbering(const TetMesh& mesh, const Eigen::Matrix3d& axes) {
  const auto count = static_cast<std::size_t>(mesh.vertices.cols());
  std::vector<bool> inner(count, false);
  for (const int v : mesh.tetrahedra.reshaped()) inner[static_cast<std::size_t>(v)] = true;
  const Eigen::Matrix3Xi triangles = surface_triangles(mesh.tetrahedra);
  for (const int v : triangles.reshaped()) inner[static_cast<std::size_t>(v)] = false;

  const std::vector<std::uint64_t> codes = morton_codes(axes.transpose() * mesh.vertices);
  Numbering numbering;
  numbering.place = places_by(count, [&](std::size_t a, std::size_t b) {
    return inner[a] != inner[b] ? !inner[a] : codes[a] < codes[b];
  });
  numbering.surface_count = static_cast<int>(std::count(inner.begin(), inner.end(), false));
  return numbering;
}

std::vector<std::int32_t> places_along_curve(const Eigen::Matrix3Xd& points) {
  const std::vector<std::uint64_t> codes = morton_codes(points);
  return places_by(codes.size(), [&](std::size_t a, std::size_t b) { return codes[a] < codes[b]; });
}

}  // namespace stiction
