// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/decide/decide.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/statistics/two_samples.h"

namespace stiction::track {

// significance: with 12 against 12 samples the smallest p is 7e-7. Both runs wrong in the same
//   direction by chance: (0.01/2)² · 2 = 5e-5 a metric, if samples were independent; the floors
//   below are there because on a shared machine they are not.
// layout_floor: the same instructions at other addresses run up to some per cent faster or slower
//   [Mytkowicz2009], and an edit anywhere moves addresses. A comparison of a build with itself
//   cannot show that, so 3 % of it is assumed; the count of instructions sees what is smaller.
// count_margin: a compiler lays out a function a little differently when its neighbours change
//   (spills, inlining), worth a few instructions in a thousand. No counted event smaller than that
//   is worth a person's time; a count that was 0 may not grow at all.
// digits_margin: half a digit is an error 3.2 times as large. Values are clipped at their round-off
//   floor first (accuracy.cpp), so what remains is truncation and discretisation: a reordering of
//   sums leaves it alone to many digits, and half a digit is lost only by another method.
const Limits kLimits = {
    .significance = 0.01, .layout_floor = 0.03, .count_margin = 0.005, .digits_margin = 0.5};

namespace {

constexpr double kLevel = 0.95;
constexpr int kResamples = 4000;  // the interval's ends move by less than a tenth of its width
constexpr std::uint64_t kSeed = 20090915;

Change change_of(double badness) { return badness > 0.0 ? Change::kWorse : Change::kBetter; }

void compare_times(const Measurement& before, const Measurement& after, Comparison& result) {
  const reference::Interval interval =
      reference::bootstrap_median_ratio(before.samples, after.samples, kLevel, kResamples, kSeed);
  result.low = interval.low;
  result.high = interval.high;
  result.p = reference::mann_whitney_p(before.samples, after.samples);
  result.floor =
      std::max({reference::split_half_noise(before.samples, kLevel, kSeed),
                reference::split_half_noise(after.samples, kLevel, kSeed), kLimits.layout_floor});
  const bool excludes_one = interval.low > 1.0 || interval.high < 1.0;
  const double effect = std::log(result.ratio());
  if (result.p <= kLimits.significance && excludes_one && std::abs(effect) > result.floor) {
    result.change = change_of(result.badness());
  }
}

bool beyond_margin(const Comparison& result) {
  switch (result.metric.kind) {
    case Kind::kCount:
      return std::abs(result.after - result.before) > kLimits.count_margin * result.before;
    case Kind::kDigits:
      return std::abs(result.after - result.before) >= kLimits.digits_margin;
    default:
      return result.after != result.before;
  }
}

}  // namespace

double Comparison::badness() const {
  switch (metric.kind) {
    case Kind::kDigits:
      return (before - after) * std::numbers::ln10;
    case Kind::kVerdict:
      return 100.0 * (after - before);
    default:
      break;
  }
  if (before == after) return 0.0;
  return std::log(after / before);  // ±∞ from or to 0
}

Comparison compare(const Measurement& before, const Measurement& after) {
  Comparison result{.metric = after.metric,
                    .before = reference::median(before.samples),
                    .after = reference::median(after.samples)};
  const Kind kind = result.metric.kind;
  if (kind == Kind::kTime || kind == Kind::kOther) {
    compare_times(before, after, result);
  } else if (beyond_margin(result)) {
    result.change = change_of(result.badness());
  }
  return result;
}

std::vector<Comparison> compare(const Measurements& before, const Measurements& after) {
  std::vector<Comparison> comparisons;
  for (const auto& [name, measurement] : after.all()) {
    const Measurement* const earlier = before.find(name);
    if (earlier != nullptr) comparisons.push_back(compare(*earlier, measurement));
  }
  sort_worst_first(comparisons);
  return comparisons;
}

std::vector<std::string> missing(const Measurements& a, const Measurements& b) {
  std::vector<std::string> names;
  for (const auto& [name, measurement] : a.all()) {
    if (b.find(name) == nullptr) names.push_back(name);
  }
  return names;
}

void confirm(std::vector<Comparison>& first, const std::vector<Comparison>& second) {
  for (Comparison& claim : first) {
    if (claim.change == Change::kSame || claim.metric.kind != Kind::kTime) continue;
    const auto again = std::find_if(second.begin(), second.end(), [&](const Comparison& other) {
      return other.metric.name() == claim.metric.name();
    });
    if (again != second.end() && again->change == claim.change) continue;
    claim.change = Change::kSame;
    claim.refuted = true;
  }
  sort_worst_first(first);
}

bool any(const std::vector<Comparison>& comparisons, Change change) {
  return std::any_of(comparisons.begin(), comparisons.end(),
                     [&](const Comparison& one) { return one.change == change; });
}

void sort_worst_first(std::vector<Comparison>& comparisons) {
  const auto rank = [](const Comparison& one) {
    return one.change == Change::kWorse ? 0 : one.change == Change::kBetter ? 1 : 2;
  };
  std::stable_sort(comparisons.begin(), comparisons.end(),
                   [&](const Comparison& a, const Comparison& b) {
                     if (rank(a) != rank(b)) return rank(a) < rank(b);
                     return a.badness() > b.badness();
                   });
}

}  // namespace stiction::track
