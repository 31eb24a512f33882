// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/judge/verdict.h"

namespace stiction {

/// A text that rows of a table share, and the word that the table's source has for it.
struct Words {
  const char* name;
  const char* text;
};

/// What was measured to be the cause, and where; and what it comes down to in a few words, which the
/// causes of several rows share.
struct Cause {
  const char* name;
  const char* text;
  const char* because;
};

/// A shortfall that is expected of an engine: where a value lies that does not meet its claim, why,
/// and why the band is as wide as it is. Data beside an engine, never in a case.
///
/// Inside the band a check that misses its claim has the row's verdict, expected shortfall or refuted; one
/// outside fails on either side, and so does one that meets the claim: then the row has to go.
/// Rows hold for the catalog's own variants at tolerance scale 1 only. What a user's `--set` or
/// `--tolerance-scale` makes of a case nobody has measured, so it passes or fails plainly. With
/// `--finer` the checks of these rows are for information.
struct Expectation {
  const char* cases;     ///< name, or a glob in which * crosses '/'
  const char* variant;   ///< settings of the catalog's variant, e.g. "method=paper rule=secant"
  const char* quantity;  ///< of the check
  Band band;             ///< of the value, in the check's unit, two significant digits
  Verdict verdict;       ///< kShortfall, or kRefuted for a claim of the paper
  Cause cause;
  Words width;  ///< the rule by which the band's ends were chosen
};

using Expectations = std::vector<Expectation>;

/// The variant as tables spell it: "method=paper rule=secant".
std::string variant_text(const std::map<std::string, std::string>& settings);

/// The rows that a run of this case with this variant has to meet, each by a check of its own.
Expectations expectations_of(const Expectations& all, const std::string& case_name,
                             const std::string& variant);

/// The row of a quantity; null when there is none. Two rows for one check are a fault of the table
/// (std::logic_error).
const Expectation* find_expectation(const Expectations& of_run, const std::string& quantity);

/// What a row says of its check's value.
KnownShortfall known_shortfall(const Expectation& row);

/// The claim that fails, with the value 0, because an expectation describes no check of its case
/// any more.
Claim unmet_claim(const Expectation& row);

}  // namespace stiction
