// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/markdown.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <sstream>

#include "reports/formats/markdown_family.h"
#include "reports/formats/summary.h"
#include "reports/text/check_text.h"
#include "reports/text/family.h"
#include "reports/text/markdown_text.h"
#include "reports/text/number.h"
#include "reports/text/tally.h"

namespace stiction {
namespace {

bool needs_attention(const Record& record) {
  return record.verdict == Verdict::kFail || record.verdict == Verdict::kError;
}

// Indented, so that nothing in the text can end it.
std::string code_block(const std::string& text) {
  std::istringstream lines(text);
  std::string block;
  for (std::string line; std::getline(lines, line);) {
    block += line.empty() ? "\n" : "    " + line + "\n";
  }
  return block;
}

std::string environment_table(const std::vector<Record>& records) {
  std::set<std::string> revisions, toolchains, machines, dates;
  for (const Record& record : records) {
    revisions.insert(record.environment.revision);
    toolchains.insert(record.environment.toolchain);
    machines.insert(record.environment.machine);
    dates.insert(record.environment.date);
  }
  if (records.empty()) return "";
  // ISO 8601 sorts by time, so the first and the last span the run.
  const std::string first = markdown_escaped(*dates.begin());
  const std::string last = markdown_escaped(*dates.rbegin());
  MarkdownTable table({{"environment"}, {"value"}});
  table.add_row({"revision", markdown_joined(revisions)});
  table.add_row({"toolchain", markdown_joined(toolchains)});
  table.add_row({"machine", markdown_joined(machines)});
  table.add_row({"date (UTC)", first == last ? first : first + " to " + last});
  return table.text();
}

std::string overview(const std::vector<Family>& families) {
  MarkdownTable table({{"family"},
                       {"pass", kRight},
                       {"fail", kRight},
                       {"expected shortfall", kRight},
                       {"refuted", kRight},
                       {"error", kRight},
                       {"not applicable", kRight},
                       {"for information", kRight},
                       {"fewest digits", kRight},
                       {"CPU s", kRight}});
  for (const Family& family : families) {
    Tally tally;
    std::optional<double> fewest;
    for (const Record* record : family.records) {
      tally.add(*record);
      const std::optional<double> digits = fewest_digits(*record);
      if (digits && !(fewest && *digits >= *fewest)) fewest = digits;  // NaN is fewest
    }
    const auto count = [](std::size_t n) { return n == 0 ? std::string() : std::to_string(n); };
    table.add_row({markdown_escaped(family.name), count(tally.pass), count(tally.fail),
                   count(tally.shortfall), count(tally.refuted), count(tally.error),
                   count(tally.not_applicable), count(tally.information),
                   fewest ? format_digits(*fewest) : std::string(),
                   format_seconds(tally.cpu_seconds)});
  }
  return table.text();
}

std::string attention(const Record& record) {
  std::string text = fmt::format("### {}: {}\n\n", markdown_verdict(record.verdict),
                                 markdown_escaped(record.case_name));
  std::map<std::string, std::string> settings = record.settings;
  settings.emplace("engine", record.engine);
  text += fmt::format("{}{}({})\n\n", markdown_escaped(record.title),
                      record.title.empty() ? "" : " ", markdown_escaped(settings_text(settings)));
  if (!record.error.empty())
    text += fmt::format("- What went wrong: {}\n", markdown_escaped(record.error));
  for (const Judgement& check : record.checks) {
    if (check.verdict != Verdict::kFail && check.verdict != Verdict::kError) continue;
    text += fmt::format("- {}\n", markdown_escaped(check_sentence(check)));
    const auto item = [&](const char* name, const std::string& content) {
      if (!content.empty()) text += fmt::format("  - {}: {}\n", name, markdown_escaped(content));
    };
    item("Claim", check.claim.statement);
    item("Worst offender", check.worst);
    item("Why this tolerance", check.claim.reason);
    if (check.band) item("Cause of the band", check.cause);
  }
  for (const std::string& note : record.notes) {
    text += fmt::format("- Note: {}\n", markdown_escaped(note));
  }
  return text + "\n";
}

constexpr const char* kHowToRead =
    "## How to read this\n\n"
    "- **error** is measured − expected, or with \"rel\" behind it the same divided by a stated "
    "scale; a check passes when its size is at most the **tolerance**.\n"
    "- **of tolerance** is the size of the error divided by the tolerance: a check holds up to "
    "100 %.\n"
    "- **digits** are those that agree with the expected value, −log10 of the error over the size "
    "of the quantity, at most 16. Where zero is expected and the case names no size there are "
    "none: how near zero is near is for the tolerance to say. A family's are the fewest of its "
    "checks that pass or fail.\n"
    "- **Reference**: *analytic*: a closed form; *exact-computed*: computed in exact or much more "
    "precise arithmetic; *self-converged*: the limit of this program's own refinement; *external*: "
    "published or measured elsewhere; *golden*: an earlier result of this program, which proves "
    "sameness and not truth.\n"
    "- *expected shortfall*: the claim does not hold, but the value lies in a band that was stated "
    "beforehand "
    "with its measured cause. *refuted*: likewise, and the claim is one of the paper, tested and "
    "found not to hold. Neither makes the run fail; a value outside its band does, on either side: "
    "a better one means that the band has to be drawn anew.\n"
    "- *for information*: reported beside the verdicts, deciding none; *not applicable* means that "
    "the "
    "engine cannot do what the case asks.\n"
    "- A CPU time counts the engine's steps. Nanoseconds are wall-clock times of a step over its "
    "contacts, median and quartiles over the steps that were timed, other cases running beside it; "
    "contact phases are normal force and friction. Equal state hashes mean bit-identical end "
    "states.\n";

}  // namespace

std::string markdown_report(const std::vector<Record>& records, const std::string& title) {
  const Tally tally = tally_of(records);
  const std::vector<Family> families = families_of(records);
  std::string report = fmt::format("# {}\n\n**{}** of {} records. {}.\n\n", markdown_escaped(title),
                                   verdicts_text(tally), tally.records(), cost_text(tally));
  if (!records.empty()) report += code_block(summary_screen(records, {.width = 100})) + "\n";
  report += environment_table(records);
  if (tally.fail + tally.error > 0) {
    report += "## What failed\n\n";
    for (const Family& family : families) {
      for (const Record* record : family.records) {
        if (needs_attention(*record)) report += attention(*record);
      }
    }
  }
  if (!families.empty()) report += "## Overview\n\n" + overview(families);
  for (const Family& family : families) report += markdown_family(family);
  return report + kHowToRead;
}

}  // namespace stiction
