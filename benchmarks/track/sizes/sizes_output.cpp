// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/sizes/sizes_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "reports/text/number.h"

namespace stiction::track {

namespace {

constexpr const char* kBefore = "before";
constexpr const char* kNow = "now";

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

bool is_of_one_thread(const Way& way) { return way.threads == 1; }

// How much faster threads are than one.
double gain(const SizeResult& result, const Way& way) {
  return ratio(*result.of(kNow), *result.of(way.name), true).median;
}

// A series gets a point of each size.
void add_point(const std::string& name, const std::string& unit, double contacts, double value,
               Record& record) {
  auto at = std::find_if(record.series.begin(), record.series.end(),
                         [&](const Series& series) { return series.name == name; });
  if (at == record.series.end()) {
    at =
        record.series.insert(at, {.name = name, .unit = unit, .x_name = "contacts", .x_unit = "1"});
  }
  at->x.push_back(contacts);
  at->y.push_back(value);
}

void add_points(const SizeResult& result, Record& record) {
  const StepTimes& before = *result.of(kBefore);
  const StepTimes& now = *result.of(kNow);
  const double contacts = now.settled.contacts;
  const auto add = [&](const std::string& name, double nanoseconds) {
    add_point(name + " per contact", "s", contacts, 1e-9 * nanoseconds, record);
  };
  add("step, before", step_nanoseconds(before));
  add("step, now", step_nanoseconds(now));
  for (const Part& part : parts()) {
    add(fmt::format("{}, before", part.name), phase_nanoseconds(before, part.phases));
    add(fmt::format("{}, now", part.name), phase_nanoseconds(now, part.phases));
  }
  const reference::Quartiles of_it = ratio(now, before);
  add_point("step, now ÷ before", "1", contacts, of_it.median, record);
  add_point("step, now ÷ before, lower quartile", "1", contacts, of_it.lower, record);
  add_point("step, now ÷ before, upper quartile", "1", contacts, of_it.upper, record);
  for (std::size_t k = 2; k < result.ways.size(); ++k) {
    const Way& way = result.ways[k];
    if (is_of_one_thread(way)) {
      add("step, " + way.name, step_nanoseconds(result.times[k]));
    } else {
      add_point("gain by " + way.name, "1", contacts, gain(result, way), record);
    }
  }
  add("step, least by bandwidth", 1e9 * result.limits.bandwidth / contacts);
  add("step, least by arithmetic", 1e9 * result.limits.arithmetic / contacts);
}

// A claim that none of something is found.
Judgement none_of(Claim claim, double count, const std::string& worst) {
  Judgement check{.claim = std::move(claim), .value = count, .worst = worst, .error = count};
  check.of_tolerance = share_of_tolerance(count, 0.0);
  check.verdict = count == 0.0 ? Verdict::kPass : Verdict::kFail;
  return check;
}

std::vector<Judgement> rest_and_states(const std::vector<SizeResult>& results) {
  double restless = 0.0, other_states = 0.0;
  std::string worst_rest, worst_state;
  for (const SizeResult& result : results) {
    for (std::size_t k = 0; k < result.ways.size(); ++k) {
      const std::string what = result.workload.name() + " " + result.ways[k].name;
      if (k < 2 && !result.times[k].settled.at_rest) {  // the others' is that of now
        ++restless;
        worst_rest = what;
      }
      if (k > 0 && !same_state(result.times[k], *result.of(kNow))) {
        ++other_states;
        worst_state = what;
      }
    }
  }
  return {
      none_of({.quantity = "workloads that are not at rest",
               .unit = "1",
               .statement = "all that is timed is at rest",
               .source = "equilibrium",
               .kind = ReferenceKind::kAnalytic,
               .reason = "each is, or it is not, by its own checks"},
              restless, worst_rest),
      none_of({.quantity = "states that registers or threads leave otherwise",
               .unit = "1",
               .statement = "the width of registers and threads inside a step don't change a bit",
               .source = "the same steps in the widest registers, by one thread",
               .kind = ReferenceKind::kExactComputed,
               .reason = "each sum has its terms in the same order"},
              other_states, worst_state)};
}

std::string count_text(double count) {
  std::string text = format_count(static_cast<std::uint64_t>(count));
  std::replace(text.begin(), text.end(), ',', ' ');
  return text;
}

std::string nanoseconds(double value) {
  return value < 9.95 ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

std::string change_text(double before, double now) {
  return nanoseconds(before) + " → " + nanoseconds(now);
}

// What is told of a workload: a line of its family's.
using Told = std::pair<std::string, std::function<std::string(const SizeResult&)>>;

std::vector<Told> told(const std::vector<Way>& ways) {
  std::vector<Told> lines = {
      {"whole step",
       [](const SizeResult& one) {
         return change_text(step_nanoseconds(*one.of(kBefore)), step_nanoseconds(*one.of(kNow)));
       }},
      {"… now ÷ before", [](const SizeResult& one) {
         return fmt::format("{:.2f}", ratio(*one.of(kNow), *one.of(kBefore)).median);
       }}};
  for (const Part& part : parts()) {
    lines.emplace_back(part.name, [&part](const SizeResult& one) {
      return change_text(phase_nanoseconds(*one.of(kBefore), part.phases),
                         phase_nanoseconds(*one.of(kNow), part.phases));
    });
  }
  for (std::size_t k = 2; k < ways.size(); ++k) {
    const Way& way = ways[k];
    if (is_of_one_thread(way)) {
      lines.emplace_back("step, " + way.name, [way](const SizeResult& one) {
        return nanoseconds(step_nanoseconds(*one.of(way.name)));
      });
    } else {
      lines.emplace_back(way.name + ", × faster", [way](const SizeResult& one) {
        return fmt::format("{:.2f}", gain(one, way));
      });
    }
  }
  const auto least = [](double seconds, const SizeResult& one) {
    return nanoseconds(1e9 * seconds / one.of(kNow)->settled.contacts);
  };
  lines.emplace_back("least by bandwidth",
                     [least](const SizeResult& one) { return least(one.limits.bandwidth, one); });
  lines.emplace_back("least by arithmetic",
                     [least](const SizeResult& one) { return least(one.limits.arithmetic, one); });
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
  for (const int size : sizes) rows.front().push_back(count_text(size));
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
    return same_state(*result.of(kBefore), *result.of(kNow));
  });
  return fmt::format("Both leave the same state, to the bit, of {} of {} workloads.", same,
                     results.size());
}

// How far ratios of single turns lie apart: the quartiles' distance, of the median.
std::string spread_text(const std::vector<SizeResult>& results) {
  double most = 0.0;
  std::string of;
  for (const SizeResult& result : results) {
    const reference::Quartiles it = ratio(*result.of(kNow), *result.of(kBefore));
    const double spread = (it.upper - it.lower) / it.median;
    if (spread >= most) of = result.workload.name();
    most = std::max(most, spread);
  }
  return fmt::format("Quartiles of now ÷ before lie at most {:.0f} % apart, those of {}.",
                     100.0 * most, of);
}

std::string range_text(const std::vector<SizeResult>& results) {
  std::vector<double> all;
  for (const SizeResult& result : results) {
    all.push_back(ratio(*result.of(kNow), *result.of(kBefore)).median);
  }
  const auto [least, most] = std::minmax_element(all.begin(), all.end());
  const std::string low = fmt::format("{:.2f}", *least), high = fmt::format("{:.2f}", *most);
  return low == high ? low : low + " to " + high;
}

}  // namespace

Record family_record(const std::vector<SizeResult>& results, const Tree& before,
                     const Environment& environment) {
  Record record;
  record.case_name = "sizes/" + results.front().workload.family;
  record.title = "cost of whole steps over the number of contacts, before and now";
  record.engine = "stiction";
  record.settings["before"] = before.revision;
  record.environment = environment;
  for (const SizeResult& result : results) add_points(result, record);
  record.checks = rest_and_states(results);
  record.notes.push_back(states_text(results));
  record.verdict = verdict_of(record);
  return record;
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
  for (const Judgement& check : rest_and_states(results)) {
    if (check.verdict == Verdict::kPass) continue;
    text += bullet(fmt::format("FAILS: {}: {:.0f} {}, for one {}", check.claim.statement,
                               check.value, check.claim.quantity, check.worst),
                   screen.width);
  }
  return text;
}

}  // namespace stiction::track
