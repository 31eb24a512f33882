// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/old_record.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace stiction {
namespace {

// A decimal number that neither overflows nor underflows.
std::optional<double> real_of(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// "gain = -0.5, 2.3": values of a parameter, not the whole record. By hand: libstdc++'s regular
// expressions take stack for each character, and a line of any length may come.
Failure failure_of(const std::string& words) {
  constexpr std::string_view kEquals = " = ", kComma = ", ";
  const Failure as_text{words, "", {}};
  const std::string_view text = words;
  const std::size_t blank = text.find_first_of(" \t\n\v\f\r");
  if (blank == 0 || blank == text.npos || !text.substr(blank).starts_with(kEquals)) return as_text;
  Failure failure{"it broke", std::string(text.substr(0, blank)), {}};
  std::size_t end = blank;
  for (std::size_t begin = blank + kEquals.size(); end != text.npos; begin = end + kComma.size()) {
    end = text.find(kComma, begin);
    const std::optional<double> value = real_of(text.substr(begin, end - begin));
    if (!value) return as_text;
    failure.values.push_back(*value);
  }
  return failure;
}

}  // namespace

Judgement read_old_check(const JsonField& field) {
  Claim claim{.quantity = field["quantity"].text(),
              .unit = field["unit"].text(),
              .statement = field["claim"].text(),
              .formula = field.optional_text("formula"),
              .source = field["source"].text(),
              .kind = field["kind"].word(parse_reference_kind),
              .expected = field["expected"].real(),
              .relative = field["relative"].boolean(),
              .tolerance = field["tolerance"].real(),
              .reason = field["reason"].text()};
  // 1 stood for none, but where the expected value is 1 too it is that.
  const double scale = field["scale"].real();
  if (scale != 1.0 && std::abs(scale) != std::abs(claim.expected)) claim.scale = scale;
  Judgement check;
  check.value = field["value"].real();
  check.error = field["error"].real();
  check.worst = field.optional_text("worst");
  check.of_tolerance = share_of_tolerance(check.error, claim.tolerance);
  if (scale_of(claim)) check.digits = field["digits"].real();
  check.cause = field.optional_text(field.has("limit") ? "limit" : "cause");
  if (field.has("expected_low") || field.has("expected_high")) {
    check.band = Band{field["expected_low"].real(), field["expected_high"].real()};
  }
  check.verdict = field["verdict"].word(parse_verdict);
  check.claim = std::move(claim);
  return check;
}

void split_old_checks_and_notes(Record& record) {
  std::erase_if(record.checks, [&](const Judgement& check) {
    const Claim& claim = check.claim;
    const bool is_figure = check.verdict == Verdict::kForInformation && claim.tolerance == 0.0 &&
                           claim.reason.starts_with("none");
    if (is_figure) {
      record.figures.push_back({claim.quantity, claim.unit, claim.statement, check.value});
    }
    return is_figure;
  });
  constexpr std::string_view kFailed = "failed: ";
  std::erase_if(record.notes, [&](const std::string& note) {
    const bool is_failure = note.starts_with(kFailed);
    if (is_failure) record.failures.push_back(failure_of(note.substr(kFailed.size())));
    return is_failure;
  });
}

}  // namespace stiction
