// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/gauntlet/gauntlet_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "reference/meshes/box_mesh.h"
#include "solver/demand.h"

namespace stiction {

namespace {

constexpr double kSame = 1e-9;  // m: points nearer than that are one

void make_positive(TetMesh& mesh) {
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    if (signed_volume(mesh, e) < 0.0) std::swap(mesh.tetrahedra(2, e), mesh.tetrahedra(3, e));
  }
}

// Of the surface, those in the plane z = `plane` and in a rectangle (x, y).
std::vector<Eigen::Vector3i> base_triangles(const TetMesh& mesh, double plane, const Vec2& low,
                                            const Vec2& high) {
  std::vector<Eigen::Vector3i> found;
  const Eigen::Matrix3Xi surface = surface_triangles(mesh.tetrahedra);
  for (const auto& corners : surface.colwise()) {
    const bool within = std::all_of(corners.begin(), corners.end(), [&](int v) {
      const Vec3 at = mesh.vertices.col(v);
      return std::abs(at.z() - plane) < kSame && at.x() > low.x() - kSame &&
             at.y() > low.y() - kSame && at.x() < high.x() + kSame && at.y() < high.y() + kSame;
    });
    if (within) found.emplace_back(corners);
  }
  demand(!found.empty(), "a base to stand on");
  return found;
}

int add_vertex(TetMesh& mesh, const Vec3& at) {
  const Eigen::Index number = mesh.vertices.cols();
  mesh.vertices.conservativeResize(Eigen::NoChange, number + 1);
  mesh.vertices.col(number) = at;
  return static_cast<int>(number);
}

void add_tetrahedra(TetMesh& mesh, const std::vector<Eigen::Vector4i>& added) {
  Eigen::Index column = mesh.tetrahedra.cols();
  mesh.tetrahedra.conservativeResize(Eigen::NoChange,
                                     column + static_cast<Eigen::Index>(added.size()));
  for (const Eigen::Vector4i& corners : added) mesh.tetrahedra.col(column++) = corners;
  make_positive(mesh);
}

// A block with the face z = 0 on top, or, with `side` < 0, at the bottom, and all else beyond it.
TetMesh block_mesh(const Vec3& size, const Eigen::Vector3i& cells, double side) {
  TetMesh mesh = reference::box_mesh(size, cells);
  for (auto at : mesh.vertices.colwise()) {
    at.z() -= (side > 0.0 ? 0.5 : -0.5) * size.z();
    if (std::abs(at.z()) < kSame) at.z() = 0.0;
  }
  return mesh;
}

}  // namespace

TetMesh carved(const TetMesh& mesh, double cell, const std::vector<Eigen::Vector2i>& kept) {
  TetMesh part;
  std::vector<int> renumbered(static_cast<std::size_t>(mesh.vertices.cols()), -1);
  std::vector<Eigen::Vector4i> tetrahedra;
  int vertices = 0;
  for (const auto& corners : mesh.tetrahedra.colwise()) {
    Vec3 centre = Vec3::Zero();
    for (const int v : corners) centre += 0.25 * mesh.vertices.col(v);
    const Eigen::Vector2i at(static_cast<int>(std::floor(centre.x() / cell)),
                             static_cast<int>(std::floor(centre.z() / cell)));
    if (std::find(kept.begin(), kept.end(), at) == kept.end()) continue;
    tetrahedra.emplace_back(corners);
    for (int& v : tetrahedra.back()) {
      int& number = renumbered[static_cast<std::size_t>(v)];
      if (number < 0) number = vertices++;
      v = number;
    }
  }
  part.vertices.resize(3, vertices);
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    const int number = renumbered[static_cast<std::size_t>(v)];
    if (number >= 0) part.vertices.col(number) = mesh.vertices.col(v);
  }
  part.tetrahedra.resize(4, static_cast<Eigen::Index>(tetrahedra.size()));
  for (std::size_t e = 0; e < tetrahedra.size(); ++e) {
    part.tetrahedra.col(static_cast<Eigen::Index>(e)) = tetrahedra[e];
  }
  return part;
}

