// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/judge/show_expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace stiction {

namespace {

constexpr double kFactor = 3.0;

// What the records measured of one row.
struct Measured {
  std::vector<double> values;
  bool met = false;                         // by a check of each record
  bool holds = false;                       // a check meets its claim
  bool inside = true;                       // all values are in the band
  double low = INFINITY, high = -INFINITY;  // of the values
  double claim = 0.0;
};

bool holds(const Judgement& check) { return check.of_tolerance <= 1.0; }

// Two significant digits, rounded away from the band's inside.
double rounded(double value, bool up) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
  const double units = value / unit;
  const double whole = up ? std::ceil(units - 1e-9) : std::floor(units + 1e-9);
  return std::stod(fmt::format("{:.2g}", whole * unit));
}

// A factor about how far the values are from what the claim says.
Band about(double low, double high, double claim) {
  const double least = low - claim, most = high - claim;
  return {claim + rounded(least > 0.0 ? least / kFactor : least * kFactor, false),
          claim + rounded(most > 0.0 ? most * kFactor : most / kFactor, true)};
}

std::string number(double value) {
  if (std::isnan(value)) return "kNaN";
  if (std::isinf(value)) return value > 0.0 ? "kInfinity" : "-kInfinity";
  return fmt::format("{:.6g}", value);
}

std::string row_text(const std::string& cases, const std::string& variant,
                     const std::string& quantity, const Band& band, Verdict verdict,
                     const std::string& cause, const std::string& width) {
  return fmt::format("    {{\"{}\", \"{}\", \"{}\", {{{}, {}}}, {}, {}, {}}},", cases, variant,
                     quantity, number(band.low), number(band.high),
                     verdict == Verdict::kRefuted ? "kRefuted" : "kShortfall", cause, width);
}

std::string row_text(const Expectation& row) {
  return row_text(row.cases, row.variant, row.quantity, row.band, row.verdict, row.cause.name,
                  row.width.name);
}

std::string values_text(const Measured& measured) {
  if (measured.low == measured.high) return fmt::format("{:.6g}", measured.low);
  return fmt::format("{:.6g} … {:.6g} in {} runs", measured.low, measured.high,
                     measured.values.size());
}

// Nothing when no record is of the row's case and variant.
std::vector<const Record*> records_of(const std::vector<Record>& records, const Expectation& row) {
  std::vector<const Record*> found;
  for (const Record& record : records) {
    if (record.variant.empty() || record.verdict == Verdict::kError) continue;
    if (!expectations_of({row}, record.case_name, record.variant).empty()) {
      found.push_back(&record);
    }
  }
  return found;
}

Measured measure(const std::vector<const Record*>& records, const Expectation& row) {
  Measured measured;
  measured.met = true;
  for (const Record* record : records) {
    bool met = false;
    for (const Judgement& check : record->checks) {
      if (check.claim.quantity != row.quantity) continue;
      met = true;
      measured.values.push_back(check.value);
      measured.claim = check.claim.expected;
      measured.low = std::min(measured.low, check.value);
      measured.high = std::max(measured.high, check.value);
      measured.holds = measured.holds || holds(check);
      measured.inside =
          measured.inside && check.value >= row.band.low && check.value <= row.band.high;
    }
    measured.met = measured.met && met;
  }
  return measured;
}

std::string shown(const Expectation& row, const Measured& measured) {
  if (!measured.met) return row_text(row) + "  // meets no check: remove it\n";
  const std::string values = values_text(measured);
  if (measured.holds) return row_text(row) + "  // holds now, " + values + ": remove it\n";
  if (measured.inside) return row_text(row) + "  // inside: " + values + "\n";
  Expectation anew = row;
  anew.band = about(measured.low, measured.high, measured.claim);
  return fmt::format("{}  // OUTSIDE [{}, {}]: {}; width {} does not say so\n",
                     row_text(row.cases, row.variant, row.quantity, anew.band, row.verdict,
                              row.cause.name, "kFactorThree"),
                     number(row.band.low), number(row.band.high), values, row.width.name);
}

}  // namespace

std::string show_expectations(const std::vector<Record>& records, const EngineKind& engine) {
  std::string rows, failures;
  std::size_t elsewhere = 0, own = 0;
  std::vector<Record> of_engine;
  std::copy_if(records.begin(), records.end(), std::back_inserter(of_engine),
               [&](const Record& record) { return record.engine == engine.name; });
  for (const Expectation& row : engine.expectations) {
    const std::vector<const Record*> matching = records_of(of_engine, row);
    elsewhere += matching.empty();
    if (!matching.empty()) rows += shown(row, measure(matching, row));
  }
  for (const Record& record : of_engine) {
    own += record.variant.empty();
    if (record.variant.empty()) continue;
    const Expectations of_run =
        expectations_of(engine.expectations, record.case_name, record.variant);
    for (const Judgement& check : record.checks) {
      if (check.verdict == Verdict::kForInformation || check.verdict == Verdict::kNotApplicable)
        continue;
      if (holds(check) || find_expectation(of_run, check.claim.quantity)) continue;
      failures += fmt::format("{}  // fails without an expectation: {:.6g}\n",
                              row_text(record.case_name, record.variant, check.claim.quantity,
                                       about(check.value, check.value, check.claim.expected),
                                       Verdict::kShortfall, "kUnknown", "kFactorThree"),
                              check.value);
    }
  }
  std::string text = rows + failures;
  text += fmt::format("// {} rows are of cases that did not run", elsewhere);
  if (own > 0) text += fmt::format("; {} records of settings of one's own are left out", own);
  return text + "\n";
}

}  // namespace stiction
