// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/tally.h"

#include <fmt/format.h>

#include "reports/text/number.h"
#include "reports/text/text.h"

namespace stiction {

void Tally::add(const Record& record) {
  switch (record.verdict) {
    case Verdict::kPass:
      ++pass;
      break;
    case Verdict::kFail:
      ++fail;
      break;
    case Verdict::kShortfall:
      ++shortfall;
      break;
    case Verdict::kRefuted:
      ++refuted;
      break;
    case Verdict::kError:
      ++error;
      break;
    case Verdict::kNotApplicable:
      ++not_applicable;
      break;
    case Verdict::kForInformation:
      ++information;
      break;
  }
  cpu_seconds += record.cost.cpu_seconds;
  steps += record.cost.steps;
  contact_updates += record.cost.contact_updates;
}

Tally tally_of(const std::vector<Record>& records) {
  Tally tally;
  for (const Record& record : records) tally.add(record);
  return tally;
}

std::string verdicts_text(const Tally& tally) {
  return fmt::format("{} pass, {} fail, {}, {} refuted, {}, {} not applicable, {} for information",
                     tally.pass, tally.fail, counted(tally.shortfall, "expected shortfall"),
                     tally.refuted, counted(tally.error, "error"), tally.not_applicable,
                     tally.information);
}

std::string cost_text(const Tally& tally) {
  return fmt::format("CPU {} s, {} steps, {} contact updates", format_seconds(tally.cpu_seconds),
                     format_count(tally.steps), format_count(tally.contact_updates));
}

}  // namespace stiction
