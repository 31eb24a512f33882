// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <istream>
#include <string>

namespace stiction::reference {

/// What a surface file says of its own size before its contents, of which nobody has to believe a
/// word: a file of 60 bytes can ask for gigabytes.
///
/// Looks at the header of an OFF, PLY or binary STL file (`format`: "off", "ply", "stl"; OBJ has none),
/// which has `bytes` in all. Returns a sentence when that many vertices or faces cannot be in it, else
/// nothing; one too for a binary OFF file, of which CGAL reads no faces. A header that is not understood is
/// the reader's to refuse.
std::string claims_too_much(std::istream& file, const std::string& format, std::uint64_t bytes);

}  // namespace stiction::reference
