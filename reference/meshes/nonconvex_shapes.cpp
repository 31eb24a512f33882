// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/nonconvex_shapes.h"

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace stiction::reference {

namespace {

// Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2 & 1). The regular tetrahedron of an even
// cell takes the corners with an even number of ones, that of an odd cell the others.
constexpr std::array<std::array<int, 4>, 5> kEven = {
    {{{0, 3, 5, 6}}, {{1, 0, 3, 5}}, {{2, 3, 0, 6}}, {{4, 5, 6, 0}}, {{7, 6, 5, 3}}}};
constexpr std::array<std::array<int, 4>, 5> kOdd = {
    {{{1, 2, 4, 7}}, {{0, 1, 2, 4}}, {{3, 1, 7, 2}}, {{5, 1, 4, 7}}, {{6, 2, 7, 4}}}};

}  // namespace

std::string name(Shape shape) {
  switch (shape) {
    case Shape::l:
      return "l";
    case Shape::t:
      return "t";
    case Shape::u:
      return "u";
    case Shape::plus:
      return "plus";
    case Shape::jack:
      return "jack";
  }
  throw std::invalid_argument("shape: there is no such shape");
}

std::vector<Eigen::Vector3i> cubes(Shape shape) {
  switch (shape) {
    case Shape::l:
      return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    case Shape::t:
      return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
    case Shape::u:
      return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}};
    case Shape::plus:
      return {{1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {1, 0, 0}, {1, 2, 0}};
    case Shape::jack:
      return {{1, 1, 1}, {0, 1, 1}, {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2}};
  }
  throw std::invalid_argument("shape: there is no such shape");
}

double shape_volume(Shape shape, double edge) {
  return static_cast<double>(cubes(shape).size()) * edge * edge * edge;
}

TetMesh shape_mesh(Shape shape, double edge, int cells) {
  if (!(edge > 0.0) || !std::isfinite(edge)) {
    throw std::invalid_argument("shape: the edge must be finite and positive");
  }
  if (cells < 1 || cells > 64) throw std::invalid_argument("shape: cells must lie in [1, 64]");

  const std::vector<Eigen::Vector3i> places = cubes(shape);
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3i& place : places) {
    center += place.cast<double>() + Eigen::Vector3d::Constant(0.5);
  }
  center /= static_cast<double>(places.size());

  std::map<std::array<int, 3>, int> index;
  std::vector<Eigen::Vector3d> points;
  const auto vertex = [&](const Eigen::Vector3i& p) {
    const auto [entry, fresh] =
        index.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(points.size()));
    if (fresh) points.emplace_back(edge * (p.cast<double>() / cells - center));
    return entry->second;
  };

  TetMesh mesh;
  mesh.tetrahedra.resize(4, static_cast<Eigen::Index>(places.size()) * 5 * cells * cells * cells);
  Eigen::Index column = 0;
  for (const Eigen::Vector3i& place : places) {
    for (int k = 0; k < cells; ++k) {
      for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
          const Eigen::Vector3i cell = cells * place + Eigen::Vector3i(i, j, k);
          for (const std::array<int, 4>& corners : cell.sum() % 2 == 0 ? kEven : kOdd) {
            for (Eigen::Index c = 0; c < 4; ++c) {
              const int corner = corners[static_cast<std::size_t>(c)];
              mesh.tetrahedra(c, column) =
                  vertex(cell + Eigen::Vector3i(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1));
            }
            ++column;
          }
        }
      }
    }
  }
  mesh.vertices.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t v = 0; v < points.size(); ++v) {
    mesh.vertices.col(static_cast<Eigen::Index>(v)) = points[v];
  }
  for (Eigen::Index e = 0; e < column; ++e) {
    if (signed_volume(mesh, e) < 0.0) std::swap(mesh.tetrahedra(2, e), mesh.tetrahedra(3, e));
  }
  return mesh;
}

}  // namespace stiction::reference
