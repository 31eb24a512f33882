// SPDX-License-Identifier: GPL-3.0-or-later
// An OFF file: a closed surface or one sentence (surface_fuzz.h).
#include "reference/meshes/mesh_surface/surface_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return stiction::fuzz::fuzz_surface("off",
                                      std::string_view(reinterpret_cast<const char*>(data), size));
}
