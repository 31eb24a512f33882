// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/sizes/sizes_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "reports/text/number.h"

namespace stiction::track {

namespace {

// Phases that are told as one.
struct Part {
  const char* name;
  std::vector<std::string> phases;
};

const std::vector<Part>& parts() {
  static const std::vector<Part> all = {
      {"elastic forces", {"forces"}},
      {"detection and depth", {"detect", "depth"}},
      {"normal force, friction", {"normal force", "friction"}},
      {"prediction, integration", {"predict", "integrate"}},
  };
  return all;
}

// What a step takes at least.
struct Limit {
  const char* name;
  double Yardstick::Limits::*seconds;
};

const std::vector<Limit>& limits() {
  static const std::vector<Limit> all = {
      {"least by bandwidth", &Yardstick::Limits::bandwidth},
      {"least by arithmetic", &Yardstick::Limits::arithmetic},
  };
  return all;
}

// ns a contact.
double nanoseconds(const Limit& limit, const SizeResult& result) {
  return 1e9 * result.limits.*limit.seconds / result.now().settled.contacts;
}

reference::Quartiles now_over_before(const SizeResult& result) {
  return ratio(result.now(), result.before());
}

bool is_of_one_thread(const Way& way) { return way.threads == 1; }

// How much faster threads are than one.
double gain(const SizeResult& result, std::size_t way) {
  return ratio(result.now(), result.times[way], true).median;
}

// And in those turns in which their processors were near each other.
double gain_near(const SizeResult& result, std::size_t way) {
  return ratio_near(result, result.now(), result.times[way]);
}

// What the processors were to threads: medians of the turns.
double together(const SizeResult& result, double reference::Together::*of) {
  std::vector<double> turns;
  for (const auto& [before, after] : result.together) {
    turns.push_back(before.*of);
    turns.push_back(after.*of);
  }
  return reference::median(std::move(turns));
}
double answer_seconds(const SizeResult& result) {
  return together(result, &reference::Together::answer_seconds);
}
double arithmetic_gain(const SizeResult& result) {
  return together(result, &reference::Together::arithmetic);
}

// Of two threads and more by the clock on the wall, which is what they save.
double step_of(const SizeResult& result, std::size_t way) {
  const StepTimes& times = result.times[way];
  return is_of_one_thread(result.ways[way]) ? step_nanoseconds(times) : wall_nanoseconds(times);
}

// Over the contacts of each size.
template <class Value>
Series series_of(const std::string& name, const std::string& unit,
                 const std::vector<SizeResult>& results, const Value& value) {
  Series series{name, unit, "contacts", "1", {}, {}};
  for (const SizeResult& one : results) {
    series.x.push_back(one.now().settled.contacts);
    series.y.push_back(value(one));
  }
  return series;
}

template <class Nanoseconds>
Series cost_of(const std::string& name, const std::vector<SizeResult>& results,
               const Nanoseconds& nanoseconds_of) {
  return series_of(name + " per contact", "s", results,
                   [&](const SizeResult& one) { return 1e-9 * nanoseconds_of(one); });
}

// A claim that none of something is found.
Judgement none_of(Claim claim, double count, const std::string& worst) {
  Judgement check{.claim = std::move(claim), .value = count, .worst = worst, .error = count};
  check.of_tolerance = share_of_tolerance(count, 0.0);
  check.verdict = count == 0.0 ? Verdict::kPass : Verdict::kFail;
  return check;
}

// Of one way, where it has anything to hold.
std::vector<Judgement> checks_of(std::size_t way, const std::vector<SizeResult>& results) {
  double restless = 0.0, other_states = 0.0;
  std::string worst_rest, worst_state;
  for (const SizeResult& result : results) {
    if (!result.times[way].settled.at_rest) {
      ++restless;
      worst_rest = result.workload.name();
    }
    if (!same_state(result.times[way], result.now())) {
      ++other_states;
      worst_state = result.workload.name();
    }
  }
  std::vector<Judgement> checks = {none_of({.quantity = "workloads that are not at rest",
                                            .unit = "1",
                                            .statement = "all that is timed is at rest",
                                            .source = "equilibrium",
                                            .kind = ReferenceKind::kAnalytic,
                                            .reason = "each is, or it is not, by its own checks"},
                                           restless, worst_rest)};
  if (way == 0) return checks;  // what another revision leaves is told, not judged
  checks.push_back(
      none_of({.quantity = "workloads that end in another state",
               .unit = "1",
               .statement = "the width of registers and threads inside a step don't change a bit",
               .source = "the same steps in the widest registers, by one thread",
               .kind = ReferenceKind::kExactComputed,
               .reason = "each sum has its terms in the same order"},
              other_states, worst_state));
  return checks;
}

std::string change_text(double before, double now) {
  return format_nanoseconds(before) + " → " + format_nanoseconds(now);
}

// What is told of a workload: a line of its family's.
using Told = std::pair<std::string, std::function<std::string(const SizeResult&)>>;

std::vector<Told> told(const std::vector<Way>& ways) {
  std::vector<Told> lines = {
      {"whole step",
       [](const SizeResult& one) {
         return change_text(step_nanoseconds(one.before()), step_nanoseconds(one.now()));
       }},
      {"… now ÷ before",
       [](const SizeResult& one) { return fmt::format("{:.2f}", now_over_before(one).median); }}};
  for (const Part& part : parts()) {
    lines.emplace_back(part.name, [&part](const SizeResult& one) {
      return change_text(phase_nanoseconds(one.before(), part.phases),
                         phase_nanoseconds(one.now(), part.phases));
    });
  }
  for (std::size_t k = 2; k < ways.size(); ++k) {
    const Way& way = ways[k];
    if (is_of_one_thread(way)) {
      lines.emplace_back("step, " + way.name, [k](const SizeResult& one) {
        return format_nanoseconds(step_of(one, k));
      });
    } else {
      lines.emplace_back(way.name + ", × faster", [k](const SizeResult& one) {
        return fmt::format("{:.2f}", gain(one, k));
      });
      lines.emplace_back(fmt::format("… an answer < {:.0f} ns", 1e9 * kNear),
                         [k](const SizeResult& one) {
                           const double near = gain_near(one, k);
                           return std::isnan(near) ? "–" : fmt::format("{:.2f}", near);
                         });
    }
  }
  if (!std::all_of(ways.begin(), ways.end(), is_of_one_thread)) {
    lines.emplace_back("… arithmetic, × faster", [](const SizeResult& one) {
      return fmt::format("{:.2f}", arithmetic_gain(one));
    });
    lines.emplace_back("… an answer, core to core", [](const SizeResult& one) {
      const double seconds = answer_seconds(one);
      return seconds > 0.0 ? format_nanoseconds(1e9 * seconds) + " ns" : "–";
    });
  }
  for (const Limit& limit : limits()) {
    lines.emplace_back(limit.name, [&limit](const SizeResult& one) {
      return format_nanoseconds(nanoseconds(limit, one));
    });
  }
  return lines;
}

Cells table_of(const std::vector<SizeResult>& results) {
  std::set<int> sizes;
  std::vector<std::string> families;
  for (const SizeResult& one : results) {
    sizes.insert(one.workload.contacts);
    if (families.empty() || families.back() != one.workload.family) {
      families.push_back(one.workload.family);
    }
  }
  Cells rows = {{"ns a contact, of contacts:"}};
  for (const int size : sizes)
    rows.front().push_back(spaced_count(static_cast<std::uint64_t>(size)));
  for (const std::string& family : families) {
    for (const auto& [words, text] : told(results.front().ways)) {
      std::vector<std::string>& row = rows.emplace_back();
      row.push_back(fmt::format("  {:<6}{}", family, words));
      for (const int size : sizes) {
        const auto at = std::find_if(results.begin(), results.end(), [&](const SizeResult& one) {
          return one.workload.family == family && one.workload.contacts == size;
        });
        row.push_back(at == results.end() ? "–" : text(*at));
      }
    }
  }
  return rows;
}

// Whether both revisions leave the same state to the bit, as they do unless a change was meant.
std::string states_text(const std::vector<SizeResult>& results) {
  const auto same = std::count_if(results.begin(), results.end(), [](const SizeResult& result) {
    return same_state(result.before(), result.now());
  });
  return fmt::format("Both leave the same state, to the bit, of {} of {} workloads.", same,
                     results.size());
}

// How far ratios of single turns lie apart: the quartiles' distance, of the median.
std::string spread_text(const std::vector<SizeResult>& results) {
  double most = 0.0;
  std::string of;
  for (const SizeResult& result : results) {
    const reference::Quartiles it = now_over_before(result);
    const double spread = (it.upper - it.lower) / it.median;
    if (spread >= most) of = result.workload.name();
    most = std::max(most, spread);
  }
  return fmt::format("Quartiles of now ÷ before lie at most {:.0f} % apart, those of {}.",
                     100.0 * most, of);
}

void add_phases(std::size_t way, const std::vector<SizeResult>& results, Record& record) {
  for (const Part& part : parts()) {
    record.series.push_back(cost_of(part.name, results, [&](const SizeResult& one) {
      return phase_nanoseconds(one.times[way], part.phases);
    }));
  }
}

void add_ratios(const std::vector<SizeResult>& results, Record& record) {
  record.series.push_back(
      series_of("whole step, now ÷ before", "1", results,
                [](const SizeResult& one) { return now_over_before(one).median; }));
  for (const SizeResult& one : results) {
    const reference::Quartiles it = now_over_before(one);
    record.notes.push_back(
        fmt::format("{} contacts: {:.3f} of what it took, half of the turns {:.3f} to {:.3f}",
                    spaced_count(static_cast<std::uint64_t>(one.workload.contacts)), it.median,
                    it.lower, it.upper));
  }
}

std::string range_text(const std::vector<SizeResult>& results) {
  std::vector<double> all;
  for (const SizeResult& result : results) {
    all.push_back(now_over_before(result).median);
  }
  const auto [least, most] = std::minmax_element(all.begin(), all.end());
  const std::string low = fmt::format("{:.2f}", *least), high = fmt::format("{:.2f}", *most);
  return low == high ? low : low + " to " + high;
}

}  // namespace

std::vector<Record> family_records(const std::vector<SizeResult>& results, const Tree& before,
                                   const Environment& environment) {
  const std::vector<Way>& ways = results.front().ways;
  Record blank;
  blank.case_name = "sizes/" + results.front().workload.family;
  blank.title = "cost of a step over the number of contacts";
  blank.engine = "stiction";
  blank.settings["before"] = before.revision;
  blank.environment = environment;
  std::vector<Record> records;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    Record& record = records.emplace_back(blank);
    record.configuration = ways[k].name;
    record.series.push_back(
        cost_of("whole step", results, [&](const SizeResult& one) { return step_of(one, k); }));
    if (k < 2) add_phases(k, results, record);
    if (k == 1) add_ratios(results, record);
    if (!is_of_one_thread(ways[k])) {
      record.series.push_back(series_of("times as fast as one thread", "1", results,
                                        [&](const SizeResult& one) { return gain(one, k); }));
      Series near = series_of("times as fast as one thread, near each other", "1", results,
                              [&](const SizeResult& one) { return gain_near(one, k); });
      const bool ever =
          !std::all_of(near.y.begin(), near.y.end(), [](double y) { return std::isnan(y); });
      if (ever) record.series.push_back(std::move(near));
      record.series.push_back(
          series_of("arithmetic, times as fast as one", "1", results, arithmetic_gain));
      record.series.push_back(
          series_of("answer of another processor", "s", results, answer_seconds));
    }
    record.checks = checks_of(k, results);
    record.verdict = verdict_of(record);
  }
  records[1].notes.push_back(states_text(results));
  for (const Limit& limit : limits()) {
    Record& record = records.emplace_back(blank);
    record.configuration = limit.name;
    record.series.push_back(cost_of(
        "whole step", results, [&](const SizeResult& one) { return nanoseconds(limit, one); }));
    record.verdict = Verdict::kForInformation;
  }
  return records;
}

std::string size_summary(const std::vector<SizeResult>& results, const Tree& before,
                         const Tree& now, const Screen& screen) {
  std::string text =
      bold(fmt::format("stiction track sizes · {} → {} {} · a step takes {} of what it took\n",
                       before.label, now.label, now.revision, range_text(results)),
           screen);
  text += "\n" + plain_table(table_of(results), {0}, screen.width) + "\n";
  text += bullet(
      "Medians of steps that go on from where a workload is at rest, taken in turn: whole steps by "
      "CPU time, phases and threads by the clock on the wall.",
      screen.width);
  text += bullet(spread_text(results), screen.width);
  text += bullet(states_text(results), screen.width);
  for (std::size_t k = 0; k < results.front().ways.size(); ++k) {
    for (const Judgement& check : checks_of(k, results)) {
      if (check.verdict == Verdict::kPass) continue;
      text += bullet(
          fmt::format("FAILS: {}: {}, {:.0f} {}, for one {}", check.claim.statement,
                      results.front().ways[k].name, check.value, check.claim.quantity, check.worst),
          screen.width);
    }
  }
  return text;
}

}  // namespace stiction::track
