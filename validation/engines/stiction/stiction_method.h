// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "solver/options.h"
#include "validation/engine/settings.h"

namespace stiction {

/// Reads `method` (old, paper, quiet) and the single settings over it into solver options, so that
/// each ingredient can be measured alone. Throws InputError for a word that is none of a setting's.
void read_method(SettingsReader& reader, Options& options);

/// The rule and its parameters as settings again.
Settings rule_settings(const Options& options);

/// The method as settings again. Of two-sided contact only when the scene can have any.
Settings method_settings(const Options& options, bool with_pairs);

/// Parameters given that the rule of these settings has not got: name → a sentence that says so.
/// Throws InputError as read_method() does.
std::map<std::string, std::string> idle_settings(const Settings& settings);

/// What a parameter is, its unit, range and default: one line.
std::string parameter_help(const RuleParameter& parameter);

/// Name → meaning, unit, default; the parameters of all rules among them.
std::map<std::string, std::string> method_settings_help();

}  // namespace stiction
