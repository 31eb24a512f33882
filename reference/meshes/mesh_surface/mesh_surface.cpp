// SPDX-License-Identifier: GPL-3.0-or-later
// The mesher as a program: a closed surface → tetrahedra. filled_surface.h says what it writes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <string_view>

#include "reference/meshes/mesh_surface/fill_surface.h"
#include "reference/meshes/mesh_surface/library_guard.h"

namespace stiction::reference {

namespace {

// How many bytes a sign has that steers a terminal or turns the direction of text: control characters
// (C0, DEL, C1), breaks of lines, marks and overrides; 0 if `text` begins with none.
std::size_t steering(std::string_view text) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0;
  };
  const int first = byte(0), second = byte(1), third = byte(2);
  if (first < 0x20 || first == 0x7F) return 1;
  if (first == 0xC2 && second >= 0x80 && second <= 0x9F) return 2;  // C1
  if (first == 0xD8 && second == 0x9C) return 2;                    // U+061C
  const bool is_format = first == 0xE2 && second == 0x80 &&
                         (third == 0x8E || third == 0x8F || (third >= 0xA8 && third <= 0xAE));
  const bool is_isolate = first == 0xE2 && second == 0x81 && third >= 0xA6 && third <= 0xA9;
  return is_format || is_isolate ? 3 : 0;
}

// One line, whatever the name of a file is.
int complain(int code, std::string_view sentence) {
  std::string line;
  while (!sentence.empty()) {
    const std::size_t dropped = steering(sentence);
    line += dropped > 0 ? ' ' : sentence.front();
    sentence.remove_prefix(std::max<std::size_t>(dropped, 1));
  }
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
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
  if (app.exit(error, shown, said) != 0) return complain(kMesherFailed, error.what());
  if (show(shown.str())) return kFilled;
  return complain(kMesherFailed, "the help could not be written to the standard output");
}

int mesh_surface(const std::string& file, const SurfaceOptions& options, double reading_seconds) {
  if (const std::string wrong = options.check(); !wrong.empty()) {
    return complain(kMesherFailed, wrong);
  }
  if (!(reading_seconds > 0.0 && reading_seconds <= 1e6)) {
    return complain(kMesherFailed, "reading_limit must lie between 0 and 1e6");
  }
  try {
    if (show(to_text(fill_surface(file, options, reading_seconds)))) return kFilled;
    return complain(kMesherFailed, "the mesh could not be written to the standard output");
  } catch (const SurfaceError& error) {
    return complain(kFirstFlaw + static_cast<int>(error.flaw()), error.what());
  } catch (const std::bad_alloc&) {
    return complain(kMesherFailed,
                    "memory ran out: choose a larger cell_size, or a surface of fewer triangles");
  } catch (const std::exception& error) {
    return complain(kMesherFailed, error.what());
  }
}

}  // namespace

}  // namespace stiction::reference

int main(int argc, char** argv) {
  using namespace stiction::reference;
  std::signal(SIGPIPE, SIG_IGN);
  limit_memory();
  CLI::App app("Fills a closed triangle surface (OFF, OBJ, PLY, STL) with tetrahedra.",
               "mesh_surface");
  std::string file;
  SurfaceOptions options;
  double reading_seconds = 60.0;
  app.add_option("file", file, "The surface")->required();
  app.add_option("--cell-size", options.cell_size,
                 "Circumradius of a tetrahedron at most, m; 0: an eighth of the diagonal");
  app.add_option("--facet-distance", options.facet_distance,
                 "Distance from the given surface at most, m; 0: a twentieth of the cell size");
  app.add_option("--feature-angle", options.feature_angle,
                 "Edges whose faces meet at less than 180° minus this are kept, degrees");
  app.add_option("--seed", options.seed, "Of CGAL's generator");
  app.add_option("--most-tetrahedra", options.most_tetrahedra,
                 "A mesh of more is refused, before it is made where that can be told")
      ->capture_default_str();
  app.add_option("--unit", options.unit, "Of the file's lengths, m, for lengths in sentences");
  app.add_option("--reading-limit", reading_seconds,
                 "A file that takes longer to read is refused, s")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return end(app, error);
  }
  return mesh_surface(file, options, reading_seconds);
}
