// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_surface/fill_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/make_mesh_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "reference/meshes/mesh_size.h"
#include "reference/meshes/mesh_surface/declared_counts.h"
#include "reference/meshes/mesh_surface/reading_guard.h"

namespace stiction::reference {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Mesh_polyhedron_3<Kernel>::type;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index,
                                                        Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
using Eigen::Index;
using Eigen::Vector3d;

constexpr std::uint64_t kLargestFile = 500'000'000;  // bytes

/// Slender bodies have 2 tetrahedra a vertex, others up to 6.
constexpr std::size_t kFewestAVertex = 2;

struct Soup {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
};

/// Throws `flaw` with the file's name unless it holds.
struct Demand {
  std::string name;

  void operator()(bool holds, SurfaceFlaw flaw, const std::string& what) const {
    if (!holds) throw SurfaceError(flaw, name + ": " + what);
  }
};

Soup read(const std::filesystem::path& file, const Demand& demand) {
  demand(std::filesystem::is_regular_file(file), SurfaceFlaw::missing_file,
         "there is no such file");
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::set<std::string> known = {".off", ".obj", ".ply", ".stl"};
  demand(known.contains(extension), SurfaceFlaw::unknown_format,
         "the name must end with .off, .obj, .ply or .stl");
  const std::string format = extension.substr(1);
  const std::uint64_t bytes = std::filesystem::file_size(file);
  demand(bytes <= kLargestFile, SurfaceFlaw::unreadable,
         "it has " + in_words(1e-6 * static_cast<double>(bytes)) + " MB; at most " +
             in_words(1e-6 * static_cast<double>(kLargestFile)) + " are read");
  std::ifstream head(file, std::ios::binary);
  const std::string claim = claims_too_much(head, format, bytes);
  demand(claim.empty(), SurfaceFlaw::unreadable, claim);
  const std::string refusal = "it can't be read as " + format;
  Soup soup;
  bool good = false;
  try {
    const ReadingGuard guard(kFirstFlaw + static_cast<int>(SurfaceFlaw::unreadable),
                             demand.name + ": " + refusal, bytes);
    good = CGAL::IO::read_polygon_soup(file.string(), soup.points, soup.faces,
                                       parameters::verbose(false));
  } catch (const std::exception&) {
    good = false;
  }
  demand(good, SurfaceFlaw::unreadable, refusal);
  return soup;
}

Surface check(Soup soup, const Demand& demand) {
  demand(!soup.points.empty() && !soup.faces.empty(), SurfaceFlaw::empty, "it has no triangles");
  for (const Kernel::Point_3& p : soup.points) {
    demand(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()),
           SurfaceFlaw::not_finite, "a coordinate is not finite");
  }
  for (const std::vector<std::size_t>& face : soup.faces) {
    demand(face.size() == 3, SurfaceFlaw::not_triangles,
           "a face has " + std::to_string(face.size()) + " corners; only triangles can be read");
    for (const std::size_t corner : face) {
      demand(corner < soup.points.size(), SurfaceFlaw::unreadable, "a face names no such vertex");
    }
  }
  pmp::merge_duplicate_points_in_polygon_soup(soup.points, soup.faces);
  for (const std::vector<std::size_t>& f : soup.faces) {
    demand(!CGAL::collinear(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]),
           SurfaceFlaw::degenerate, "a triangle has no area");
  }
  // How often each directed edge occurs tells a border from a fan from a wrong orientation.
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const std::vector<std::size_t>& f : soup.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{f[k], f[(k + 1) % 3]}];
  }
  bool closed = true;
  for (const auto& [edge, times] : edges) {
    demand(
        times == 1, SurfaceFlaw::not_manifold,
        "an edge belongs to more than two triangles, or two neighbours are oriented differently");
    closed = closed && edges.contains({edge.second, edge.first});
  }
  demand(closed, SurfaceFlaw::not_closed, "it is not closed: some edges have one triangle only");
  demand(pmp::is_polygon_soup_a_polygon_mesh(soup.faces), SurfaceFlaw::not_manifold,
         "two parts touch at a vertex only");
  pmp::remove_isolated_points_in_polygon_soup(soup.points, soup.faces);
  Surface surface;
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.faces, surface);
  demand(!pmp::does_self_intersect(surface), SurfaceFlaw::self_intersecting,
         "it intersects itself");
  demand(pmp::does_bound_a_volume(surface) && CGAL::to_double(pmp::volume(surface)) > 0.0,
         SurfaceFlaw::not_bounding,
         "it doesn't bound a volume: faces look inwards, or nested parts contradict each other");
  return surface;
}

