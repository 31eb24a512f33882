// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/bullet_deformable/soft_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace stiction::bullet_deformable {

namespace {

using Eigen::Vector3d, Eigen::Vector3i;

double volume(const SoftMesh& mesh, const std::array<int, 4>& tetrahedron) {
  const auto at = [&](size_t k) { return mesh.nodes[static_cast<size_t>(tetrahedron[k])]; };
  return (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) / 6.0;
}

// Kuhn's subdivision: a tetrahedron for each order in which a path takes the three axes.
void add_cell(SoftMesh& mesh, const Vector3i& corner, const Vector3i& cells) {
  const auto node = [&](const Vector3i& at) {
    return (at.z() * (cells.y() + 1) + at.y()) * (cells.x() + 1) + at.x();
  };
  std::array<int, 3> order{0, 1, 2};
  do {
    std::array<int, 4> tetrahedron{node(corner)};
    Vector3i at = corner;
    for (size_t k = 0; k < 3; ++k) {
      ++at[order[k]];
      tetrahedron[k + 1] = node(at);
    }
    if (volume(mesh, tetrahedron) < 0.0) std::swap(tetrahedron[2], tetrahedron[3]);
    mesh.tetrahedra.push_back(tetrahedron);
  } while (std::next_permutation(order.begin(), order.end()));
}

SoftMesh grid(const Vector3d& size, const Vector3i& cells) {
  SoftMesh mesh;
  for (int k = 0; k <= cells.z(); ++k) {
    for (int j = 0; j <= cells.y(); ++j) {
      for (int i = 0; i <= cells.x(); ++i) {
        const Vector3d part = Vector3d(i, j, k).cwiseQuotient(cells.cast<double>());
        mesh.nodes.emplace_back((part - Vector3d::Constant(0.5)).cwiseProduct(size));
      }
    }
  }
  for (int k = 0; k < cells.z(); ++k) {
    for (int j = 0; j < cells.y(); ++j) {
      for (int i = 0; i < cells.x(); ++i) add_cell(mesh, {i, j, k}, cells);
    }
  }
  return mesh;
}

SoftMesh box(const stiction_body& body, int along_longest) {
  const Vector3d size(body.size);
  const Vector3d share = along_longest * size / size.maxCoeff();
  return grid(size, share.array().round().max(1.0).matrix().cast<int>());
}

SoftMesh ball(const stiction_body& body, int cells) {
  SoftMesh mesh = grid(Vector3d::Constant(2.0 * body.radius), Vector3i::Constant(cells));
  for (Vector3d& node : mesh.nodes) {
    const double shell = node.lpNorm<Eigen::Infinity>();
    if (shell > 0.0) node *= shell / node.norm();
  }
  for (auto& tetrahedron : mesh.tetrahedra) {
    if (volume(mesh, tetrahedron) < 0.0) std::swap(tetrahedron[2], tetrahedron[3]);
  }
  return mesh;
}

SoftMesh given(const stiction_body& body) {
  SoftMesh mesh;
  for (size_t k = 0; k < body.vertex_count; ++k) mesh.nodes.emplace_back(body.vertices[k]);
  for (size_t e = 0; e < body.tetrahedron_count; ++e) {
    auto& corners = mesh.tetrahedra.emplace_back();
    std::copy_n(body.tetrahedra[e], 4, corners.begin());
  }
  return mesh;
}

// Faces of one tetrahedron alone.
void find_surface(SoftMesh& mesh) {
  std::map<std::array<int, 3>, std::array<int, 3>> single;
  for (const auto& t : mesh.tetrahedra) {
    const std::array<std::array<int, 3>, 4> faces{
        {{t[0], t[2], t[1]}, {t[0], t[1], t[3]}, {t[1], t[2], t[3]}, {t[0], t[3], t[2]}}};
    for (const auto& face : faces) {
      std::array<int, 3> key = face;
      std::sort(key.begin(), key.end());
      const auto [found, is_new] = single.emplace(key, face);
      if (!is_new) single.erase(found);
    }
  }
  for (const auto& [key, face] : single) mesh.surface.push_back(face);
}

void find_masses(SoftMesh& mesh, double mass) {
  double all = 0.0;
  for (const auto& t : mesh.tetrahedra) all += volume(mesh, t);
  mesh.masses.assign(mesh.nodes.size(), 0.0);
  for (const auto& t : mesh.tetrahedra) {
    const double part = 0.25 * mass * volume(mesh, t) / all;
    for (const int corner : t) mesh.masses[static_cast<size_t>(corner)] += part;
  }
}

// What is lumped need not have its centre of mass where the body has.
void centre(SoftMesh& mesh, double mass) {
  Vector3d sum = Vector3d::Zero();
  for (size_t k = 0; k < mesh.nodes.size(); ++k) sum += mesh.masses[k] / mass * mesh.nodes[k];
  for (Vector3d& node : mesh.nodes) node -= sum;
}

// A box's symmetry, which Kuhn's tetrahedra lack: half as much to a node of a face as within.
void even_masses(SoftMesh& mesh, const stiction_body& body) {
  double all = 0.0;
  for (size_t k = 0; k < mesh.nodes.size(); ++k) {
    mesh.masses[k] = 1.0;
    for (int i = 0; i < 3; ++i) {
      const bool outside = std::abs(mesh.nodes[k][i]) > (0.5 - 1e-9) * body.size[i];
      if (outside) mesh.masses[k] *= 0.5;
    }
    all += mesh.masses[k];
  }
  for (double& mass : mesh.masses) mass *= body.mass / all;
}

}  // namespace

SoftMesh soft_mesh(const stiction_body& body, const Parameters& parameters) {
  SoftMesh mesh;
  switch (body.shape) {
    case STICTION_BOX:
      mesh = box(body, parameters.cells);
      break;
    case STICTION_BALL:
      mesh = ball(body, parameters.ball_cells);
      break;
    case STICTION_MESH:
      mesh = given(body);
      break;
    case STICTION_POINT:
      stiction_lacks("bodies without extension");
  }
  find_surface(mesh);
  find_masses(mesh, body.mass);
  if (body.shape == STICTION_BOX) {
    even_masses(mesh, body);
  } else {
    centre(mesh, body.mass);
  }
  return mesh;
}

}  // namespace stiction::bullet_deformable
