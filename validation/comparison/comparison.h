// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/core/runner.h"

namespace stiction {

// `./stiction compare` sets iteration rules side by side on the same scenes. A comparison is a case
// whose variants are the rules; what it measures is shown and decides no verdict. A file in
// validation/comparison/cases/ returns its cases from `comparisons_<file>()`; the build writes the
// catalog.

/// All comparisons of the build, sorted by name.
std::vector<Case> comparison_catalog();

// Quantities that the findings look up again.
inline constexpr const char* kStartSlip = "slip at first";
inline constexpr const char* kStepsTo6 = "steps to 1e-6";
inline constexpr const char* kStepsTo9 = "steps to 1e-9";
inline constexpr const char* kFastestTo9 = "… fastest contact";
inline constexpr const char* kCreep = "final creep";
inline constexpr const char* kSlipped = "slipped";
inline constexpr const char* kSlippedShare = "slipped ÷ free slide";
inline constexpr const char* kFrom3 = "from 1e-3 to 1e-9";
inline constexpr const char* kFastestFrom3 = "from 1e-3, fastest";
inline constexpr const char* kSliding = "sliding";
inline constexpr const char* kPosesAtRest = "poses at rest";
inline constexpr const char* kPoses = "of";
inline constexpr const char* kCpuTime = "CPU time";
inline constexpr const char* kFrictionTime = "friction of a contact";
inline constexpr const char* kLearnedSlip = "slip along ũ, learned";
inline constexpr const char* kRootSlip = "… at the root of (15)";
inline constexpr const char* kAcrossSlip = "slip across ũ there";
inline constexpr const char* kBiasSlip = "least slip, 2N scalars";
inline constexpr const char* kDominance = "diagonal dominance";
inline constexpr const char* kPredictedRate = "predicted rate";
inline constexpr const char* kObservedRate = "observed rate";
inline constexpr const char* kFrictionRatio = "÷ that of the fixed point";

/// Every rule on the paper's contacts and on the quiet ones (`method`), so that the effect of the
/// rule and that of the normal forces are not mixed: all rules of the catalog with their default
/// gains, and those of them that have more than one reading or number of sweeps, in each.
std::vector<Settings> all_rules();

/// The setting of a variant that another build of the engine runs: "single" (EngineKind::builds).
inline constexpr const char* kBuild = "build";

/// The jobs, each with the engine that its variant asks for. Where that was not built they are not
/// applicable, in words.
std::vector<Job> with_builds(std::vector<Job> jobs);

/// Those that carry an argument: fixed point, secant, stored vector and conjugate directions.
std::vector<Settings> chief_rules();

/// The paper's scalar, the vector reading of it, and the stored vector, on the paper's contacts
/// with either depth and on the quiet ones.
std::vector<Settings> scalar_and_vector();

/// "paper", "quiet", "paper, projection depth": whose contacts. The depth only where it is not the
/// method's own.
std::string contacts_words(const Settings& settings);

/// "single precision"; nothing for the engine as it is.
std::string build_words(const Settings& settings);

/// "secant", "secant, memory = keep", "stored-vector, 4 sweeps": what tells a variant from others on the same contacts.
std::string rule_words(const Settings& settings);

}  // namespace stiction
