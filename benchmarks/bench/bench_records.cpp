// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/bench_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/record/environment.h"
#include "validation/engines/stiction/stiction_method.h"
#include "validation/judge/verdict.h"

namespace stiction::bench {

namespace {

Record new_record(const std::string& name, const std::string& title) {
  Record record;
  record.case_name = name;
  record.title = title;
  record.engine = "stiction";
  record.environment = current_environment();
  return record;
}

void add_speed_up(const std::string& part, const SpeedUp& speed_up, Record& record) {
  const auto& [before, after] = speed_up.together;
  record.figures.push_back(
      {fmt::format("speed-up by {} threads, {}", speed_up.threads, part), "1",
       fmt::format("wall-clock time of one over that of all, in turn; half of the ratios lie from "
                   "{:.2f} to {:.2f}; an answer of another processor took {:.0f} ns before, {:.0f} "
                   "ns after; at arithmetic the processors were {:.2f} and {:.2f} times as fast as "
                   "the fastest alone",
                   speed_up.ratio.lower, speed_up.ratio.upper, 1e9 * before.answer_seconds,
                   1e9 * after.answer_seconds, before.arithmetic, after.arithmetic),
       speed_up.ratio.median});
  record.checks.push_back(judge({.quantity = "batches that threads leave in another state, " + part,
                                 .unit = "1",
                                 .statement = "threads inside a step don't change a bit",
                                 .formula = "0 if the hashes are the same, else 1",
                                 .source = "the same batch by one thread, in turn",
                                 .kind = ReferenceKind::kExactComputed,
                                 .expected = 0.0,
                                 .tolerance = 0.0,
                                 .reason = "each sum has its terms in the same order"},
                                speed_up.same_hash ? 0.0 : 1.0));
}

Judgement exponent_check(const Scaling& scaling) {
  const double decades = std::log10(scaling.contacts.back() / scaling.contacts.front());
  return judge(
      {.quantity = "exponent of cost over contacts, " + scaling.part,
       .unit = "1",
       .statement = "the cost grows linearly with the number of contacts",
       .formula = "time ∝ contactsᵖ, p = 1",
       .source = "one pass over contacts a phase, and overlap regions for the search",
       .kind = ReferenceKind::kAnalytic,
       .expected = 1.0,
       .tolerance = std::log10(4.0) / decades,
       .reason = fmt::format("from cache to memory a contact may cost four times as much: log₁₀ 4 "
                             "over {:.1f} decades",
                             decades)},
      scaling.law.exponent);
}

std::vector<Record> scaling_records(const std::vector<Scaling>& scalings) {
  std::vector<Record> records;
  for (const Scaling& scaling : scalings) {
    const std::string name = "bench/" + scaling.family + "/scaling";
    if (records.empty() || records.back().case_name != name) {
      records.push_back(new_record(name, "cost of each phase over the number of contacts"));
    }
    Record& record = records.back();
    record.figures.push_back(
        {"exponent, " + scaling.part, "1", "time ∝ contactsᵖ, p", scaling.law.exponent});
    record.figures.push_back({"margin of the exponent, " + scaling.part, "1",
                              "half the 95 % interval of p", scaling.law.exponent_margin});
    Series series{scaling.part + " per contact", "s", "contacts", "1", scaling.contacts, {}};
    for (std::size_t k = 0; k < scaling.seconds.size(); ++k) {
      series.y.push_back(scaling.seconds[k] / scaling.contacts[k]);
    }
    record.series.push_back(std::move(series));
    if (scaling.part == "step") record.checks.push_back(exponent_check(scaling));
  }
  for (Record& record : records) record.verdict = verdict_of(record);
  return records;
}

Record feature_record(const std::vector<FeatureCost>& features) {
  Record record = new_record("bench/features", "model only what a scene needs");
  for (const FeatureCost& feature : features) {
    const double unused = feature.unused / feature.without;
    record.checks.push_back(
        judge({.quantity = "instructions of a step that are more, " + feature.title,
               .unit = "1",
               .statement = "a feature that a scene does not use costs nothing",
               .formula = "max(0, unused ÷ without − 1)",
               .source = "callgrind, a build without the feature beside the usual one",
               .kind = ReferenceKind::kExactComputed,
               .expected = 0.0,
               .tolerance = 0.01,
               .reason = "one test a contact and phase, of the hundreds of instructions that "
                         "each of these takes"},
              std::max(0.0, unused - 1.0)));
    record.figures.push_back({"instructions of a step, " + feature.title + ": unused ÷ without",
                              "1", "below 1: the compiler did better with the feature", unused});
    record.figures.push_back({"instructions of a step, " + feature.title + ": used ÷ without", "1",
                              fmt::format("{:.0f} instructions without", feature.without),
                              feature.used / feature.without});
  }
  record.verdict = verdict_of(record);
  return record;
}

}  // namespace

Record workload_record(const Measure::Settled& settled, const std::vector<Result>& results) {
  Record record = new_record(fmt::format("bench/{}/contacts={}", settled.family, settled.size), "");
  record.settings = method_settings(settled.options, true);
  record.settings["dt"] = fmt::format("{}", settled.options.time_step);
  record.checks = settled.checks;
  record.state_hash = fmt::format("{:016x}", settled.hash);
  record.cost.cpu_seconds = settled.seconds;
  record.cost.steps = settled.steps;
  record.cost.contact_updates = settled.contact_updates;
  for (const Result& result : results) {
    const Chosen& chosen = result.chosen;
    if (chosen.family.name != settled.family || chosen.size != settled.size) continue;
    record.title = chosen.family.title;
    record.notes.push_back(fmt::format(
        "{}: {:.1f} ns per contact, {:.0f} bytes and {:.0f} flops by the model, error {:.1g}, hash "
        "{:08x}",
        chosen.timed.name, 1e9 * result.seconds / result.contacts,
        result.cost.bytes / result.contacts, result.cost.flops / result.contacts, result.error,
        result.hash & 0xffffffffu));
    if (result.speed_up) add_speed_up(chosen.timed.name, *result.speed_up, record);
    const bool usual = chosen.timed.rule == settled.options.rule && !chosen.timed.afresh;
    if (chosen.timed.whole_step || !usual) continue;
    // Of a step, times the steps done: the cost table shows shares.
    record.cost.phase_seconds[kPhaseNames[static_cast<std::size_t>(chosen.timed.phase)]] =
        result.seconds * static_cast<double>(settled.steps);
    if (chosen.timed.phase == Phase::kNormalForce || chosen.timed.phase == Phase::kFriction) {
      record.cost.contact_phases.median += 1e9 * result.seconds / result.contacts;
    }
  }
  record.verdict = verdict_of(record);
  return record;
}

std::vector<Record> summary_records(const std::vector<Scaling>& scalings,
                                    const std::vector<FeatureCost>& features) {
  std::vector<Record> records = scaling_records(scalings);
  if (!features.empty()) records.push_back(feature_record(features));
  return records;
}

}  // namespace stiction::bench
