// SPDX-License-Identifier: GPL-3.0-or-later
// What the mesher says: a mesh or one sentence; it reads as it was written, and is certified whatever
// its tetrahedra are.
#include <cstdint>
#include <stdexcept>
#include <string>

#include "fuzz/property.h"
#include "reference/meshes/box_mesh.h"
#include "reference/meshes/filled_surface.h"

using namespace stiction;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const auto filled = fuzz::value_or_sentence<std::invalid_argument>(
      [&] { return reference::filled_surface_from(text); });
  if (!filled) return 0;
  const std::string written = reference::to_text(*filled);
  fuzz::hold(reference::to_text(reference::filled_surface_from(written)) == written,
             "a filled surface reads as it was written");
  const auto certificate = fuzz::value_or_sentence<std::invalid_argument>(
      [&] { return reference::certify(filled->mesh); });
  if (!certificate) return 0;
  const Eigen::Matrix3Xi triangles = surface_triangles(filled->mesh.tetrahedra);
  fuzz::hold(
      certificate->non_manifold_faces > 0 || triangles.cols() == certificate->boundary_triangles,
      "the solver's surface is that of the certificate");
  return 0;
}
