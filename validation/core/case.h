// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "validation/engine/engine.h"

namespace stiction {

class CaseRun;

/// How much of the catalog a run takes.
enum class CaseSet {
  kQuick,    ///< seconds: with --quick, and in every other set
  kDefault,  ///< the few minutes of `./stiction validate`
  kFull      ///< only with --full
};

/// "quick", "default" or "full".
inline const char* name_of(CaseSet set) {
  constexpr const char* kNames[] = {"quick", "default", "full"};
  return kNames[static_cast<int>(set)];
}

/// One physical claim, run on any engine. A file in validation/cases/ returns its cases from a
/// function `cases_<file>()`; the build writes the catalog.
struct Case {
  std::string name{};   ///< path-like and unique: family/claim/parameter=value
  std::string title{};  ///< one line for people
  CaseSet set = CaseSet::kDefault;
  /// Which of the suites it belongs to: "", what `./stiction validate` runs, or "stability".
  std::string suite{};
  /// Settings that it runs with by default, of a study of one engine. Empty, as in every neutral
  /// case: the engine's own configurations.
  std::vector<Settings> variants{};
  std::function<void(CaseRun&)> run{};  ///< simulates and adds checks, series and notes
};

/// The settings with which a case runs on an engine unless a user says otherwise; those of a full
/// run among them if `full`.
std::vector<Settings> variants_of(const Case& which, const EngineKind& engine, bool full);

/// Whether the engine runs the case with these settings for contrast (Configuration::contrast).
bool for_contrast(const Case& which, const EngineKind& engine, const Settings& settings);

/// All neutral cases of the build, sorted by name. Written by the build from validation/cases/.
std::vector<Case> case_catalog();

/// With those that study this engine, sorted by name.
std::vector<Case> cases_for(const EngineKind& engine);

}  // namespace stiction
