// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_surface/surface_soup.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "reference/meshes/mesh_size.h"
#include "reference/meshes/mesh_surface/declared_counts.h"

namespace stiction::reference {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

constexpr std::uint64_t kLargestFile = 500'000'000;  // bytes

/// Throws `flaw` with the file's name unless it holds.
struct Demand {
  std::string name;

  void operator()(bool holds, SurfaceFlaw flaw, const std::string& what) const {
    if (!holds) throw SurfaceError(flaw, name + ": " + what);
  }
};

std::string in_digits(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

// Products of several lengths must be numbers yet. Beyond these CGAL's mesher fails, or has no end; of sizes in
// m, mm or inch none comes near.
constexpr double kSmallest = 1e-20, kLargest = 1e20;
constexpr double kNegligible = 1e-60;  // of the extent
constexpr double kClosest = 1e-15;     // of the extent: about what a double resolves

// The largest coordinate.
double demand_sizes(const std::vector<Eigen::Vector3d>& points, const Demand& demand) {
  double extent = 0.0;
  for (const Eigen::Vector3d& p : points) {
    demand(p.allFinite(), SurfaceFlaw::not_finite, "a coordinate is not finite");
    extent = std::max(extent, p.cwiseAbs().maxCoeff());
  }
  demand(extent == 0.0 || (extent >= kSmallest && extent <= kLargest), SurfaceFlaw::degenerate,
         "its largest coordinate is " + in_digits(extent) +
             ", which can't be computed with: write it in another unit");
  for (const Eigen::Vector3d& p : points) {
    for (const double x : p) {
      demand(x == 0.0 || std::abs(x) >= kNegligible * extent, SurfaceFlaw::degenerate,
             "a coordinate is " + in_digits(x) + " and others " + in_digits(extent) +
                 ", which can't be computed with: write it as 0");
    }
  }
  return extent;
}

std::vector<Point> cgal_points(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Point> converted;
  converted.reserve(points.size());
  for (const Eigen::Vector3d& p : points) converted.emplace_back(p.x(), p.y(), p.z());
  return converted;
}

std::vector<Eigen::Vector3d> plain_points(const std::vector<Point>& points) {
  std::vector<Eigen::Vector3d> converted;
  converted.reserve(points.size());
  for (const Point& p : points) converted.emplace_back(p.x(), p.y(), p.z());
  return converted;
}

}  // namespace

std::string surface_format(const std::filesystem::path& file) {
  const Demand demand{file.string()};
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
  return format;
}

void check_surface_soup(SurfaceSoup& soup, const std::string& name) {
  const Demand demand{name};
  demand(!soup.points.empty() && !soup.faces.empty(), SurfaceFlaw::empty, "it has no triangles");
  const double extent = demand_sizes(soup.points, demand);
  for (const std::vector<std::size_t>& face : soup.faces) {
    demand(face.size() == 3, SurfaceFlaw::not_triangles,
           "a face has " + std::to_string(face.size()) + " corners; only triangles can be read");
    for (const std::size_t corner : face) {
      demand(corner < soup.points.size(), SurfaceFlaw::unreadable, "a face names no such vertex");
    }
  }
  std::vector<Point> points = cgal_points(soup.points);
  pmp::merge_duplicate_points_in_polygon_soup(points, soup.faces);
  for (const std::vector<std::size_t>& f : soup.faces) {
    demand(!CGAL::collinear(points[f[0]], points[f[1]], points[f[2]]), SurfaceFlaw::degenerate,
           "a triangle has no area");
    for (std::size_t k = 0; k < 3; ++k) {
      const double apart = std::sqrt(CGAL::squared_distance(points[f[k]], points[f[(k + 1) % 3]]));
      demand(apart >= kClosest * extent, SurfaceFlaw::degenerate,
             "two corners of a triangle are " + in_digits(apart) + " apart and its largest " +
                 "coordinate is " + in_digits(extent) + ": make them one");
    }
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
  pmp::remove_isolated_points_in_polygon_soup(points, soup.faces);
  CGAL::Surface_mesh<Point> surface;
  pmp::polygon_soup_to_polygon_mesh(points, soup.faces, surface);
  demand(!pmp::does_self_intersect(surface), SurfaceFlaw::self_intersecting,
         "it intersects itself");
  demand(pmp::does_bound_a_volume(surface) && CGAL::to_double(pmp::volume(surface)) > 0.0,
         SurfaceFlaw::not_bounding,
         "it doesn't bound a volume: faces look inwards, or nested parts contradict each other");
  soup.points = plain_points(points);
}

}  // namespace stiction::reference
