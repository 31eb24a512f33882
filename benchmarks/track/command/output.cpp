// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/command/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/text/text.h"

namespace stiction::track {

namespace {

using nlohmann::json;

bool is_time(const Comparison& one) {
  return one.metric.kind == Kind::kTime || one.metric.kind == Kind::kOther;
}

bool interesting(const Comparison& one) {
  return one.change != Change::kSame || one.refuted || is_time(one) ||
         one.metric.what == "instructions";
}

const char* word(Change change) {
  switch (change) {
    case Change::kWorse:
      return "worse";
    case Change::kBetter:
      return "better";
    case Change::kSame:
      break;
  }
  return "same";
}

std::string value_text(const Metric& metric, double value) {
  static constexpr const char* kVerdicts[] = {"holds", "falls short as expected", "fails",
                                              "broke off"};
  switch (metric.kind) {
    case Kind::kTime:
    case Kind::kOther:
      return fmt::format("{:.2f} ns", value * 1e9);
    case Kind::kCount:
      return fmt::format("{:.6g}", value);
    case Kind::kDigits:
      return fmt::format("{:.2f} digits", value);
    case Kind::kVerdict:
      return kVerdicts[std::clamp(static_cast<int>(value), 0, 3)];
  }
  return "";
}

std::string change_text(const Comparison& one) {
  switch (one.metric.kind) {
    case Kind::kDigits:
      return fmt::format("{:+.2f} digits", one.after - one.before);
    case Kind::kVerdict:
      return "";
    default:
      break;
  }
  if (one.before == 0.0) return one.after == 0.0 ? "+0.0 %" : "from 0";
  return fmt::format("{:+.1f} %", 100.0 * (one.ratio() - 1.0));
}

// Why it was decided so; of times alone, the others are exact.
std::string evidence(const Comparison& one) {
  if (!is_time(one)) return one.change == Change::kSame ? "" : "deterministic";
  std::string text =
      fmt::format("{:+.1f} … {:+.1f} %, p = {:.2g}, noise ±{:.1f} %", 100.0 * (one.low - 1.0),
                  100.0 * (one.high - 1.0), one.p, 100.0 * std::expm1(one.floor));
  if (one.refuted) text += ", not found again";
  return text;
}

std::string direction(const Metric& metric) {
  return higher_is_better(metric.kind) ? "higher is better" : "lower is better";
}

int count(const Outcome& outcome, Change change) {
  return static_cast<int>(
      std::count_if(outcome.comparisons.begin(), outcome.comparisons.end(),
                    [&](const Comparison& one) { return one.change == change; }));
}

double largest_noise(const Outcome& outcome) {
  double largest = 0.0;
  for (const Comparison& one : outcome.comparisons) largest = std::max(largest, one.floor);
  return largest;
}

// "worse  friction:secant/slab/contacts:1000#time  35.21 ns → 38.02 ns, +8.0 %", on two lines where
// one does not hold it.
std::string changed_line(const Comparison& one, const Screen& screen) {
  const std::string change = change_text(one);
  const std::string figures =
      fmt::format("{} → {}{}{}", value_text(one.metric, one.before),
                  value_text(one.metric, one.after), change.empty() ? "" : ", ", change);
  const std::string name = fmt::format("{:<7}{}", word(one.change), one.metric.name());
  const bool fits = display_width(name) + 2 + display_width(figures) <= screen.width;
  const std::string line = name + (fits ? "  " : "\n       ") + figures;
  return (one.change == Change::kWorse ? bold(line, screen) : line) + "\n";
}

// What measures the metric again: its case, or its benchmark against the same revision.
std::string rerun_command(const Metric& metric, const StoredRun& before) {
  const bool of_case =
      metric.kind == Kind::kVerdict ||
      (metric.kind == Kind::kDigits && metric.subject.find("/contacts:") == std::string::npos);
  if (of_case) {
    const std::string name = metric.subject.substr(0, metric.subject.find('@'));
    return fmt::format("./stiction validate --case '{}'", name);
  }
  return fmt::format("./stiction track --against {} --benchmark '{}'", before.label,
                     metric.subject);
}

// "Time per contact, 12 benchmarks: −0.8 to +1.2 %, …": the changes that are none.
std::string times_text(const Outcome& outcome) {
  double least = 0.0, most = 0.0;
  int count = 0;
  for (const Comparison& one : outcome.comparisons) {
    if (!is_time(one) || one.change != Change::kSame) continue;
    const double percent = 100.0 * (one.ratio() - 1.0);
    least = count == 0 ? percent : std::min(least, percent);
    most = count == 0 ? percent : std::max(most, percent);
    ++count;
  }
  if (count == 0) return "";
  return fmt::format(
      "{} times differ by {:+.1f} to {:+.1f} %, which is noise, or too little to be called "
      "a change.",
      count, least, most);
}

std::string escaped(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return text;
}

}  // namespace

std::string closing_sentence(const Outcome& outcome) {
  const int worse = count(outcome, Change::kWorse), better = count(outcome, Change::kBetter);
  std::string text =
      fmt::format("{} ({}) → {} ({}): {}, {} better, of {} metrics", outcome.before.label,
                  outcome.before.revision, outcome.after.label, outcome.after.revision,
                  worse == 0 ? std::string("nothing is worse") : fmt::format("{} worse", worse),
                  better, outcome.comparisons.size());
  if (outcome.cases > 0) {
    text += fmt::format("; {} of {} cases equal to the last bit", outcome.bit_equal, outcome.cases);
  }
  const double noise = largest_noise(outcome);
  if (noise > 0.0) {
    text += fmt::format("; changes in time below {:.1f} % are not called one",
                        100.0 * std::expm1(noise));
  }
  return text + ".";
}

std::string table(const Outcome& outcome, bool all) {
  std::size_t width = 6;
  for (const Comparison& one : outcome.comparisons) {
    if (all || interesting(one)) width = std::max(width, one.metric.name().size());
  }
  std::string text = fmt::format("{:<7}{:<{}}  {:>14} {:>14} {:>13}  {}\n", "", "metric", width,
                                 "before", "after", "change", "95 %, evidence");
  for (const Comparison& one : outcome.comparisons) {
    if (!all && !interesting(one)) continue;
    text += fmt::format("{:<7}{:<{}}  {:>14} {:>14} {:>13}  {}\n", word(one.change),
                        one.metric.name(), width, value_text(one.metric, one.before),
                        value_text(one.metric, one.after), change_text(one), evidence(one));
  }
  for (const std::string& name : outcome.disappeared) text += "gone   " + name + "\n";
  for (const std::string& name : outcome.appeared) text += "new    " + name + "\n";
  return text + closing_sentence(outcome) + "\n";
}

std::string summary(const Outcome& outcome, bool recorded, const Screen& screen) {
  std::string text = bullet(closing_sentence(outcome), screen.width, "") + "\n";
  for (const Comparison& one : outcome.comparisons) {
    if (one.change == Change::kSame) continue;
    text += changed_line(one, screen);
    const std::string why = evidence(one);
    if (!why.empty()) text += bullet(why, screen.width, "       ");
    if (one.change == Change::kWorse) {
      text += "       again: " + rerun_command(one.metric, outcome.before) + "\n";
    }
  }
  for (const std::string& name : outcome.disappeared) text += "gone   " + name + "\n";
  for (const std::string& name : outcome.appeared) text += "new    " + name + "\n";
  const std::string times = times_text(outcome);
  if (!times.empty()) text += bullet(times, screen.width);
  std::vector<std::string> refuted;
  for (const Comparison& one : outcome.comparisons) {
    if (one.refuted) refuted.push_back(one.metric.name());
  }
  if (!refuted.empty()) {
    text +=
        bullet(fmt::format("A first run said otherwise of {}, a second one did not find it again.",
                           fmt::join(refuted, ", ")),
               screen.width);
  }
  text += recorded ? fmt::format(
                         "\nEvery metric: ./stiction track compare {} {} --all (here: --verbose)\n",
                         outcome.before.id, outcome.after.id)
                   : "\nTimes and counts that did not change: --verbose; every metric: --all\n";
  return text;
}

std::string markdown(const Outcome& outcome, bool all) {
  std::string text = fmt::format(
      "**{}**\n\n| | metric | before | after | change | better is | evidence |\n"
      "|---|---|--:|--:|--:|---|---|\n",
      closing_sentence(outcome));
  for (const Comparison& one : outcome.comparisons) {
    if (!all && !interesting(one)) continue;
    text += fmt::format("| {} | `{}` | {} | {} | {} | {} | {} |\n", word(one.change),
                        escaped(one.metric.name()), value_text(one.metric, one.before),
                        value_text(one.metric, one.after), change_text(one),
                        higher_is_better(one.metric.kind) ? "higher" : "lower", evidence(one));
  }
  for (const std::string& name : outcome.disappeared) {
    text += fmt::format("| gone | `{}` | | | | | |\n", escaped(name));
  }
  for (const std::string& name : outcome.appeared) {
    text += fmt::format("| new | `{}` | | | | | |\n", escaped(name));
  }
  return text + fmt::format("\nMachine: {}\n", outcome.after.machine.text());
}

std::string json_text(const Outcome& outcome) {
  const auto side = [](const StoredRun& run) {
    return json{{"label", run.label},
                {"revision", run.revision},
                {"date", run.date},
                {"machine", run.machine.text()}};
  };
  json comparisons = json::array();
  for (const Comparison& one : outcome.comparisons) {
    json entry = {{"metric", one.metric.name()}, {"kind", to_string(one.metric.kind)},
                  {"unit", one.metric.unit},     {"direction", direction(one.metric)},
                  {"change", word(one.change)},  {"before", one.before},
                  {"after", one.after}};
    if (is_time(one)) {
      entry["ratio"] = one.ratio();
      entry["ratio_95"] = {one.low, one.high};
      entry["p"] = one.p;
      entry["noise_floor"] = std::expm1(one.floor);
      entry["refuted"] = one.refuted;
    }
    comparisons.push_back(std::move(entry));
  }
  const json all = {{"before", side(outcome.before)},
                    {"after", side(outcome.after)},
                    {"sentence", closing_sentence(outcome)},
                    {"worse", count(outcome, Change::kWorse)},
                    {"better", count(outcome, Change::kBetter)},
                    {"cases", outcome.cases},
                    {"bit_equal", outcome.bit_equal},
                    {"comparisons", std::move(comparisons)},
                    {"disappeared", outcome.disappeared},
                    {"appeared", outcome.appeared}};
  return all.dump(1) + "\n";
}

}  // namespace stiction::track
