// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/failure_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/formats/summary_table.h"
#include "reports/formats/verdict_word.h"
#include "reports/text/check_text.h"
#include "reports/text/configuration_text.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

bool is_bad(Verdict verdict) { return verdict == Verdict::kFail || verdict == Verdict::kError; }

std::string failure_words(const Judgement& check) {
  if (check.band) return band_text(check);
  // That of the record is not scaled.
  if (check.of_tolerance <= 1.0) return ": beyond its scaled tolerance";
  if (std::isnan(check.value)) return ": no number";
  if (!std::isfinite(check.of_tolerance)) return ": endlessly beyond its tolerance";
  return fmt::format(": {} its tolerance", share_text(check.of_tolerance));
}

}  // namespace

std::string failing_lines(const std::vector<Record>& records, const Screen& screen) {
  std::vector<const Record*> bad;
  for (const Record& record : records) {
    if (is_bad(record.verdict)) bad.push_back(&record);
  }
  std::string text;
  for (std::size_t k = 0; k < std::min(bad.size(), kMostSummaryRows); ++k) {
    const Record& record = *bad[k];
    const Judgement* const worst = worst_check(record.checks);
    std::string what = record.error;
    if (what.empty() && worst != nullptr) {
      what = one_line(worst->claim.quantity) + failure_words(*worst);
    }
    const std::string plain = padded_right(verdict_word(record.verdict), kVerdictWidth);
    std::string lines = bullet(
        fmt::format("{}  {}: {}", one_line(record.case_name), configuration_text(record), what),
        screen.width, std::string(kSummaryIndent) + plain + "  ");
    text +=
        lines.replace(kSummaryIndent.size(), plain.size(), verdict_cell(record.verdict, screen));
  }
  if (bad.size() > kMostSummaryRows) {
    text += fmt::format("{}and {} more, each whole in report.md\n", kSummaryIndent,
                        bad.size() - kMostSummaryRows);
  }
  return text;
}

std::string failure_block(const Record& record, const Screen& screen, const std::string& rerun) {
  if (!is_bad(record.verdict)) return "";
  const std::string indent(kVerdictWidth + 2, ' ');
  const auto told = [&](const char* label, const std::string& words) {
    return bullet(words, screen.width, indent + label);
  };
  std::string text = fmt::format("{}  {}  {}\n", verdict_cell(record.verdict, screen),
                                 one_line(record.case_name), configuration_text(record));
  text += told("", record.error);
  for (const Judgement& check : record.checks) {
    if (!is_bad(check.verdict)) continue;
    text += told("", check_sentence(check));
    text += told("  worst at: ", check.worst);
    text += told("  why this tolerance: ", check.claim.reason);
    if (check.band) text += told("  cause of the band: ", check.cause);
  }
  for (const std::string& note : record.notes) text += told("note: ", note);
  // Whole on one line, to be copied.
  text += indent + "again: " + (rerun.empty() ? rerun_command(record) : one_line(rerun)) + "\n";
  return text;
}

}  // namespace stiction
