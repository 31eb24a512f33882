// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/documents/figure_value.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports/formats/summary.h"
#include "reports/formats/work_precision.h"
#include "reports/text/number.h"

namespace stiction {

namespace {

using Settings = std::map<std::string, std::string>;

// A comparison has engine and configuration among its settings; of a case they are the record's own.
std::string setting_of(const Record& record, const std::string& name) {
  const auto found = record.settings.find(name);
  if (found != record.settings.end()) return found->second;
  if (name == "engine") return record.engine;
  return name == "configuration" ? record.configuration : std::string();
}

bool has(const Record& record, const Settings& settings) {
  return std::all_of(settings.begin(), settings.end(), [&](const auto& wanted) {
    return setting_of(record, wanted.first) == wanted.second;
  });
}

std::string settings_words(const Settings& settings) {
  std::string words;
  for (const auto& [name, value] : settings) {
    words += fmt::format("{}{}={}", words.empty() ? " with " : " ", name,
                         value.empty() ? "(not set)" : value);
  }
  return words;
}

[[noreturn]] void refuse(const FigureRule& rule, const std::string& sentence) {
  throw std::runtime_error(fmt::format("{}: figure '{}': {}", rule.where, rule.name, sentence));
}

bool matches(const std::string& glob, const std::string& name) {
  return fnmatch(glob.c_str(), name.c_str(), 0) == 0;
}

// The values of a case, low = high.
std::vector<FigureValue> values_in(const FigureRule& rule, const Record& record) {
  std::vector<FigureValue> values;
  if (!rule.quantity.empty()) {
    for (const Judgement& check : record.checks) {
      if (check.claim.quantity == rule.quantity) {
        values.push_back({check.value, check.value, check.verdict});
      }
    }
    for (const Figure& figure : record.figures) {
      if (figure.quantity != rule.quantity) continue;
      values.push_back({figure.value, figure.value, Verdict::kForInformation});
    }
    // One of those that are compared broke, or lacks what the case needs: that is its answer.
    const double none = std::nan("");
    if (values.empty() && record.verdict == Verdict::kNotApplicable) {
      values.push_back({none, none, Verdict::kNotApplicable});
    } else if (values.empty() && !record.failures.empty()) {
      values.push_back({none, none, Verdict::kError});
    }
    return values;
  }
  for (const Series& series : record.series) {
    if (series.name != rule.series) continue;
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      // A size asked for is met as nearly as the mesh allows.
      if (std::abs(series.x[k] - rule.at) > 0.2 * std::abs(rule.at)) continue;
      values.push_back({series.y[k], series.y[k], Verdict::kForInformation});
    }
  }
  return values;
}

Verdict worst(const std::vector<FigureValue>& values) {
  std::vector<Judgement> checks(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) checks[k].verdict = values[k].verdict;
  return combined_verdict(checks);
}

FigureValue taken(const FigureRule& rule, Taken how, const std::vector<FigureValue>& values,
                  const std::string& of_what) {
  FigureValue all{.verdict = worst(values)};
  if (how == Taken::kCount) {
    all.low = all.high = static_cast<double>(values.size());
    return all;
  }
  if (how == Taken::kOnly) {
    if (values.size() != 1) {
      refuse(rule, fmt::format("{} {}, and the figure doesn't say which it takes", values.size(),
                               of_what));
    }
    return values.front();
  }
  const auto no_number = std::find_if(values.begin(), values.end(), [](const FigureValue& one) {
    return std::isnan(one.low) || std::isnan(one.high);
  });
  if (no_number != values.end()) {
    all.low = all.high = std::nan("");
    return all;
  }
  all.low = values.front().low;
  all.high = values.front().high;
  for (const FigureValue& one : values) {
    all.low = std::min(all.low, one.low);
    all.high = std::max(all.high, one.high);
  }
  if (how == Taken::kLeast) all.high = all.low;
  if (how == Taken::kMost) all.low = all.high;
  return all;
}

std::string number_text(double value, const FigureStyle& style) {
  if (std::isnan(value)) return style.no_number;
  for (auto word = style.above.rbegin(); word != style.above.rend(); ++word) {
    if (value > word->first) return word->second;
  }
  if (std::isinf(value)) return style.never;
  if (style.decades && value == 0.0) return "exact";
  const double shown = style.decades ? -std::log10(value) : style.times * value;
  std::string text;
  if (style.places >= 0) {
    text = fmt::format("{:.{}f}", shown, style.places);
  } else if (shown == std::floor(shown) && std::abs(shown) < 1e5) {
    text = fmt::format("{:.0f}", shown);
  } else {
    // Plain between a thousandth and 100 000, else 3e-4 rather than 3e-04.
    text = fmt::format("{:.{}e}", shown, style.digits - 1);
    const std::size_t e = text.find('e');
    const int exponent = std::stoi(text.substr(e + 1));
    if (exponent >= -3 && exponent < 5) {
      text = fmt::format("{:.{}f}", shown, std::max(0, style.digits - 1 - exponent));
    } else {
      text = fmt::format("{}e{}", text.substr(0, e), exponent);
    }
  }
  if (style.sign && shown > 0.0) text = "+" + text;
  if (!text.empty() && text.front() == '-') text = "−" + text.substr(1);
  return text + style.unit;
}

std::string ends_text(const FigureValue& value) {
  const std::string low = format_value(value.low);
  return value.low == value.high || std::isnan(value.low) ? low
                                                          : low + " to " + format_value(value.high);
}

bool agree(const FigureRule& rule, double kept, double fresh) {
  if (std::isnan(kept) || std::isnan(fresh)) return std::isnan(kept) == std::isnan(fresh);
  if (kept == fresh) return true;
  if (std::isinf(kept) || std::isinf(fresh)) return false;
  if (std::abs(kept) <= rule.floor && std::abs(fresh) <= rule.floor) return true;
  if (kept * fresh <= 0.0) return false;
  const double ratio = std::abs(fresh / kept);
  return ratio <= rule.factor && ratio >= 1.0 / rule.factor;
}

}  // namespace

