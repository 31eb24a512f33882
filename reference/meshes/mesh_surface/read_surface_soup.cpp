// SPDX-License-Identifier: GPL-3.0-or-later
// A file of its own, as it is compiled without sanitizers: CGAL's readers know no bounds.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>

#include "reference/meshes/mesh_surface/surface_soup.h"

namespace stiction::reference {

bool read_surface_soup(const std::filesystem::path& file, SurfaceSoup& soup) {
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  const bool good = CGAL::IO::read_polygon_soup(file.string(), points, soup.faces,
                                                CGAL::parameters::verbose(false));
  soup.points.reserve(points.size());
  for (const auto& p : points) soup.points.emplace_back(p.x(), p.y(), p.z());
  return good;
}

}  // namespace stiction::reference
