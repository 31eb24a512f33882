// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/csv.h"

#include <fmt/format.h>

#include <string_view>

#include "reports/text/check_text.h"
#include "reports/text/configuration_text.h"
#include "reports/text/number.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

constexpr std::size_t kCheckColumns = 21;
constexpr std::string_view kHeader =
    "case,title,engine,configuration,settings,case_verdict,case_error,"
    "quantity,unit,claim,formula,source,kind,value,expected,error,relative,scale,tolerance,reason,"
    "of_tolerance,digits,worst,band_low,band_high,cause,because,verdict,"
    "cpu_seconds,simulated_seconds,steps,contact_updates,ns_per_contact_update,"
    "ns_per_contact_step,state_hash,"
    "revision,toolchain,machine,date";

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string words(std::string_view raw) { return csv_words(raw); }

std::string optional(const std::optional<double>& value) {
  return value ? format_exact(*value) : std::string();
}

std::string row(const std::vector<std::string>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ',';
    text += cell(values[i]);
  }
  return text;
}

std::string case_cells(const Record& record) {
  return row({words(record.case_name), words(record.title), words(record.engine),
              words(configuration_text(record)), words(settings_text(record.settings)),
              to_string(record.verdict), words(record.error)});
}

std::string check_cells(const Judgement& check) {
  return row({words(check.claim.quantity),
              words(check.claim.unit),
              words(check.claim.statement),
              words(check.claim.formula),
              words(check.claim.source),
              to_string(check.claim.kind),
              format_exact(check.value),
              format_exact(check.claim.expected),
              format_exact(check.error),
              check.claim.relative ? "true" : "false",
              optional(check.claim.scale),
              format_exact(check.claim.tolerance),
              words(check.claim.reason),
              format_exact(check.of_tolerance),
              optional(check.digits),
              words(check.worst),
              check.band ? format_exact(check.band->low) : "",
              check.band ? format_exact(check.band->high) : "",
              words(check.cause),
              words(check.because),
              to_string(check.verdict)});
}

// A figure has no claim: quantity, unit, meaning and value, in the columns of a check.
std::string figure_cells(const Figure& figure) {
  std::vector<std::string> cells(kCheckColumns);
  cells[0] = words(figure.quantity);
  cells[1] = words(figure.unit);
  cells[2] = words(figure.meaning);
  cells[6] = format_exact(figure.value);
  return row(cells);
}

std::string run_cells(const Record& record) {
  const Cost& cost = record.cost;
  const Environment& environment = record.environment;
  return row({format_exact(cost.cpu_seconds), format_exact(cost.simulated_seconds),
              std::to_string(cost.steps), std::to_string(cost.contact_updates),
              format_exact(cost.contact_phases.median), format_exact(cost.whole_step.median),
              words(record.state_hash), words(environment.revision), words(environment.toolchain),
              words(environment.machine), words(environment.date)});
}

}  // namespace

// Spreadsheets would take words that begin like a formula for one, so they are told that it is text by
// the sign that they know.
std::string csv_words(std::string_view raw) {
  const std::string text = one_line(raw);
  const std::size_t first = text.find_first_not_of(' ');
  const bool is_formula = first != std::string::npos &&
                          std::string_view("=+-@").find(text[first]) != std::string_view::npos;
  return is_formula ? "'" + text : text;
}

std::string csv_row(const std::vector<std::string>& cells) { return row(cells) + "\r\n"; }

std::string csv_table(const std::vector<Record>& records) {
  std::string table(kHeader);
  table += "\r\n";
  for (const Record& record : records) {
    const std::string before = fmt::format("{},", case_cells(record));
    const std::string after = fmt::format(",{}\r\n", run_cells(record));
    for (const Judgement& check : record.checks) table += before + check_cells(check) + after;
    for (const Figure& figure : record.figures) table += before + figure_cells(figure) + after;
    if (record.checks.empty() && record.figures.empty())
      table += before + std::string(kCheckColumns - 1, ',') + after;
  }
  return table;
}

}  // namespace stiction
