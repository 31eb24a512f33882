// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/user/toml_reader.h"

/// The keys of a study's file, table by table: what is read, and what --help-study prints.
namespace stiction::study_keys {

const TomlKeys& file();
const TomlKeys& engine();
const TomlKeys& axis();
const TomlKeys& sample();
const TomlKeys& boundary();

}  // namespace stiction::study_keys
