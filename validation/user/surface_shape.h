// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/problem.h"
#include "validation/user/toml_reader.h"

namespace stiction {

/// The body of a [[body]] with shape = "surface": the closed surface of its `file`, which is looked for
/// from the folder of the problem's own, filled with tetrahedra. What takes longer is told on the
/// standard error: in place on a terminal, else as one line. Throws InputError for the file and its
/// keys, NotMeshed for the mesher, each with the line of the key.
MeshShape read_surface(TomlTable& table);

}  // namespace stiction
