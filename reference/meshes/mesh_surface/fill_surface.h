// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "reference/meshes/filled_surface.h"

namespace stiction::reference {

/// Reads a closed surface, checks it and fills it with tetrahedra, of which there may be none
/// [CGAL]. The same file and options give the same bits. Throws SurfaceError. `options` are usable.
/// A file that CGAL falls over, or reads for longer than `reading_seconds`, ends the process as a
/// SurfaceError would.
FilledSurface fill_surface(const std::filesystem::path& file, const SurfaceOptions& options,
                           double reading_seconds);

}  // namespace stiction::reference
