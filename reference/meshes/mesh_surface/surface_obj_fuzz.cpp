// SPDX-License-Identifier: GPL-3.0-or-later
// An OBJ file: a closed surface or one sentence (surface_fuzz.h).
#include "reference/meshes/mesh_surface/surface_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return stiction::fuzz::fuzz_surface("obj",
                                      std::string_view(reinterpret_cast<const char*>(data), size));
}
