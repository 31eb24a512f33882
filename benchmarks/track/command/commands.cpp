// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/command/commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <iostream>

#include "benchmarks/track/command/bisect.h"
#include "benchmarks/track/command/output.h"
#include "benchmarks/track/measure/child.h"
#include "benchmarks/track/measure/google_json.h"
#include "benchmarks/track/measure/work_lock.h"
#include "benchmarks/track/sizes/sizes_output.h"
#include "benchmarks/track/store/scratch.h"
#include "benchmarks/track/store/trend_records.h"
#include "reference/process/interruption.h"
#include "reports/record/environment.h"
#include "reports/record/record_store.h"
#include "reports/record/whole_file.h"
#include "reports/screen/program.h"
#include "reports/screen/progress_line.h"
#include "reports/screen/screen.h"

namespace stiction::track {

namespace {

namespace fs = std::filesystem;
using stiction::show;

Project project_of(const Arguments& arguments) {
  if (!has_program("git"))
    throw TrackError("git is missing: what is measured is told by its commit");
  Project project;
  project.root = arguments.root;
  if (arguments.root.empty()) {
    project.root = last_line(demand_run("this folder is in no clone of stiction",
                                        {"git", "rev-parse", "--show-toplevel"}));
  }
  project.build =
      arguments.build.empty() ? project.root / "build/release" : fs::absolute(arguments.build);
  project.work =
      arguments.work.empty() ? project.root / "build/track" : fs::absolute(arguments.work);
  return project;
}

fs::path history_file(const Arguments& arguments) {
  return arguments.history.empty() ? project_of(arguments).work / "history.sqlite"
                                   : fs::path(arguments.history);
}

// Adds runs to the history, each of which gets its id; gives what went wrong, empty if nothing: what was
// measured is told all the same. What the history has not got is kept as a file that can be imported.
std::string keep(const Arguments& arguments, const std::vector<StoredRun*>& runs) {
  std::vector<std::string> kept;
  try {
    History history(history_file(arguments));
    for (StoredRun* run : runs) run->id = history.add(*run);
    return "";
  } catch (const TrackError& error) {
    for (const StoredRun* run : runs) {
      if (run->id != 0) continue;
      const fs::path file = project_of(arguments).work / ("unkept-" + run->revision + ".json");
      try {
        write_whole(file, to_google_json(*run));
        kept.push_back(fmt::format("./stiction track import '{}'", file.string()));
      } catch (const std::runtime_error&) {
        continue;  // the disk may be full there too; what is said names what is kept
      }
    }
    return fmt::format(
        "what was measured is not in the history: {}{}", error.what(),
        kept.empty() ? "" : fmt::format("; later it can be added by {}", fmt::join(kept, ", ")));
  }
}

int tell_unkept(const std::string& sentence) {
  std::fflush(stdout);
  tell("stiction track: " + sentence);
  return kCouldNotRun;
}

Scope scope_of(const Arguments& arguments) {
  Scope scope = arguments.scope;
  // One case of each kind takes seconds; --full takes the cases of a whole validation.
  if (scope.cases.empty() && !arguments.full) scope.cases = {"--quick"};
  if (scope.benchmarks.empty() && arguments.quick) scope.benchmarks = {"friction*", "step*"};
  return scope;
}

void show(const Outcome& outcome, bool recorded, const Arguments& arguments) {
  const auto text = [&] {
    if (arguments.json) return json_text(outcome);
    if (arguments.markdown) return markdown(outcome, arguments.all);
    if (arguments.all || arguments.verbose) return table(outcome, arguments.all);
    return summary(outcome, recorded, screen_of(STDOUT_FILENO));
  };
  show(text());
}

int code_of(const Outcome& outcome, const Arguments& arguments) {
  if (any(outcome.comparisons, Change::kWorse)) return kDoesNotHold;
  const bool improved = any(outcome.comparisons, Change::kBetter);
  return improved && arguments.report_improvement ? kBetter : kHolds;
}

// The machine whose runs are looked at: that of the last run, or all.
std::optional<Machine> machine_of(const std::vector<StoredRun>& runs, const Arguments& arguments) {
  if (arguments.scope.any_machine || runs.empty()) return std::nullopt;
  return runs.back().machine;
}

std::int64_t last_id(const History& history) {
  const std::vector<StoredRun> runs = history.runs(std::nullopt);
  if (runs.empty()) throw TrackError("the history holds no run yet; `track record` makes one");
  return runs.back().id;
}

std::string content(const std::string& file) {
  if (file == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  std::ifstream stream(file);
  if (!stream) throw TrackError(fmt::format("cannot read {}", file));
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

int track_against(const Arguments& arguments) {
  const Project project = project_of(arguments);
  const Tree after = present_tree(project);
  const WorkLock lock(project.work);
  if (!arguments.no_record) check_writable(history_file(arguments));
  const Tree before = build_tree(project, arguments.against);
  Outcome outcome = compare_trees(project, before, after, scope_of(arguments));
  const std::string unkept =
      arguments.no_record ? "" : keep(arguments, {&outcome.before, &outcome.after});
  show(outcome, !arguments.no_record && unkept.empty(), arguments);
  return unkept.empty() ? code_of(outcome, arguments) : tell_unkept(unkept);
}

int track_record(const Arguments& arguments) {
  const Project project = project_of(arguments);
  const Tree tree = present_tree(project);
  const WorkLock lock(project.work);
  check_writable(history_file(arguments));
  StoredRun run = measure(project, tree, scope_of(arguments));
  const std::string unkept = keep(arguments, {&run});
  if (!unkept.empty()) return tell_unkept(unkept);
  show_line(fmt::format("Run {} of {}: {} metrics.", run.id, run.revision,
                        run.measurements.all().size()));
  return kHolds;
}

int track_compare(const Arguments& arguments) {
  const History history(history_file(arguments), Access::kRead);
  Outcome outcome{.before = history.run(arguments.other),
                  .after = history.run(arguments.run == 0 ? last_id(history) : arguments.run)};
  const std::string what = difference(outcome.before.machine, outcome.after.machine);
  if (!what.empty() && !arguments.scope.any_machine) {
    throw TrackError(
        fmt::format("runs {} and {} are of different machines ({}); --any-machine "
                    "compares them all the same",
                    outcome.before.id, outcome.after.id, what));
  }
  outcome.comparisons = compare(outcome.before.measurements, outcome.after.measurements);
  outcome.appeared = missing(outcome.after.measurements, outcome.before.measurements);
  outcome.disappeared = missing(outcome.before.measurements, outcome.after.measurements);
  show(outcome, true, arguments);
  return code_of(outcome, arguments);
}

int track_history(const Arguments& arguments) {
  const History history(history_file(arguments), Access::kRead);
  const std::vector<StoredRun> all = history.runs(std::nullopt);
  const std::optional<Machine> machine = machine_of(all, arguments);
  const std::vector<Trend> trends = history.trends(arguments.metric, machine);
  if (!arguments.metric.empty() && trends.empty()) {
    throw TrackError(fmt::format("the history has no metric '{}'", arguments.metric));
  }
  const std::vector<StoredRun> runs = history.runs(machine);
  for (const StoredRun& run : runs) {
    show_line(fmt::format("{:>5}  {}  {:<13}  {}", run.id, run.date, run.revision, run.label));
  }
  if (machine) show_line(fmt::format("Machine: {}", machine->text()));
  if (runs.size() < all.size()) {
    show_line(fmt::format("{} runs of other machines are left out; --any-machine shows them.",
                          all.size() - runs.size()));
  }
  for (const Trend& trend : trends) {
    if (arguments.metric.empty() && !arguments.all) break;
    show_line(fmt::format("{} [{}]", trend.metric.name(), trend.metric.unit));
    for (std::size_t k = 0; k < trend.runs.size(); ++k) {
      show_line(fmt::format("  {:>5}  {:.6g}", trend.runs[k], trend.medians[k]));
    }
  }
  if (arguments.out.empty()) return kHolds;
  RecordStore store = RecordStore::create(arguments.out);
  for (const Record& record : trend_records(trends, current_environment())) store.append(record);
  store.finish();
  show_line(fmt::format("Records: {}", store.folder().string()));
  store.tell_caller();
  return kHolds;
}

int track_import(const Arguments& arguments) {
  StoredRun run = run_from_google_json(content(arguments.file), arguments.file);
  if (run.date.empty()) run.date = current_environment().date;
  const std::int64_t id = History(history_file(arguments)).add(run);
  show_line(fmt::format("Run {}: {} metrics of {}.", id, run.measurements.all().size(),
                        run.machine.text()));
  return kHolds;
}

int track_export(const Arguments& arguments) {
  const History history(history_file(arguments), Access::kRead);
  const std::string text =
      to_google_json(history.run(arguments.run == 0 ? last_id(history) : arguments.run));
  if (arguments.file == "-") {
    show(text);
    return kHolds;
  }
  write_whole(arguments.file, text);
  return kHolds;
}

int track_sizes(const Arguments& arguments) {
  if (arguments.against.empty()) throw TrackError("sizes are compared with --against REF");
  const Project project = project_of(arguments);
  const Tree now = present_tree(project, {"yardstick"});
  const WorkLock lock(project.work);
  const Tree before = build_tree(project, arguments.against, {"present_yardstick"});
  const std::vector<Way> ways = ways_of(before, now, arguments.threads);
  const std::vector<Workload> workloads =
      workloads_of(now, arguments.scope.benchmarks, arguments.full);
  const std::string out = arguments.out.empty() ? "sizes-report" : arguments.out;
  reference::WithLastWords<RecordStore> run([&] { return RecordStore::create(out); },
                                            Scratch::remove_all);
  RecordStore& store = *run;
  std::vector<SizeResult> results, of_family;
  ProgressLine progress(workloads.size());
  bool holds = true;
  for (const Workload& workload : workloads) {
    progress.show(results.size(), workload.name());
    of_family.push_back(measure_size(workload, ways));
    results.push_back(of_family.back());
    const bool last = results.size() == workloads.size();
    if (!last && workloads[results.size()].family == workload.family) continue;
    for (const Record& record : family_records(of_family, before, current_environment())) {
      store.append(record);
      holds = holds && record.verdict != Verdict::kFail;
    }
    of_family.clear();
  }
  progress.clear();
  store.finish();
  show(size_summary(results, before, now, screen_of(STDOUT_FILENO)));
  show_line(fmt::format("Records: {}", store.folder().string()));
  store.tell_caller();
  return holds ? kHolds : kDoesNotHold;
}

int track_bisect(const Arguments& arguments) {
  const Project project = project_of(arguments);
  const WorkLock lock(project.work);
  const std::optional<Found> found =
      bisect(project, arguments.metric, arguments.good, arguments.bad, scope_of(arguments),
             history_file(arguments));
  if (!found) {
    show_line(fmt::format("{} did not move between {} and {}.", arguments.metric, arguments.good,
                          arguments.bad));
    return kHolds;
  }
  const Comparison& one = found->comparison;
  const std::string unit = one.metric.unit == "1" ? "" : " " + one.metric.unit;
  show_line(fmt::format("{} moved in {}: {:.6g} → {:.6g}{}.", arguments.metric,
                        subject_of(project, found->commit), one.before, one.after, unit));
  for (const std::string& commit : found->also) {
    show_line(fmt::format("It may be this one too, which could not be measured: {}",
                          subject_of(project, commit)));
  }
  return one.change == Change::kWorse ? kDoesNotHold : kHolds;
}

}  // namespace stiction::track
