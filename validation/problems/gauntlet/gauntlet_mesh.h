// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "validation/engine/problem.h"

namespace stiction {

/// The material of the gauntlet, of which every body is made.
inline constexpr double kGauntletDensity = 1000.0;  ///< kg/m³
inline constexpr Elasticity kGauntletElasticity{
    .youngs_modulus = 1e6, .poisson_ratio = 0.4, .damping_time = 1e-4};

using Vec2 = Eigen::Vector2d;

/// Of a mesh of cells of equal size, those tetrahedra that lie in the cells (i, k) that are kept,
/// [i, i + 1] × [k, k + 1] in terms of `cell` (m) in x and z, whatever their y.
TetMesh carved(const TetMesh& mesh, double cell, const std::vector<Eigen::Vector2i>& kept);

/// Joins an apex to those triangles of the surface that lie in the plane z = `plane` and in
/// the rectangle from `low` to `high` (x, y): a pyramid with that base. m.
void add_spike(TetMesh& mesh, double plane, const Vec2& low, const Vec2& high, const Vec3& apex);

/// Puts a ridge along y on the strip of surface z = `plane`, |x − middle| ≤ half_width, which is two
/// cells wide: a prism of triangular section, its edge at z = plane + height. m.
void add_ridge(TetMesh& mesh, double plane, double middle, double half_width, double height);

/// A block with pads × pads square spikes on its upper face z = 0, edge to edge; `height` < 0:
/// below its lower face z = 0.
struct SpikeBed {
  int pads_x = 1, pads_y = 1;
  double pad = 0.03;     ///< edge of a spike's base, m
  double height = 0.02;  ///< m
  double block = 0.02;   ///< thickness of the block, m
};
TetMesh spike_bed_mesh(const SpikeBed& bed);

/// A prism of triangular section with its ridge along y at z = `height`, on a block whose upper
/// face is z = 0; `height` < 0: everything below.
struct Wedge {
  double width = 0.06;   ///< of the base, m
  double height = 0.02;  ///< m
  double block = 0.02;   ///< thickness of the block, m
  double length = 0.06;  ///< along y, m
  int slices = 2;
};
TetMesh wedge_mesh(const Wedge& wedge);

/// A block with ridges along y and gaps as wide between them; `height` < 0: everything below.
struct RidgedBlock {
  int ridges = 2;
  double width = 0.108;   ///< m
  double height = 0.015;  ///< m
  double block = 0.02;    ///< m
  double length = 0.08;   ///< m
  int slices = 4;
};
TetMesh ridged_mesh(const RidgedBlock& block);

/// A block with a groove along y: its bottom at z = 0, its rims at z = `depth`.
struct Valley {
  double width = 0.06;  ///< m
  double depth = 0.0173;
  double block = 0.02;   ///< below the groove, m
  double length = 0.06;  ///< along y, m
  int slices = 2;
};
TetMesh valley_mesh(const Valley& valley);

/// A plate whose upper face z = 0 is made of many triangles: `cells` × `cells` cells with diagonals
/// in turn; `irregular` moves each inner vertex within that plane by up to an eighth of a cell.
TetMesh flat_mesh(double edge, double thickness, int cells, bool irregular);

/// What a body that balances stands on.
enum class Foot {
  kNone,   ///< the lower face of its bridge
  kSpike,  ///< one vertex
  kRidge   ///< an edge along y
};
inline constexpr double kFootHeight = 0.02;  ///< m; its sides have 45° to the vertical

/// A bridge with two legs, heavy at their ends, so that the centre of mass lies below the tip of its
/// foot, which is the origin. Half-way between the legs, which are 80 mm apart.
TetMesh balancer_mesh(Foot foot);

/// The centre of a mesh's volume, m, and the volume, m³.
std::pair<Vec3, double> centre_and_volume(const TetMesh& mesh);

/// A body of the gauntlet's material whose mesh, as it is given, is turned about its origin and then
/// moved by `place` (m). `held_below`: what of the mesh is held, by its z, m.
ProblemBody gauntlet_body(const std::string& name, TetMesh mesh, const Vec3& place,
                          const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity());
ProblemBody held_gauntlet_body(const std::string& name, TetMesh mesh, double held_below,
                               const Vec3& place,
                               const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity());

/// About the vertical, degrees.
Eigen::Quaterniond yawed(double degrees);

}  // namespace stiction
