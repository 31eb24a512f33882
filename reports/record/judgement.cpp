// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/judgement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace stiction {
namespace {

template <typename Enum, std::size_t kCount>
using Words = std::array<std::pair<Enum, std::string_view>, kCount>;

constexpr Words<Verdict, 7> kVerdictWords{{{Verdict::kPass, "pass"},
                                           {Verdict::kFail, "fail"},
                                           {Verdict::kShortfall, "expected-shortfall"},
                                           {Verdict::kRefuted, "refuted"},
                                           {Verdict::kNotApplicable, "not-applicable"},
                                           {Verdict::kForInformation, "for-information"},
                                           {Verdict::kError, "error"}}};

constexpr Words<ReferenceKind, 5> kKindWords{{{ReferenceKind::kAnalytic, "analytic"},
                                              {ReferenceKind::kExactComputed, "exact-computed"},
                                              {ReferenceKind::kSelfConverged, "self-converged"},
                                              {ReferenceKind::kExternal, "external"},
                                              {ReferenceKind::kGolden, "golden"}}};

template <typename Enum, std::size_t kCount>
std::string word_of(const Words<Enum, kCount>& words, Enum value) {
  for (const auto& [candidate, word] : words) {
    if (candidate == value) return std::string(word);
  }
  throw std::logic_error("an enumeration value without a word");
}

template <typename Enum, std::size_t kCount>
std::optional<Enum> value_of(const Words<Enum, kCount>& words, const std::string& word) {
  for (const auto& [value, candidate] : words) {
    if (candidate == word) return value;
  }
  return std::nullopt;
}

// Higher decides over lower; 0 and 1 decide nothing.
int severity(Verdict verdict) {
  switch (verdict) {
    case Verdict::kError:
      return 6;
    case Verdict::kFail:
      return 5;
    case Verdict::kShortfall:
      return 4;
    case Verdict::kRefuted:
      return 3;
    case Verdict::kPass:
      return 2;
    case Verdict::kForInformation:
      return 1;
    case Verdict::kNotApplicable:
      return 0;
  }
  throw std::logic_error("an enumeration value without a severity");
}

}  // namespace

Verdict combined_verdict(const std::vector<Judgement>& checks) {
  Verdict worst = Verdict::kNotApplicable;
  for (const Judgement& check : checks) {
    if (severity(check.verdict) > severity(worst)) worst = check.verdict;
  }
  return worst;
}

const Judgement* worst_check(const std::vector<Judgement>& checks) {
  const Verdict verdict = combined_verdict(checks);
  if (severity(verdict) < severity(Verdict::kPass)) return nullptr;
  const Judgement* worst = nullptr;
  for (const Judgement& check : checks) {
    if (check.verdict != verdict) continue;
    if (worst == nullptr || check.of_tolerance > worst->of_tolerance) worst = &check;
  }
  return worst;
}

std::optional<double> scale_of(const Claim& claim) {
  if (claim.scale) return std::abs(*claim.scale);
  return claim.expected != 0.0 ? std::optional(std::abs(claim.expected)) : std::nullopt;
}

double share_of_tolerance(double error, double tolerance) {
  const double size = std::abs(error);
  if (std::isnan(size) || std::isnan(tolerance)) return std::numeric_limits<double>::infinity();
  return size == 0.0 ? 0.0 : size / tolerance;
}

double correct_digits(double difference, double scale) {
  constexpr double kMost = 16.0;  // a double holds no more
  if (!std::isfinite(difference)) return 0.0;
  if (difference == 0.0) return kMost;
  return std::clamp(-std::log10(std::abs(difference) / std::abs(scale)), 0.0, kMost);
}

std::string to_string(Verdict verdict) { return word_of(kVerdictWords, verdict); }

std::string to_string(ReferenceKind kind) { return word_of(kKindWords, kind); }

std::optional<Verdict> parse_verdict(const std::string& word) {
  // Words of schema version 3 and before.
  if (word == "limit") return Verdict::kShortfall;
  if (word == "shown") return Verdict::kForInformation;
  return value_of(kVerdictWords, word);
}

std::optional<ReferenceKind> parse_reference_kind(const std::string& word) {
  return value_of(kKindWords, word);
}

}  // namespace stiction
