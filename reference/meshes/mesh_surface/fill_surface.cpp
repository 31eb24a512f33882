// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_surface/fill_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/exceptions.h>
#include <CGAL/make_mesh_3.h>

#include <Eigen/Geometry>
#include <iostream>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "reference/meshes/mesh_size.h"
#include "reference/meshes/mesh_surface/library_guard.h"
#include "reference/meshes/mesh_surface/surface_soup.h"

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

/// Slender bodies have 2 tetrahedra a vertex, others up to 6.
constexpr std::size_t kFewestAVertex = 2;

/// Throws `flaw` with the file's name unless it holds.
struct Demand {
  std::string name;

  void operator()(bool holds, SurfaceFlaw flaw, const std::string& what) const {
    if (!holds) throw SurfaceError(flaw, name + ": " + what);
  }
};

std::string plain(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

SurfaceSoup read(const std::filesystem::path& file, double seconds, const Demand& demand) {
  const std::string refusal = "it can't be read as " + surface_format(file);
  SurfaceSoup soup;
  bool good = false;
  try {
    const LibraryGuard guard({.code = kFirstFlaw + static_cast<int>(SurfaceFlaw::unreadable),
                              .fallen = demand.name + ": " + refusal,
                              .late = demand.name + ": reading it took longer than " +
                                      plain(seconds) +
                                      " s: give a surface of fewer triangles, or as binary STL",
                              .seconds = seconds,
                              .bytes = std::filesystem::file_size(file)});
    good = read_surface_soup(file, soup);
  } catch (const std::exception&) {
    good = false;
  }
  demand(good, SurfaceFlaw::unreadable, refusal);
  return soup;
}

Surface surface_of(const SurfaceSoup& soup) {
  std::vector<Kernel::Point_3> points;
  points.reserve(soup.points.size());
  for (const Vector3d& p : soup.points) points.emplace_back(p.x(), p.y(), p.z());
  Surface surface;
  pmp::polygon_soup_to_polygon_mesh(points, soup.faces, surface);
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

std::string not_filled(const std::filesystem::path& file) {
  return file.string() + ": it can't be filled with tetrahedra: CGAL's mesher fell over it";
}

}  // namespace

FilledSurface fill_surface(const std::filesystem::path& file, const SurfaceOptions& options,
                           double reading_seconds) try {
  const Demand demand{file.string()};
  SurfaceSoup soup = read(file, reading_seconds, demand);
  check_surface_soup(soup, demand.name);
  const Surface surface = surface_of(soup);

  FilledSurface filled;
  filled.given_triangles = static_cast<Index>(surface.size_of_facets());
  filled.given_volume = CGAL::to_double(pmp::volume(surface));
  const double cell = options.cell_size > 0.0 ? options.cell_size : diagonal(surface) / 8.0;
  const MeshSize size{filled.given_volume, CGAL::to_double(pmp::area(surface)), cell};
  demand_size(size, options, demand);
  std::cerr << kExpected << ' ' << size.tetrahedra() << ' ' << cell << std::endl;
  const double distance = options.facet_distance > 0.0 ? options.facet_distance : cell / 20.0;

  const LibraryGuard guard(
      {.code = kFirstFlaw + static_cast<int>(SurfaceFlaw::not_meshed), .fallen = not_filled(file)});
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
} catch (const CGAL::Failure_exception&) {  // an assertion of its own
  throw SurfaceError(SurfaceFlaw::not_meshed, not_filled(file));
}

}  // namespace stiction::reference
