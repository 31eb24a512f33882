// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "reports/record/judgement.h"

namespace stiction {

/// What is known beforehand of a value that does not meet its claim.
struct KnownShortfall {
  Band band{};
  Verdict verdict = Verdict::kShortfall;  ///< kShortfall or kRefuted
  std::string cause{};
  std::string because{};  ///< the cause in a few words
};

/// What is found of a claim. |error| ≤ tolerance · tolerance_scale holds. Without a known shortfall
/// it passes or fails. With one it is expected not to hold: inside the band its verdict is that of
/// the shortfall, outside on either side it fails, and it fails when it holds: then the band hides
/// nothing and has to go. NaN is in no band. A relative claim has a scale; anything else is a fault
/// of its case (std::logic_error).
Judgement judge(Claim claim, double value, double tolerance_scale = 1.0,
                const std::optional<KnownShortfall>& known = {});

/// What is told of a scale that is not 1.
std::string scale_sentence(double tolerance_scale);

/// What is said of runs with 1/finer of their time steps.
std::string finer_sentence(int finer);

/// The same numbers, judged by nobody: the verdict is kForInformation.
Judgement for_information(Claim claim, double value);

}  // namespace stiction
