// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/engine/engine.h"

namespace stiction {

/// With what this project's solver runs a case, by the case's name: old (what the paper compares
/// itself with), paper with the fixed-point and with the secant iteration, quiet; where bodies
/// touch fixed half-spaces alone, the friction rules.
std::vector<Configuration> configurations_of(const std::string& case_name);

/// The configuration that any settings are, or are nearest to: its name and its settings.
/// Of old only what the engine's table expects is judged, that it breaks where the paper says so; the
/// paper's contacts, of vertices alone, let bodies pass that part.
Configuration configuration_of(const Settings& settings);

/// Those that most comparisons run: old, paper with either iteration, quiet.
const std::vector<Settings>& compared_methods();

/// The same, quiet first, for every case alike: what the solver tells as a program of its own.
std::vector<Configuration> method_configurations();

std::optional<Settings> settings_without(Without what);

}  // namespace stiction
