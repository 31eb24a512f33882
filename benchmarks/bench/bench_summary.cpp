// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/bench_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "reports/text/number.h"
#include "solver/options.h"

namespace stiction::bench {

namespace {

// What is told of a family: parts whose times add up.
struct Told {
  const char* words;
  std::vector<std::string> parts;
  std::string scaling;  // as scalings() names the sum
};

const std::vector<Told>& told() {
  static const std::string friction = std::string("friction:") + kTimedRule;
  static const std::vector<Told> all = {
      {"detection and depth", {"detect", "depth"}, "detect + depth"},
      {"normal force and friction", {"normal-force", friction}, "normal-force + " + friction},
      {"whole step", {"step"}, "step"},
  };
  return all;
}

// ns per contact of the sum; nothing when a part was not measured. What is one-sided has no depth.
std::optional<double> cost(const std::vector<Result>& results, const std::string& family, int size,
                           const Told& what) {
  double sum = 0.0;
  for (const std::string& part : what.parts) {
    const auto at = std::find_if(results.begin(), results.end(), [&](const Result& one) {
      return one.chosen.family.name == family && one.chosen.size == size &&
             one.chosen.timed.name == part;
    });
    if (at != results.end()) {
      sum += 1e9 * at->seconds / at->contacts;
    } else if (part != "depth") {
      return {};
    }
  }
  return sum;
}

std::string exponent(const std::vector<Scaling>& fits, const std::string& family,
                     const Told& what) {
  for (const std::string& name : {what.scaling, what.parts.front()}) {
    for (const Scaling& fit : fits) {
      if (fit.family == family && fit.part == name) {
        return fmt::format("{:.2f} ± {:.2f}", fit.law.exponent, fit.law.exponent_margin);
      }
    }
  }
  return "–";
}

// "55", or "55–480" where it has changed by half.
std::string range_text(double one, double other, int places) {
  const auto [least, most] = std::minmax(one, other);
  std::string text = fmt::format("{:.{}f}", least, places);
  if (most > 1.5 * least) text += fmt::format("–{:.{}f}", most, places);
  return text;
}

// How much faster threads do a whole step, and what their processors were to each other; none where that was not
// measured.
Cells speed_up_rows(const std::vector<Result>& results, const std::string& family,
                    const std::set<int>& sizes) {
  std::vector<std::string> row = {""}, arithmetic = {"           × faster, arithmetic"},
                           answers = {"           ns for an answer, core to core"};
  for (const int size : sizes) {
    row.emplace_back("–");
    arithmetic.emplace_back("–");
    answers.emplace_back("–");
    for (const Result& one : results) {
      if (one.chosen.family.name != family || one.chosen.size != size ||
          !one.chosen.timed.whole_step || !one.speed_up) {
        continue;
      }
      row.front() = fmt::format("  {:<6}… {} threads, × faster", family, one.speed_up->threads);
      row.back() = fmt::format("{:.2f}", one.speed_up->ratio.median);
      const auto& [before, after] = one.speed_up->together;
      arithmetic.back() = range_text(before.arithmetic, after.arithmetic, 2);
      answers.back() = range_text(1e9 * before.answer_seconds, 1e9 * after.answer_seconds, 0);
    }
  }
  if (row.front().empty()) return {};
  row.emplace_back("");
  arithmetic.emplace_back("");
  answers.emplace_back("");
  return {std::move(row), std::move(arithmetic), std::move(answers)};
}

std::vector<std::string> families_of(const std::vector<Result>& results) {
  std::vector<std::string> families;
  for (const Result& one : results) {
    const std::string& name = one.chosen.family.name;
    if (std::find(families.begin(), families.end(), name) == families.end())
      families.push_back(name);
  }
  return families;
}

Cells cost_table(const std::vector<Result>& results, const std::vector<Scaling>& fits) {
  std::set<int> sizes;
  for (const Result& one : results) sizes.insert(one.chosen.size);
  Cells rows = {{"ns a contact, of contacts:"}};
  for (const int size : sizes)
    rows.front().push_back(spaced_count(static_cast<std::uint64_t>(size)));
  rows.front().push_back("∝ contactsᵖ, p");
  for (const std::string& family : families_of(results)) {
    for (const Told& what : told()) {
      std::vector<std::string> row = {fmt::format("  {:<6}{}", family, what.words)};
      bool measured = false;
      for (const int size : sizes) {
        const std::optional<double> value = cost(results, family, size, what);
        row.push_back(value ? format_nanoseconds(*value) : "–");
        measured = measured || value;
      }
      row.push_back(exponent(fits, family, what));
      if (measured) rows.push_back(std::move(row));
    }
    for (std::vector<std::string>& row : speed_up_rows(results, family, sizes)) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

// Every rule at the first family and size that has more than one.
std::string rules_text(const std::vector<Result>& results, std::size_t width) {
  std::string family;
  int size = 0;
  std::vector<const Result*> rules;
  for (const Result& one : results) {
    if (one.chosen.timed.name.rfind("friction:", 0) != 0) continue;
    // 1000 contacts, where there are such.
    if (one.chosen.size != 1000 && !rules.empty() && size == 1000) continue;
    if (rules.empty() || (size != 1000 && one.chosen.size == 1000)) {
      family = one.chosen.family.name;
      size = one.chosen.size;
      rules.clear();
    }
    if (one.chosen.family.name == family && one.chosen.size == size) rules.push_back(&one);
  }
  if (rules.size() < 2) return "";
  std::sort(rules.begin(), rules.end(),
            [](const Result* a, const Result* b) { return a->seconds < b->seconds; });
  std::string text;
  for (const Result* one : rules) {
    text += fmt::format("{}{} {} ({})", text.empty() ? "" : ", ",
                        one->chosen.timed.name.substr(std::string("friction:").size()),
                        format_nanoseconds(1e9 * one->seconds / one->contacts),
                        format_error(one->error));
  }
  return bullet(fmt::format("Friction, {}, {} contacts, ns a contact (error it leaves): {}.",
                            family, spaced_count(static_cast<std::uint64_t>(size)), text),
                width);
}

std::string features_text(const std::vector<FeatureCost>& features, std::size_t width) {
  if (features.empty()) return "";
  const auto change = [](const FeatureCost& one) {
    return 100.0 * (one.unused / one.without - 1.0);
  };
  const auto [least, most] =
      std::minmax_element(features.begin(), features.end(),
                          [&](const auto& a, const auto& b) { return change(a) < change(b); });
  return bullet(fmt::format("{} optional features, unused: {:+.1f} to {:+.1f} % of a step's "
                            "instructions (dearest: {}).",
                            features.size(), change(*least), change(*most), most->title),
                width);
}

std::string failures_text(const std::vector<Record>& records, const Screen& screen) {
  std::string text;
  double worst = 0.0;
  std::size_t at_rest = 0, workloads = 0;
  for (const Record& record : records) {
    const bool is_workload = record.case_name.find("/contacts=") != std::string::npos;
    workloads += is_workload;
    at_rest += is_workload && record.verdict != Verdict::kFail;
    for (const Judgement& check : record.checks) {
      if (is_workload)
        worst =
            std::max(worst, std::abs(check.value - check.claim.expected) / check.claim.tolerance);
      if (check.verdict != Verdict::kFail) continue;
      text += bullet(fmt::format("{}: {} is {:.3g}, not {:.3g} ± {:.3g} {}", record.case_name,
                                 check.claim.quantity, check.value, check.claim.expected,
                                 check.claim.tolerance, check.worst),
                     screen.width, bold("FAIL", screen) + " ");
      std::string family = record.case_name.substr(record.case_name.find('/') + 1);
      family = family.substr(0, family.find('/'));
      text += family == "features"
                  ? std::string("     again: ./stiction bench\n")
                  : fmt::format("     again: ./stiction bench --benchmark_filter='/{}/'\n", family);
    }
  }
  if (workloads == 0) return text;
  return bullet(
             fmt::format("{} of {} workloads at rest before they were timed, worst at {:.0f} % of "
                         "what is let pass.",
                         at_rest, workloads, 100.0 * worst),
             screen.width) +
         text;
}

}  // namespace

std::string bench_summary(const std::vector<Result>& results, const std::vector<Scaling>& fits,
                          const std::vector<FeatureCost>& features,
                          const std::vector<Record>& records, const Screen& screen) {
  const Cells costs = cost_table(results, fits);
  std::string text;
  if (costs.size() > 1) {
    text = plain_table(costs, {0}, screen.width);
  } else {
    Cells rows = {{"benchmark", "contacts", "ns a contact", "error"}};
    for (const Result& one : results) {
      rows.push_back({one.chosen.name, spaced_count(static_cast<std::uint64_t>(one.contacts)),
                      format_nanoseconds(1e9 * one.seconds / one.contacts),
                      format_error(one.error)});
    }
    text = plain_table(rows, {0}, screen.width);
  }
  text += "\n" + rules_text(results, screen.width) + features_text(features, screen.width);
  return text + failures_text(records, screen);
}

}  // namespace stiction::bench
