// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stiction {

/// What an expected value rests on.
enum class ReferenceKind { kAnalytic, kExactComputed, kSelfConverged, kExternal, kGolden };

/// Outcome of one check, and of a record as the worst of its checks. `kForInformation` marks a
/// quantity that is reported beside the verdicts (the old method, a literal reading) and never
/// decides one. `kShortfall` and `kRefuted` mark a check whose claim does not hold, but whose value
/// lies in a band that was stated beforehand with its cause: a shortfall of the method, or a claim
/// of the paper that was tested and found not to hold. Outside the band, on either side, it fails.
enum class Verdict { kPass, kFail, kShortfall, kRefuted, kNotApplicable, kForInformation, kError };

/// What a case claims of one quantity, known before anything is run.
struct Claim {
  std::string quantity{};   ///< what is measured, e.g. "stopping distance"
  std::string unit{};       ///< SI; "1" when dimensionless
  std::string statement{};  ///< one sentence, what must hold
  std::string formula{};    ///< closed form in Unicode maths; may be empty
  std::string source{};     ///< bibliography key or derivation
  ReferenceKind kind = ReferenceKind::kAnalytic;
  double expected = 0.0;  ///< in `unit`
  bool relative = false;  ///< error and tolerance are relative to the scale
  /// Size of the quantity, in `unit`, > 0: what errors are relative to and digits count from.
  /// Without it |expected| is the scale; where that is 0 too there is none, and no digits.
  std::optional<double> scale{};
  double tolerance =
      0.0;  ///< |error| ≤ tolerance holds; in `unit`, or of the scale when `relative`
  std::string reason{};  ///< derivation of the tolerance
  /// It compares differences between runs, such as an order of convergence: that multiplies their
  /// rounding, so that a perturbed case does not count its digits. Not in records.
  bool derived = false;
  std::string headline{};  ///< what a run's summary calls it; empty: it has no line there
};

/// Where a value is expected that falls short of its claim; both ends belong to it.
struct Band {
  double low = 0.0;   ///< in the claim's unit
  double high = 0.0;  ///< in the claim's unit; infinite for what diverges
};

/// What was found of a claim.
struct Judgement {
  Claim claim{};
  double value = 0.0;         ///< measured, in the claim's unit
  std::string worst{};        ///< where the worst offender stood; may be empty
  double error = 0.0;         ///< value − expected, or its ratio to the scale when `relative`
  double of_tolerance = 0.0;  ///< |error| ÷ tolerance; 0 without error, infinite for no number
  /// −log₁₀ |value − expected| / scale, between 0 and 16; nothing without a scale.
  std::optional<double> digits{};
  std::optional<Band> band{};  ///< where the value is expected, short of its claim; mostly nowhere
  std::string cause{};         ///< why, as measured; empty without a band
  std::string because{};       ///< what the cause comes down to, in a few words; may be empty
  Verdict verdict = Verdict::kFail;
};

/// What digits count from and relative errors are relative to: the claim's scale, else |expected|
/// where it is not 0, else nothing.
std::optional<double> scale_of(const Claim& claim);

/// |error| ÷ tolerance: a claim holds up to 1. No error is 0 even without tolerance; one that is no
/// number is infinite.
double share_of_tolerance(double error, double tolerance);

/// Correct digits of a value: −log10(|difference| / scale), between 0 and 16; 16 when there is no
/// difference, 0 when it is no number.
double correct_digits(double difference, double scale);

/// Worst of a record's checks: error, then fail, then shortfall, then refuted, then pass. When
/// nothing decides: kForInformation if a check is, otherwise (an empty list too) kNotApplicable.
Verdict combined_verdict(const std::vector<Judgement>& checks);

/// The check that decides: of those with the worst verdict (order as above), the one that takes
/// most of its tolerance (the first of equals). Null when none decides. The pointer lives as long
/// as `checks` is unchanged.
const Judgement* worst_check(const std::vector<Judgement>& checks);

/// Spelling used in records and tables ("pass", "exact-computed", …), and back.
/// The parsers return nothing for an unknown word; they know those of older schema versions.
std::string to_string(Verdict verdict);
std::string to_string(ReferenceKind kind);
std::optional<Verdict> parse_verdict(const std::string& word);
std::optional<ReferenceKind> parse_reference_kind(const std::string& word);

}  // namespace stiction
