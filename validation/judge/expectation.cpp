// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/judge/expectation.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include "reports/text/check_text.h"
#include "solver/demand.h"

namespace stiction {

std::string variant_text(const std::map<std::string, std::string>& settings) {
  return settings.empty() ? "default" : settings_text(settings);
}

Expectations expectations_of(const Expectations& all, const std::string& case_name,
                             const std::string& variant) {
  Expectations found;
  for (const Expectation& row : all) {
    if (row.variant == variant && fnmatch(row.cases, case_name.c_str(), 0) == 0) {
      found.push_back(row);
    }
  }
  return found;
}

const Expectation* find_expectation(const Expectations& of_run, const std::string& quantity) {
  const Expectation* found = nullptr;
  for (const Expectation& row : of_run) {
    if (row.quantity != quantity) continue;
    demand(found == nullptr, "a check has one expectation at most");
    found = &row;
  }
  return found;
}

KnownShortfall known_shortfall(const Expectation& row) {
  return {row.band, row.verdict, fmt::format("{} (band: {})", row.cause.text, row.width.text),
          row.cause.because};
}

Claim unmet_claim(const Expectation& row) {
  return {.quantity = fmt::format("checks of '{}'", row.quantity),
          .unit = "1",
          .statement = "what is expected of a case is what one of its checks measures",
          .source = "the engine's table of expectations",
          .kind = ReferenceKind::kExactComputed,
          .expected = 1.0,
          .tolerance = 0.0,
          .reason = "a count: the case no longer measures this, so that the row has to go"};
}

}  // namespace stiction
