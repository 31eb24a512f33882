// SPDX-License-Identifier: GPL-3.0-or-later
// The mesher as a program: a closed surface → tetrahedra. filled_surface.h says what it writes.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "reference/meshes/mesh_surface/fill_surface.h"

namespace stiction::reference {

namespace {

int complain(int code, const std::string& sentence) {
  std::fprintf(stderr, "%s\n", sentence.c_str());
  return code;
}

int mesh_surface(const std::string& file, const SurfaceOptions& options) {
  if (const std::string wrong = options.check(); !wrong.empty()) {
    return complain(kMesherFailed, wrong);
  }
  try {
    const std::string text = to_text(fill_surface(file, options));
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0) {
      return complain(kMesherFailed, "the mesh could not be written to stdout");
    }
    return kFilled;
  } catch (const SurfaceError& error) {
    return complain(kFirstFlaw + static_cast<int>(error.flaw()), error.what());
  } catch (const std::bad_alloc&) {
    return complain(kMesherFailed, "memory ran out");
  } catch (const std::exception& error) {
    return complain(kMesherFailed, error.what());
  }
}

}  // namespace

}  // namespace stiction::reference

int main(int argc, char** argv) {
  using namespace stiction::reference;
  CLI::App app("Fills a closed triangle surface (OFF, OBJ, PLY, STL) with tetrahedra.",
               "mesh_surface");
  std::string file;
  SurfaceOptions options;
  app.add_option("file", file, "The surface")->required();
  app.add_option("--cell-size", options.cell_size,
                 "Circumradius of a tetrahedron at most, m; 0: an eighth of the diagonal");
  app.add_option("--facet-distance", options.facet_distance,
                 "Distance from the given surface at most, m; 0: a twentieth of the cell size");
  app.add_option("--feature-angle", options.feature_angle,
                 "Edges whose faces meet at less than 180° minus this are kept, degrees");
  app.add_option("--seed", options.seed, "Of CGAL's generator");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kFilled : kMesherFailed;
  }
  return mesh_surface(file, options);
}
