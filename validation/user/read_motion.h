// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/scene/gravity.h"
#include "solver/scene/load.h"
#include "validation/user/toml_reader.h"

namespace stiction {

/// What changes over time, as a table of keyframes, a constant and a sine. Each throws InputError
/// with file and line.

Motion read_motion(TomlTable table);
/// The top of the file's: a vector, a table, or nothing for (0, 0, −9.81) m/s².
Gravity read_gravity(TomlTable& top);
/// Of a load, under this key: a vector or a table.
VectorOverTime read_force(TomlTable& load, const std::string& key, const TomlKeys& keys);

}  // namespace stiction
