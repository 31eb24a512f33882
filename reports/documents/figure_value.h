// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/documents/figure_rule.h"
#include "reports/record/record.h"

namespace stiction {

/// What a run says of a figure.
struct FigureValue {
  double low = 0.0;  ///< = high, but of a range
  double high = 0.0;
  Verdict verdict = Verdict::kForInformation;  ///< of the checks it stands for
};

/// Whether a record is of the figure's cases.
bool is_of(const FigureRule& rule, const Record& record);

/// Looks a figure up. Throws std::runtime_error with one sentence that begins with the rule's place
/// when the records have no such case, settings or quantity, or more than one where the rule says
/// nothing about several.
FigureValue value_of(const FigureRule& rule, const std::vector<Record>& records);

/// What the rule shows of the last run that has a record of its case. Throws as above.
std::string sample_of(const SampleRule& rule, const std::vector<std::vector<Record>>& runs);

/// How the value stands in a document: "3e-4", "0.0057", "7 to 205", "never", "slips out".
std::string text_of(const FigureValue& value, const FigureStyle& style);

/// What separates a fresh value from a kept one: a sentence when the verdict is another one or the
/// value has left the rule's band; else empty.
std::string disagreement(const FigureRule& rule, const FigureValue& kept, const FigureValue& fresh);

}  // namespace stiction