void add_spike(TetMesh& mesh, double plane, const Vec2& low, const Vec2& high, const Vec3& apex) {
  const int tip = add_vertex(mesh, apex);
  std::vector<Eigen::Vector4i> added;
  for (const Eigen::Vector3i& base : base_triangles(mesh, plane, low, high)) {
    added.emplace_back(base[0], base[1], base[2], tip);
  }
  add_tetrahedra(mesh, added);
}

// Over each square of the base, A and D outside, B and C in the middle, with the diagonal BD, stands
// half a prism with the ridge's ends over B and C: (B, C, D, over C), (A, B, D, over C), (A, B, over
// B, over C). The other half is its mirror image, so that the diagonal from B to over C is shared.
void add_ridge(TetMesh& mesh, double plane, double middle, double half_width, double height) {
  constexpr double kFar = 1e3;  // m
  std::map<long, int> ridge;    // its vertices, by y in nanometres
  const auto over = [&](double y) {
    const auto [entry, fresh] = ridge.try_emplace(std::lround(1e9 * y), 0);
    if (fresh) entry->second = add_vertex(mesh, Vec3(middle, y, plane + height));
    return entry->second;
  };
  std::vector<Eigen::Vector4i> added;
  for (const Eigen::Vector3i& base :
       base_triangles(mesh, plane, {middle - half_width, -kFar}, {middle + half_width, kFar})) {
    std::vector<int> inner, outer;
    for (const int v : base) {
      (std::abs(mesh.vertices(0, v) - middle) < kSame ? inner : outer).push_back(v);
    }
    const auto y = [&](int v) { return mesh.vertices(1, v); };
    int far = outer.front();
    if (inner.size() == 1 && std::abs(y(far) - y(inner.front())) < kSame) {
      far = outer.back();
    }
    const int over_far = over(y(far));
    added.emplace_back(base[0], base[1], base[2], over_far);
    if (inner.size() > 1) continue;
    const int near = far == outer.front() ? outer.back() : outer.front();
    const int over_near = over(y(near));
    added.emplace_back(near, inner.front(), over_near, over_far);
  }
  add_tetrahedra(mesh, added);
}

TetMesh spike_bed_mesh(const SpikeBed& bed) {
  const Vec3 size(bed.pads_x * bed.pad, bed.pads_y * bed.pad, bed.block);
  TetMesh mesh = block_mesh(size, {2 * bed.pads_x, 2 * bed.pads_y, 1}, bed.height);
  for (int i = 0; i < bed.pads_x; ++i) {
    for (int j = 0; j < bed.pads_y; ++j) {
      const Vec2 low = bed.pad * Vec2(i, j) - 0.5 * size.head<2>();
      const Vec2 high = low + Vec2::Constant(bed.pad), middle = 0.5 * (low + high);
      add_spike(mesh, 0.0, low, high, Vec3(middle.x(), middle.y(), bed.height));
    }
  }
  return mesh;
}

TetMesh wedge_mesh(const Wedge& wedge) {
  TetMesh mesh =
      block_mesh({wedge.width, wedge.length, wedge.block}, {2, wedge.slices, 1}, wedge.height);
  add_ridge(mesh, 0.0, 0.0, 0.5 * wedge.width, wedge.height);
  return mesh;
}

TetMesh ridged_mesh(const RidgedBlock& block) {
  const int ridges = block.ridges;
  const double half = 0.5 * block.width / (2 * ridges - 1), first = half - 0.5 * block.width;
  TetMesh mesh = block_mesh({block.width, block.length, block.block},
                            {2 * (2 * ridges - 1), block.slices, 1}, block.height);
  for (int k = 0; k < ridges; ++k) add_ridge(mesh, 0.0, first + 4 * k * half, half, block.height);
  return mesh;
}