double diagonal(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (auto p = surface.points_begin(); p != surface.points_end(); ++p) {
    box.extend(Vector3d(p->x(), p->y(), p->z()));
  }
  return box.diagonal().norm();
}

/// Throws before it takes minutes: of so thin or fine a body, or with so small a cell, the mesh would
/// have too many tetrahedra.
void demand_size(const MeshSize& size, const SurfaceOptions& options, const Demand& demand) {
  const double expected = size.tetrahedra();
  const auto most = static_cast<double>(options.most_tetrahedra);
  demand(expected <= most, SurfaceFlaw::too_large,
         "it would take about " + in_words(expected) + " tetrahedra, more than the " +
             in_words(most) + " of most_tetrahedra: " + size.advice(most, options.unit));
}

/// Cells of the complex, in the triangulation's order (time stamps, so the same every time).
TetMesh mesh_of(const Complex& complex) {
  TetMesh mesh;
  std::map<Complex::Vertex_handle, int> index;
  std::vector<Vector3d> points;
  mesh.tetrahedra.resize(4, static_cast<Index>(complex.number_of_cells_in_complex()));
  Index column = 0;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end();
       ++cell) {
    for (int k = 0; k < 4; ++k) {
      const auto vertex = cell->vertex(k);
      const auto [entry, fresh] = index.try_emplace(vertex, static_cast<int>(points.size()));
      if (fresh) {
        const auto& p = vertex->point();
        points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      }
      mesh.tetrahedra(k, column) = entry->second;
    }
    ++column;
  }
  mesh.vertices.resize(3, static_cast<Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    mesh.vertices.col(static_cast<Index>(k)) = points[k];
  }
  return mesh;
}

}  // namespace

FilledSurface fill_surface(const std::filesystem::path& file, const SurfaceOptions& options) {
  const Demand demand{file.string()};
  const Surface surface = check(read(file, demand), demand);

  FilledSurface filled;
  filled.given_triangles = static_cast<Index>(surface.size_of_facets());
  filled.given_volume = CGAL::to_double(pmp::volume(surface));
  const double cell = options.cell_size > 0.0 ? options.cell_size : diagonal(surface) / 8.0;
  const MeshSize size{filled.given_volume, CGAL::to_double(pmp::area(surface)), cell};
  demand_size(size, options, demand);
  std::cerr << kExpected << ' ' << size.tetrahedra() << ' ' << cell << std::endl;
  const double distance = options.facet_distance > 0.0 ? options.facet_distance : cell / 20.0;

  CGAL::get_default_random() = CGAL::Random(options.seed);
  Domain domain(surface, &CGAL::get_default_random());
  domain.detect_features(options.feature_angle);
  // Facets and edges about as long as the cells' edges; Mesh_3 bounds circumradii.
  const Criteria criteria(parameters::edge_size = cell, parameters::facet_angle = 25.0,
                          parameters::facet_size = cell, parameters::facet_distance = distance,
                          parameters::cell_radius_edge_ratio = 2.0, parameters::cell_size = cell);
  // Slivers below 10° are moved apart; asking for 15° takes a hundred times as long. No time
  // limits of CGAL's: they would make the result depend on the machine.
  CGAL::Mesh_error_code stopped = CGAL::CGAL_MESH_3_NO_ERROR;
  Complex complex = CGAL::make_mesh_3<Complex>(
      domain, criteria, parameters::manifold(), parameters::no_exude(), parameters::no_perturb(),
      parameters::mesh_3_options(
          parameters::maximal_number_of_vertices =
              static_cast<std::size_t>(options.most_tetrahedra) / kFewestAVertex,
          parameters::pointer_to_error_code = &stopped));
  demand(
      stopped == CGAL::CGAL_MESH_3_NO_ERROR &&
          complex.number_of_cells_in_complex() <= static_cast<std::size_t>(options.most_tetrahedra),
      SurfaceFlaw::too_large,
      "it takes more than the " + in_words(static_cast<double>(options.most_tetrahedra)) +
          " tetrahedra of most_tetrahedra, as it has thin or fine parts: take these away, or "
          "raise most_tetrahedra");
  CGAL::perturb_mesh_3(complex, domain, parameters::sliver_bound = 10.0);

  filled.mesh = mesh_of(complex);
  return filled;
}

}  // namespace stiction::reference
