// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include "reference/meshes/mesh_quality.h"
#include "reference/meshes/mesher.h"
#include "solver/mesh/mesh.h"

/// A person's own closed triangle surface (OFF, OBJ, PLY, STL) as a tetrahedral body, by CGAL's
/// Mesh_3 [CGAL]. Nothing is repaired in silence: a surface that doesn't bound a volume is refused,
/// with the reason. Only points of equal coordinates are merged, as STL has no other way to say
/// that two triangles share a vertex. The work is done by a program, mesh_surface
/// (filled_surface.h), so that a crash of it costs no more than its surface.
namespace stiction::reference {

enum class SurfaceFlaw {
  missing_file,
  unknown_format,
  unreadable,
  empty,
  not_finite,
  not_triangles,
  degenerate,    ///< a triangle without area, or lengths that can't be computed with
  not_manifold,  ///< an edge of more than two triangles, or neighbours of opposite orientation
  not_closed,    ///< has a border
  self_intersecting,
  not_bounding,  ///< faces look inwards, or the orientations of nested parts contradict
  not_meshed,    ///< closed, but the mesh asked for doesn't resolve it
  too_large,     ///< the mesh asked for has too many tetrahedra
};
inline constexpr int kSurfaceFlaws = static_cast<int>(SurfaceFlaw::too_large) + 1;

/// Thrown with the file's name and the reason in words.
class SurfaceError : public std::runtime_error {
 public:
  SurfaceError(SurfaceFlaw flaw, const std::string& what) : std::runtime_error(what), flaw_(flaw) {}
  [[nodiscard]] SurfaceFlaw flaw() const { return flaw_; }

 private:
  SurfaceFlaw flaw_;
};

/// What is known of a mesh while it is made.
struct MeshingProgress {
  double seconds = 0.0;     ///< since the mesher was started
  double tetrahedra = 0.0;  ///< about so many there will be; 0: not known yet
};

struct SurfaceOptions {
  /// Circumradius of a tetrahedron at most, m. 0: an eighth of the diagonal of the bounding box.
  double cell_size = 0.0;
  /// Distance of the mesh's surface from the given one at most, m. 0: a twentieth of `cell_size`.
  double facet_distance = 0.0;
  /// Edges whose faces meet at less than 180° minus this are kept as they are, degrees.
  double feature_angle = 40.0;
  unsigned seed = 0;  ///< of CGAL's generator
  double unit = 1.0;  ///< of the file's lengths, m: for lengths in sentences alone
  /// A mesh of more is refused, where that can be told before it is made.
  std::int64_t most_tetrahedra = 200'000;
  /// The mesher is given up after this long, s. A hundred thousand tetrahedra take 5 s.
  double time_limit = 300.0;
  /// Called several times a second while the mesher is at work, if there is one.
  std::function<void(const MeshingProgress&)> progress{};
  /// Called with the folder and the reason when the mesh was made and could not be remembered; may be empty.
  std::function<void(const std::string&)> not_kept{};

  /// Empty if usable, else what is wrong in words.
  [[nodiscard]] std::string check() const;
};

/// Lengths in m.
struct SurfaceReport {
  Eigen::Index given_triangles = 0;
  double given_volume = 0.0;  ///< m³, enclosed by the file's surface
  Eigen::Index vertices = 0;
  Eigen::Index tetrahedra = 0;
  Eigen::Index surface_triangles = 0;
  double volume = 0.0;  ///< m³, of the tetrahedra
  MeshQuality quality;
  double mean_edge = 0.0;  ///< of all edges
};

struct SurfaceBody {
  TetMesh mesh;
  SurfaceReport report;
};

/// Reads, checks and fills. The same file, options and CGAL give the same bits.
/// Throws SurfaceError for the file, std::invalid_argument for the options, MesherError for the
/// mesher.
SurfaceBody body_of_closed_surface(const std::filesystem::path& file,
                                   const SurfaceOptions& options = {});

}  // namespace stiction::reference