TetMesh valley_mesh(const Valley& valley) {
  TetMesh mesh =
      block_mesh({valley.width, valley.length, valley.block}, {2, valley.slices, 1}, 1.0);
  for (auto at : mesh.vertices.colwise()) {
    if (at.z() == 0.0 && std::abs(at.x()) > kSame) at.z() = valley.depth;
  }
  return mesh;
}

TetMesh flat_mesh(double edge, double thickness, int cells, bool irregular) {
  TetMesh mesh = reference::box_mesh({edge, edge, thickness}, {cells, cells, 1});
  const double most = 0.125 * edge / cells, rim = 0.5 * edge - kSame;
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    auto at = mesh.vertices.col(v);
    const bool upper = at.z() > 0.0;
    if (irregular && upper && std::abs(at.x()) < rim && std::abs(at.y()) < rim) {
      const auto number = static_cast<double>(v);  // of no period that the mesh has
      at.x() += most * std::sin(2.399963 * number);
      at.y() += most * std::sin(4.236068 * number + 1.0);
    }
    at.z() = upper ? 0.0 : -thickness;
  }
  return mesh;
}

TetMesh balancer_mesh(Foot foot) {
  constexpr double kCell = 0.02;  // m
  std::vector<Eigen::Vector2i> cells;
  for (int i = -3; i < 3; ++i) cells.emplace_back(i, 0);
  for (int k = -1; k >= -5; --k) {
    for (const int i : {-3, 2}) cells.emplace_back(i, k);
  }
  for (int k = -3; k >= -5; --k) {
    for (const int i : {-4, 3}) cells.emplace_back(i, k);
  }
  TetMesh block = reference::box_mesh(kCell * Vec3(8.0, 2.0, 6.0), {8, 2, 6});
  for (auto at : block.vertices.colwise()) at.z() = kCell * std::round(at.z() / kCell - 2.0);
  TetMesh mesh = carved(block, kCell, cells);
  if (foot == Foot::kRidge) add_ridge(mesh, 0.0, 0.0, kCell, -kFootHeight);
  if (foot == Foot::kSpike) {
    add_spike(mesh, 0.0, Vec2::Constant(-kCell), Vec2::Constant(kCell), {0.0, 0.0, -kFootHeight});
  }
  if (foot != Foot::kNone) mesh.vertices.row(2).array() += kFootHeight;
  return mesh;
}

std::pair<Vec3, double> centre_and_volume(const TetMesh& mesh) {
  Vec3 moment = Vec3::Zero();
  double volume = 0.0;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    Vec3 centre = Vec3::Zero();
    for (const int v : mesh.tetrahedra.col(e)) centre += 0.25 * mesh.vertices.col(v);
    moment += signed_volume(mesh, e) * centre;
    volume += signed_volume(mesh, e);
  }
  return {moment / volume, volume};
}

ProblemBody gauntlet_body(const std::string& name, TetMesh mesh, const Vec3& place,
                          const Eigen::Quaterniond& turn) {
  const auto [centre, volume] = centre_and_volume(mesh);
  mesh.vertices.colwise() -= centre;
  ProblemBody body;
  body.name = name;
  body.shape = MeshShape{std::move(mesh)};
  body.mass = kGauntletDensity * volume;
  body.elasticity = kGauntletElasticity;
  body.position = place + turn * centre;
  body.rotation = turn;
  return body;
}

ProblemBody held_gauntlet_body(const std::string& name, TetMesh mesh, double held_below,
                               const Vec3& place, const Eigen::Quaterniond& turn) {
  const Vec3 centre = centre_and_volume(mesh).first;
  ProblemBody body = gauntlet_body(name, std::move(mesh), place, turn);
  body.held = HeldPart{Vec3(0.0, 0.0, held_below) - centre, Vec3::UnitZ()};
  return body;
}

Eigen::Quaterniond yawed(double degrees) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Vec3::UnitZ()));
}

}  // namespace stiction
