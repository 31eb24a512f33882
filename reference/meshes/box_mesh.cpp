// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/box_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/meshes/faces.h"

namespace stiction::reference {

namespace {

using Rational = CGAL::Exact_rational;
using ExactKernel = CGAL::Simple_cartesian<Rational>;
using PredicateKernel = CGAL::Exact_predicates_inexact_constructions_kernel;  // predicates: exact

// GMP's conversion truncates in some builds: the neighbours are tried as well, exactly. GMP ends the
// program where it is given an infinite number.
double nearest_double(const Rational& value) {
  constexpr double kGreatest = std::numeric_limits<double>::max();
  if (CGAL::abs(value) > Rational(kGreatest)) {
    throw std::invalid_argument("The volume is greater than the greatest number, 1.8e308.");
  }
  double nearest = CGAL::to_double(value);
  for (const double other :
       {std::nextafter(nearest, -kGreatest), std::nextafter(nearest, kGreatest)}) {
    if (CGAL::abs(Rational(value - Rational(other))) <
        CGAL::abs(Rational(value - Rational(nearest)))) {
      nearest = other;
    }
  }
  return nearest;
}

ExactVolume exact_volume(const Rational& volume) {
  std::ostringstream fraction;
  fraction << volume;
  return {fraction.str(), nearest_double(volume)};
}

void check_mesh(const TetMesh& mesh) {
  if (mesh.tetrahedra.cols() == 0) {
    throw std::invalid_argument("The mesh has no tetrahedron.");
  }
  if (!mesh.vertices.allFinite()) {
    throw std::invalid_argument("The mesh has a vertex coordinate that is not finite.");
  }
  if (mesh.tetrahedra.minCoeff() < 0 || mesh.tetrahedra.maxCoeff() >= mesh.vertices.cols()) {
    throw std::invalid_argument("The mesh has a tetrahedron with a vertex index out of range.");
  }
}

// Σ_e det[x1 − x0, x2 − x0, x3 − x0] / 6, and how many of the determinants are not positive.
void certify_volume(const TetMesh& mesh, MeshCertificate& certificate) {
  std::vector<ExactKernel::Point_3> exact;
  std::vector<PredicateKernel::Point_3> points;
  for (const auto& x : mesh.vertices.colwise()) {
    exact.emplace_back(Rational(x[0]), Rational(x[1]), Rational(x[2]));
    points.emplace_back(x[0], x[1], x[2]);
  }
  Rational volume(0);
  for (const auto& corners : mesh.tetrahedra.colwise()) {
    std::array<std::size_t, 4> v{};
    std::copy(corners.begin(), corners.end(), v.begin());
    volume += CGAL::volume(exact[v[0]], exact[v[1]], exact[v[2]], exact[v[3]]);
    if (CGAL::orientation(points[v[0]], points[v[1]], points[v[2]], points[v[3]]) !=
        CGAL::POSITIVE) {
      ++certificate.non_positive_tetrahedra;
    }
  }
  certificate.volume = exact_volume(volume);
}

// Uses of a simplex in its two orientations.
struct Uses {
  int even = 0;
  int odd = 0;
};

// Independent of surface_triangles: counts each face with its orientation, then each boundary edge.
void certify_topology(const TetMesh& mesh, MeshCertificate& certificate) {
  std::map<std::array<int, 3>, Uses> faces;
  std::vector<bool> used(static_cast<std::size_t>(mesh.vertices.cols()), false);
  for (const auto& corners : mesh.tetrahedra.colwise()) {
    for (const int vertex : corners) used[static_cast<std::size_t>(vertex)] = true;
    for (const auto& face : kFaces) {
      std::array<int, 3> f = {corners[face[0]], corners[face[1]], corners[face[2]]};
      bool odd = false;
      for (const auto& [a, b] : {std::pair{0u, 1u}, {1u, 2u}, {0u, 1u}}) {
        if (f[a] <= f[b]) continue;
        std::swap(f[a], f[b]);
        odd = !odd;
      }
      ++(odd ? faces[f].odd : faces[f].even);
    }
  }
  certificate.unused_vertices = std::count(used.begin(), used.end(), false);

  std::map<std::array<int, 2>, Uses> edges;
  std::vector<bool> on_boundary(used.size(), false);
  for (const auto& [f, uses] : faces) {
    if (uses.even > 1 || uses.odd > 1) ++certificate.non_manifold_faces;
    if (uses.even + uses.odd != 1) continue;
    ++certificate.boundary_triangles;
    // The sorted triangle runs f0 → f1 → f2: against the order of the vertices in its last edge
    // only.
    const bool reversed = uses.odd == 1;
    for (const auto& [a, b, backwards] :
         {std::tuple{0u, 1u, false}, {1u, 2u, false}, {0u, 2u, true}}) {
      Uses& edge = edges[{f[a], f[b]}];
      ++(backwards != reversed ? edge.odd : edge.even);
    }
    for (const int vertex : f) on_boundary[static_cast<std::size_t>(vertex)] = true;
  }
  certificate.boundary_closed = certificate.boundary_triangles > 0 &&
                                std::all_of(edges.begin(), edges.end(), [](const auto& edge) {
                                  return edge.second.even == 1 && edge.second.odd == 1;
                                });
  certificate.boundary_euler_characteristic =
      std::count(on_boundary.begin(), on_boundary.end(), true) -
      static_cast<Eigen::Index>(edges.size()) + certificate.boundary_triangles;
}

}  // namespace

// Bit d of a corner's number says whether it is the upper one along axis d. The inner tetrahedron
// of each cell joins the four corners with an even sum of grid indices; each odd corner forms one
// more with its three neighbours. Parity is that of the whole grid, hence one diagonal for each
// face.
TetMesh box_mesh(const Eigen::Vector3d& size, const Eigen::Vector3i& cells) {
  if (!size.allFinite() || size.minCoeff() <= 0.0) {
    throw std::invalid_argument("Each edge length of the box must be finite and positive.");
  }
  if (cells.minCoeff() < 1) {
    throw std::invalid_argument("The box needs at least one cell along each axis.");
  }
  const Eigen::Vector3d counts = cells.cast<double>() + Eigen::Vector3d::Ones();
  if (5.0 * counts.prod() > static_cast<double>(std::numeric_limits<int>::max())) {
    throw std::invalid_argument("The box has more cells than a mesh can number.");
  }
  const Eigen::Vector3i nodes = cells + Eigen::Vector3i::Ones();
  TetMesh mesh{Eigen::Matrix3Xd(3, nodes.prod()), Eigen::Matrix4Xi(4, 5 * cells.prod())};
  const auto number = [&](const Eigen::Vector3i& node) {
    return node[0] + nodes[0] * (node[1] + nodes[1] * node[2]);
  };
  Eigen::Index next = 0;
  const auto add = [&](int a, int b, int c, int d) {
    mesh.tetrahedra.col(next++) = Eigen::Vector4i(a, b, c, d);
  };
  for (int k = 0; k < nodes[2]; ++k) {
    for (int j = 0; j < nodes[1]; ++j) {
      for (int i = 0; i < nodes[0]; ++i) {
        const Eigen::Vector3i node(i, j, k);
        // (2i − n)/n is exactly ∓1 at the ends, and only it is rounded before the product.
        mesh.vertices.col(number(node)) =
            (0.5 * size)
                .cwiseProduct(
                    (2 * node - cells).cast<double>().cwiseQuotient(cells.cast<double>()));
        if ((node.array() == cells.array()).any()) continue;

        std::array<int, 8> corner{};
        for (int bits = 0; bits < 8; ++bits) {
          corner[static_cast<std::size_t>(bits)] =
              number(node + Eigen::Vector3i(bits & 1, (bits >> 1) & 1, bits >> 2));
        }
        const bool mirrored = (i + j + k) % 2 != 0;
        if (mirrored) {
          add(corner[1], corner[2], corner[4], corner[7]);
        } else {
          add(corner[0], corner[5], corner[3], corner[6]);
        }
        for (unsigned bits = 0; bits < 8; ++bits) {
          const bool odd_bits = ((bits ^ (bits >> 1) ^ (bits >> 2)) & 1u) != 0;
          if (odd_bits == mirrored) continue;  // an even corner of the grid
          // An upper coordinate mirrors the corner once; an odd number of them swaps two vertices.
          const int y = corner[bits ^ (odd_bits ? 4u : 2u)];
          const int z = corner[bits ^ (odd_bits ? 2u : 4u)];
          add(corner[bits], corner[bits ^ 1u], y, z);
        }
      }
    }
  }
  return mesh;
}

Eigen::Vector3i box_cells(const Eigen::Vector3d& size, int along_longest) {
  const double cell = size.maxCoeff() / along_longest;
  return (size / cell).array().round().cast<int>().max(1);
}

// Π_d (upper_d − lower_d)
ExactVolume exact_box_volume(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  if (!lower.allFinite() || !upper.allFinite() || (lower.array() > upper.array()).any()) {
    throw std::invalid_argument("The corners of a box must be finite, the lower one below.");
  }
  Rational volume(1);
  for (Eigen::Index d = 0; d < 3; ++d) volume *= Rational(upper[d]) - Rational(lower[d]);
  return exact_volume(volume);
}

MeshCertificate certify(const TetMesh& mesh) {
  check_mesh(mesh);
  MeshCertificate certificate;
  certify_volume(mesh, certificate);
  certify_topology(mesh, certificate);
  certificate.quality = mesh_quality(mesh);
  return certificate;
}

}  // namespace stiction::reference