bool is_of(const FigureRule& rule, const Record& record) {
  return matches(rule.case_glob, record.case_name) &&
         (rule.except.empty() || !matches(rule.except, record.case_name));
}

FigureValue value_of(const FigureRule& rule, const std::vector<Record>& records) {
  std::vector<std::pair<std::string, std::vector<FigureValue>>> cases;
  bool is_case_there = false;
  const Record* without = nullptr;  // a record of the case that lacks the quantity, and must not
  bool lacks = false;
  for (const Record& record : records) {
    if (!is_of(rule, record)) continue;
    is_case_there = true;
    if (!has(record, rule.settings)) continue;
    const std::vector<FigureValue> values = values_in(rule, record);
    if (rule.may_lack && (values.empty() || record.verdict == Verdict::kNotApplicable)) {
      lacks = true;
      continue;
    }
    if (values.empty()) {
      without = &record;
      continue;
    }
    const auto entry = std::find_if(cases.begin(), cases.end(),
                                    [&](const auto& one) { return one.first == record.case_name; });
    auto& all = entry != cases.end()
                    ? entry->second
                    : cases.emplace_back(record.case_name, std::vector<FigureValue>{}).second;
    all.insert(all.end(), values.begin(), values.end());
  }
  if (!is_case_there) refuse(rule, fmt::format("no record of a case '{}'", rule.case_glob));
  if (without != nullptr) {
    refuse(
        rule,
        rule.quantity.empty() ? fmt::format("the record of '{}' has no series '{}' at {:g}",
                                            without->case_name, rule.series, rule.at)
        : without->verdict == Verdict::kError
            ? fmt::format("the record of '{}' is an error: {}", without->case_name, without->error)
            : fmt::format("the record of '{}' has no quantity '{}'", without->case_name,
                          rule.quantity));
  }
  if (cases.empty() && lacks) {
    return {.low = std::nan(""), .high = std::nan(""), .verdict = Verdict::kNotApplicable};
  }
  if (cases.empty()) {
    refuse(rule, fmt::format("no record of '{}'{}", rule.case_glob, settings_words(rule.settings)));
  }
  std::vector<FigureValue> values;
  for (const auto& [name, all] : cases) {
    values.push_back(taken(rule, rule.within, all, fmt::format("values in the case '{}'", name)));
  }
  return taken(rule, rule.over, values, "cases");
}

std::string sample_of(const SampleRule& rule, const std::vector<std::vector<Record>>& runs) {
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    const bool is_it = std::any_of(run->begin(), run->end(), [&](const Record& record) {
      return record.case_name == rule.run_of;
    });
    if (!is_it) continue;
    if (rule.shows == Shown::kCheapestSettings) return cheapest_settings_markdown(*run);
    std::string screen = summary_screen(*run, {.width = 80});
    while (screen.ends_with("\n\n")) screen.pop_back();
    return screen;
  }
  throw std::runtime_error(fmt::format("{}: sample '{}': no run has a record of '{}'", rule.where,
                                       rule.name, rule.run_of));
}

std::string text_of(const FigureValue& value, const FigureStyle& style) {
  if (value.verdict == Verdict::kNotApplicable) return "–";
  if (value.verdict == Verdict::kError) return "broke";
  const std::string low = number_text(value.low, style), high = number_text(value.high, style);
  return low == high ? low : low + style.range + high;
}

std::string disagreement(const FigureRule& rule, const FigureValue& kept,
                         const FigureValue& fresh) {
  if (kept.verdict != fresh.verdict) {
    return fmt::format("'{}' is now {} ({}), where the documents have {} ({})", rule.name,
                       to_string(fresh.verdict), ends_text(fresh), to_string(kept.verdict),
                       ends_text(kept));
  }
  if (agree(rule, kept.low, fresh.low) && agree(rule, kept.high, fresh.high)) return {};
  return fmt::format(
      "'{}' is now {}, where the documents have {}, which is beyond a factor of {:g}", rule.name,
      ends_text(fresh), ends_text(kept), rule.factor);
}

}  // namespace stiction
