// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "reports/recording/frames.h"

namespace stiction {

/// The surfaces of one frame as a VTK PolyData file (.vtp, XML): points in m, the cell array `body`
/// with the body's index.
std::string vtp_bodies(const Recording& recording, const Frame& frame);

/// The contacts of one frame: a point each, with the arrays `normal_force` and `friction_force` (N)
/// and `sticks` (1 or 0), which ParaView's Glyph filter draws as arrows.
std::string vtp_contacts(const Frame& frame);

/// Writes folder/name.pvd, which ParaView opens as one animation, and folder/name/bodies_0000.vtp,
/// contacts_0000.vtp and so on for each frame. `name` is a plain file name. Throws
/// std::invalid_argument for another, std::runtime_error when the system fails.
void write_vtk(const std::filesystem::path& folder, const std::string& name,
               const Recording& recording);

}  // namespace stiction
