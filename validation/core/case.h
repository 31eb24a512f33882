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

/// One physical claim, run on any engine. A file in validation/cases/ returns its cases from a
/// function `cases_<file>()`; the build writes the catalog.
struct Case {
  std::string name{};   ///< path-like and unique: family/claim/parameter=value
  std::string title{};  ///< one line for people
  CaseSet set = CaseSet::kDefault;
  std::vector<Settings> variants = {{}};  ///< engine settings that it runs with by default
  std::function<void(CaseRun&)> run{};    ///< simulates and adds checks, series and notes
};

/// All cases of the build, sorted by name. Written by the build from validation/cases/.
std::vector<Case> case_catalog();

}  // namespace stiction
