// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// "paper, secant"; of a record that tells none, older ones among them, its settings.
std::string configuration_name(const Record& record);

/// The same and what differs from it: "quiet, kappa=0.7".
std::string configuration_text(const Record& record);

/// What runs a record's case again, from the project's folder: "./stiction validate --case 'slab/kappa'
/// --configuration 'quiet' --set kappa=0.7". What a record doesn't tell may be given: the files of a
/// user's own problems, and the words that start the engine. Without them the engine goes by its name,
/// if it isn't the project's own.
std::string rerun_command(const Record& record, const std::vector<std::string>& problems = {},
                          const std::string& engine = "");

}  // namespace stiction
