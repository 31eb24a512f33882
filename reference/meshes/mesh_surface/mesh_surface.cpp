// SPDX-License-Identifier: GPL-3.0-or-later
// The mesher as a program: a closed surface → tetrahedra. filled_surface.h says what it writes.
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>

#include "reference/meshes/mesh_surface/fill_surface.h"

namespace stiction::reference {

namespace {

int complain(int code, const std::string& sentence) {
  std::fprintf(stderr, "%s\n", sentence.c_str());
  return code;
}

// Returns whether all of it was written; a pipe that nobody reads is an error of the write too.
bool show(const std::string& text) {
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() &&
         std::fflush(stdout) == 0;
}

// Of words that end the program: --help, or such that are refused.
int end(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream shown, said;
  const bool fine = app.exit(error, shown, said) == 0;
  std::fputs(said.str().c_str(), stderr);
  if (!show(shown.str())) {
    return complain(kMesherFailed, "the help could not be written to the standard output");
  }
  return fine ? kFilled : kMesherFailed;
}

int mesh_surface(const std::string& file, const SurfaceOptions& options) {
  if (const std::string wrong = options.check(); !wrong.empty()) {
    return complain(kMesherFailed, wrong);
  }
  try {
    if (show(to_text(fill_surface(file, options)))) return kFilled;
    return complain(kMesherFailed, "the mesh could not be written to the standard output");
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
  std::signal(SIGPIPE, SIG_IGN);
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
    return end(app, error);
  }
  return mesh_surface(file, options);
}
