// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "reports/text/check_text.h"
#include "reports/text/family.h"
#include "reports/text/number.h"
#include "reports/text/tally.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

// Text for an attribute or an element. Line breaks, which one_line would turn to spaces, are the
// caller's to add.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : one_line(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&apos;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

// JUnit's readers take plain decimals only.
std::string time_text(double seconds) {
  return fmt::format("{:.6f}", seconds > 0.0 ? seconds : 0.0);
}

std::string counts(const Tally& tally) {
  return fmt::format(R"(tests="{}" failures="{}" errors="{}" skipped="{}" time="{}")",
                     tally.records(), tally.fail, tally.error,
                     tally.not_applicable + tally.shortfall + tally.refuted,
                     time_text(tally.cpu_seconds));
}

std::string notes_lines(const Record& record) {
  std::string text;
  for (const std::string& note : record.notes) text += "note: " + escaped(note) + "\n";
  return text;
}

std::string failure(const Record& record) {
  const Judgement* worst = worst_check(record.checks);
  if (worst == nullptr) return "      <failure message=\"no check decides\" type=\"fail\"/>\n";
  std::string text = fmt::format("      <failure message=\"{}\" type=\"fail\">claim: {}\n",
                                 escaped(check_sentence(*worst)), escaped(worst->claim.statement));
  text += "tolerance: " + escaped(worst->claim.reason) + "\n";
  if (worst->band) text += "cause of the band: " + escaped(worst->cause) + "\n";
  if (!worst->worst.empty()) text += "worst offender: " + escaped(worst->worst) + "\n";
  return text + notes_lines(record) + "</failure>\n";
}

std::string outcome(const Record& record) {
  switch (record.verdict) {
    case Verdict::kFail:
      return failure(record);
    case Verdict::kError:
      return fmt::format("      <error message=\"{}\" type=\"error\"/>\n", escaped(record.error));
    case Verdict::kNotApplicable:
      return fmt::format("      <skipped message=\"{}\"/>\n",
                         record.notes.empty() ? "not applicable" : escaped(record.notes.front()));
    case Verdict::kShortfall:
    case Verdict::kRefuted: {
      const Judgement* worst = worst_check(record.checks);
      if (worst == nullptr) return "      <skipped message=\"no check decides\"/>\n";
      return fmt::format(
          "      <skipped message=\"{}{}: {}\"/>\n",
          record.verdict == Verdict::kShortfall ? "falls short" : "a claim of the paper is refuted",
          escaped(band_text(*worst)), escaped(worst->cause));
    }
    case Verdict::kPass:
    case Verdict::kForInformation:
      break;
  }
  return "";
}

std::string system_out(const Record& record) {
  std::string text = "      <system-out>" + escaped(record.title) + "\n";
  for (const Judgement& check : record.checks) {
    text += fmt::format("{}: {}\n", to_string(check.verdict), escaped(check_sentence(check)));
  }
  text += notes_lines(record);
  return text + fmt::format("CPU {} s, {} steps, {} contact updates, state hash {}</system-out>\n",
                            format_seconds(record.cost.cpu_seconds), record.cost.steps,
                            record.cost.contact_updates,
                            record.state_hash.empty() ? "none" : escaped(record.state_hash));
}

std::string testcase(const Family& family, const Record& record) {
  // CI servers take dots in a class name for levels of a tree.
  std::string class_name = family.name;
  std::replace(class_name.begin(), class_name.end(), '/', '.');
  return fmt::format(
      "    <testcase classname=\"{}\" name=\"{}\" time=\"{}\">\n{}{}    </testcase>\n",
      escaped(class_name), escaped(family.label(record)), time_text(record.cost.cpu_seconds),
      outcome(record), system_out(record));
}

std::string property(std::string_view name, const std::string& value) {
  return fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", escaped(name), escaped(value));
}

std::string testsuite(const Family& family) {
  Tally tally;
  for (const Record* record : family.records) tally.add(*record);
  const Environment& environment = family.records.front()->environment;
  std::string text = fmt::format("  <testsuite name=\"{}\" {}>\n    <properties>\n",
                                 escaped(family.name), counts(tally));
  text += property("revision", environment.revision) +
          property("toolchain", environment.toolchain) + property("machine", environment.machine) +
          property("date", environment.date);
  for (const auto& [name, value] : family.common_settings) text += property(name, value);
  text += "    </properties>\n";
  for (const Record* record : family.records) text += testcase(family, *record);
  return text + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const std::vector<Record>& records) {
  std::string xml =
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"stiction\" {}>\n",
                  counts(tally_of(records)));
  for (const Family& family : families_of(records)) xml += testsuite(family);
  return xml + "</testsuites>\n";
}

}  // namespace stiction
