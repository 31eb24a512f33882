// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/user/toml_reader.h"

namespace stiction {

/// Every table and key of a problem's file: what the reader accepts, and what --help-problem prints.
namespace problem_keys {

const TomlKeys& file();
const TomlKeys& gravity();
const TomlKeys& drag();
const TomlKeys& obstacle();
const TomlKeys& body();
const TomlKeys& rotation();
const TomlKeys& held();
const TomlKeys& motion();
const TomlKeys& load();
const TomlKeys& force();
const TomlKeys& couple();
const TomlKeys& spring();
const TomlKeys& pair();
const TomlKeys& check();
const TomlKeys& direction();
const TomlKeys& series();
const TomlKeys& threshold();
const TomlKeys& sweep();

/// What a threshold or a sweep can vary.
inline constexpr const char* kVaries =
    "a number of this file: KEY, drag.KEY, gravity.KEY, engine.KEY, NAME.KEY of an obstacle or "
    "body, "
    "NAME.motion.KEY, or NAME.force, NAME.couple and the keys of both (NAME.force.value) of the "
    "only "
    "[[load]] on a body; of a vector its length, of keyframes that of the longest";

/// All of them, in the order in which they are explained.
std::vector<const TomlKeys*> all();

}  // namespace problem_keys

/// Tables and keys with form, unit, default and meaning, in lines of at most `width` columns where a
/// word allows it. The first table is the file itself.
std::string keys_help(const std::vector<const TomlKeys*>& tables, std::size_t width);

/// What --help-problem prints: tables and keys with form, unit, default and meaning, the observables
/// and the units; lines of at most `width` columns where a word allows it.
std::string problem_help(std::size_t width);

}  // namespace stiction
