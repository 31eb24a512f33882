// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/old_record.h"

#include <cmath>
#include <regex>
#include <sstream>
#include <string_view>
#include <utility>

namespace stiction {
namespace {

std::string optional_text(const JsonField& parent, const char* name) {
  return parent.has(name) ? parent[name].text() : std::string();
}

// "gain = -0.5, 2.3": values of a parameter, not the whole record.
Failure failure_of(const std::string& text) {
  static const std::regex values(R"((\S+) = ([-+\d.e]+(?:, [-+\d.e]+)*))");
  std::smatch found;
  if (!std::regex_match(text, found, values)) return {text, "", {}};
  Failure failure{"it broke", found[1], {}};
  std::istringstream list(found[2]);
  for (std::string value; std::getline(list, value, ',');) {
    failure.values.push_back(std::stod(value));
  }
  return failure;
}

}  // namespace

Judgement read_old_check(const JsonField& field) {
  Claim claim{.quantity = field["quantity"].text(),
              .unit = field["unit"].text(),
              .statement = field["claim"].text(),
              .formula = optional_text(field, "formula"),
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
  check.worst = optional_text(field, "worst");
  check.of_tolerance = share_of_tolerance(check.error, claim.tolerance);
  if (scale_of(claim)) check.digits = field["digits"].real();
  check.cause = optional_text(field, field.has("limit") ? "limit" : "cause");
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
