// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesher.h"

#include <cstdlib>

#include "reference/process/child.h"

namespace stiction::reference {

namespace {

constexpr const char* kName = "mesh_surface";

std::filesystem::path named_by(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr ? value : "";
}

}  // namespace

MesherPlaces mesher_places() {
  MesherPlaces places;
  places.program = named_by("STICTION_MESHER");
  places.folders = folders_of_path();
  places.folders.insert(places.folders.begin(), folder_of_this_program());
  places.builder = named_by("STICTION_SCRIPT");
  return places;
}

std::filesystem::path find_mesher(const MesherPlaces& places) {
  if (!places.program.empty()) return places.program;
  std::filesystem::path found = find_program(kName, places.folders);
  if (!found.empty()) return found;
  if (!places.builder.empty()) {
    const Ended built = run_child({places.builder.string(), "mesher"}, {.show_errors = true});
    if (built.code != 0) throw MesherError("the mesher could not be built");
    found = find_program(kName, places.folders);
    if (!found.empty()) return found;
  }
  throw MesherError(
      "the mesher is not built: 'cmake --build BUILD_FOLDER --target mesh_surface' does it, and it "
      "is looked for beside this program and in PATH");
}

}  // namespace stiction::reference
