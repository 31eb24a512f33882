// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "reference/meshes/closed_surface.h"

namespace stiction::reference {

/// What a surface file holds: polygons by the indices of their points.
struct SurfaceSoup {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::size_t>> faces;
};

/// "off", "obj", "ply" or "stl" by the file's name. Throws SurfaceError when there is no such file, of
/// another name, larger than is read, or one that says it holds more than it can (declared_counts.h).
std::string surface_format(const std::filesystem::path& file);

/// What CGAL reads of such a file, of which nothing is promised; they fall over some files, so that a
/// LibraryGuard belongs around. False when it can't be read; throws what CGAL throws.
bool read_surface_soup(const std::filesystem::path& file, SurfaceSoup& soup);

/// Whatever the soup is: throws SurfaceError, which begins with `name`, unless its faces are triangles
/// that bound a volume. Merges points of equal coordinates and removes those of no triangle.
void check_surface_soup(SurfaceSoup& soup, const std::string& name);

}  // namespace stiction::reference
