// SPDX-License-Identifier: BSD-3-Clause
#include "solver/mesh/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>

namespace stiction {

namespace {

// Face k of a positively oriented tetrahedron lies opposite its vertex k and looks outwards.
constexpr std::array<std::array<int, 3>, 4> kFaces = {
    {{{1, 2, 3}}, {{0, 3, 2}}, {{0, 1, 3}}, {{0, 2, 1}}}};

// Of a tetrahedron's four, told apart by the vertices in ascending order.
struct Face {
  std::uint64_t first_two;        // of the vertices, the least in the upper half
  std::uint64_t third_and_order;  // order: 4 e + k, of fewer than 2³⁰ tetrahedra

  auto operator<=>(const Face&) const = default;
  std::uint32_t order() const { return static_cast<std::uint32_t>(third_and_order); }
  bool has_vertices_of(const Face& b) const {
    return first_two == b.first_two && third_and_order >> 32 == b.third_and_order >> 32;
  }
};

}  // namespace

Eigen::Matrix3Xi surface_triangles(const Eigen::Matrix4Xi& tetrahedra,
                                   std::vector<Eigen::Index>* owners) {
  const auto corner = [&](Eigen::Index order, std::size_t c) {
    return tetrahedra(kFaces[static_cast<std::size_t>(order % 4)][c], order / 4);
  };
  std::vector<Face> faces;
  faces.reserve(static_cast<std::size_t>(4 * tetrahedra.cols()));
  for (Eigen::Index order = 0; order < 4 * tetrahedra.cols(); ++order) {
    std::array<std::uint64_t, 3> v;
    for (std::size_t c = 0; c < 3; ++c) v[c] = static_cast<std::uint32_t>(corner(order, c));
    std::sort(v.begin(), v.end());
    faces.push_back({v[0] << 32 | v[1], v[2] << 32 | static_cast<std::uint64_t>(order)});
  }
  std::sort(faces.begin(), faces.end());
  std::vector<std::uint32_t> surface;
  for (std::size_t k = 0; k < faces.size();) {
    std::size_t end = k + 1;
    while (end < faces.size() && faces[end].has_vertices_of(faces[k])) ++end;
    if (end == k + 1) surface.push_back(faces[k].order());
    k = end;
  }
  std::sort(surface.begin(), surface.end());
  Eigen::Matrix3Xi triangles(3, static_cast<Eigen::Index>(surface.size()));
  for (std::size_t k = 0; k < surface.size(); ++k) {
    const Eigen::Index order = surface[k];
    triangles.col(static_cast<Eigen::Index>(k)) << corner(order, 0), corner(order, 1),
        corner(order, 2);
  }
  if (owners) {
    owners->clear();
    for (const std::uint32_t order : surface) owners->push_back(order / 4);
  }
  return triangles;
}

double signed_volume(const TetMesh& mesh, Eigen::Index tetrahedron) {
  const auto corners = mesh.tetrahedra.col(tetrahedron);
  const Eigen::Vector3d x0 = mesh.vertices.col(corners[0]);
  const Eigen::Vector3d a = mesh.vertices.col(corners[1]) - x0;
  const Eigen::Vector3d b = mesh.vertices.col(corners[2]) - x0;
  const Eigen::Vector3d c = mesh.vertices.col(corners[3]) - x0;
  return a.cross(b).dot(c) / 6.0;
}

}  // namespace stiction
