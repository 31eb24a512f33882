// SPDX-License-Identifier: BSD-3-Clause
#include "solver/mesh/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace stiction {

namespace {

// Face k of a positively oriented tetrahedron lies opposite its vertex k and looks outwards.
constexpr std::array<std::array<int, 3>, 4> kFaces = {
    {{{1, 2, 3}}, {{0, 3, 2}}, {{0, 1, 3}}, {{0, 2, 1}}}};

struct Face {
  std::array<int, 3> sorted;
  std::array<int, 3> oriented;
  Eigen::Index order;
};

}  // namespace

Eigen::Matrix3Xi surface_triangles(const Eigen::Matrix4Xi& tetrahedra,
                                   std::vector<Eigen::Index>* owners) {
  std::vector<Face> faces;
  faces.reserve(static_cast<std::size_t>(4 * tetrahedra.cols()));
  for (Eigen::Index e = 0; e < tetrahedra.cols(); ++e) {
    for (std::size_t k = 0; k < 4; ++k) {
      Face face{{}, {}, 4 * e + static_cast<Eigen::Index>(k)};
      for (std::size_t c = 0; c < 3; ++c) face.oriented[c] = tetrahedra(kFaces[k][c], e);
      face.sorted = face.oriented;
      std::sort(face.sorted.begin(), face.sorted.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.order < b.order;
  });
  std::vector<Face> surface;
  for (std::size_t k = 0; k < faces.size();) {
    std::size_t end = k + 1;
    while (end < faces.size() && faces[end].sorted == faces[k].sorted) ++end;
    if (end == k + 1) surface.push_back(faces[k]);
    k = end;
  }
  std::sort(surface.begin(), surface.end(),
            [](const Face& a, const Face& b) { return a.order < b.order; });
  Eigen::Matrix3Xi triangles(3, static_cast<Eigen::Index>(surface.size()));
  for (std::size_t k = 0; k < surface.size(); ++k) {
    const std::array<int, 3>& t = surface[k].oriented;
    triangles.col(static_cast<Eigen::Index>(k)) << t[0], t[1], t[2];
  }
  if (owners) {
    owners->clear();
    for (const Face& face : surface) owners->push_back(face.order / 4);
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
