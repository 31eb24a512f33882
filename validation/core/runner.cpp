// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/runner.h"

#include <fmt/format.h>
#include <fnmatch.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>

#include "reports/record/environment.h"
#include "solver/demand.h"
#include "validation/core/case_run.h"
#include "validation/stability/perturbed_engine.h"

namespace stiction {

bool matches(const std::string& glob, const std::string& name) {
  return fnmatch(glob.c_str(), name.c_str(), 0) == 0;
}

namespace {

bool chosen(const Case& one, const Selection& selection) {
  if (selection.globs.empty()) return one.suite == selection.suite && one.set <= selection.set;
  return std::any_of(selection.globs.begin(), selection.globs.end(),
                     [&](const std::string& glob) { return matches(glob, one.name); });
}

// The settings with which a case runs: those of the configuration asked for, where it has that.
std::vector<Settings> chosen_variants(const Case& which, const EngineKind& engine,
                                      const Selection& selection, std::set<std::string>& names) {
  const bool all = selection.configuration.empty();
  std::vector<Settings> variants =
      variants_of(which, engine, selection.set == CaseSet::kFull || !all);
  if (all) return variants;
  std::erase_if(variants, [&](const Settings& settings) {
    const std::string name = called_configuration(engine, which.name, settings).name;
    names.insert(name);
    return name != selection.configuration;
  });
  return variants;
}

}  // namespace

std::vector<Job> select_jobs(const std::vector<Case>& cases, const Selection& selection) {
  EngineKind engine = find_engine(selection.engine);
  Settings over = selection.settings;
  if (!selection.perturbation.empty()) {
    engine = perturbed(engine, find_perturbation(selection.perturbation));
    over[kPerturbedSetting] = selection.perturbation;
  }
  for (const std::string& glob : selection.globs) {
    if (std::none_of(cases.begin(), cases.end(),
                     [&](const Case& one) { return matches(glob, one.name); })) {
      const bool is_family = std::any_of(cases.begin(), cases.end(), [&](const Case& one) {
        return one.name.starts_with(glob + "/");
      });
      throw InputError(
          "no case matches '" + glob + "'; " +
          (is_family ? "of that family they are '" + glob + "/*'" : "--list shows them all"));
    }
  }
  const auto in_suite = [&](const Case& one) { return one.suite == selection.suite; };
  if (!selection.suite.empty() && std::none_of(cases.begin(), cases.end(), in_suite)) {
    std::set<std::string> suites;
    for (const Case& one : cases) suites.insert(one.suite);
    suites.erase("");
    throw InputError(fmt::format("no case of a suite '{}'; there are: {}", selection.suite,
                                 fmt::join(suites, "; ")));
  }
  std::vector<Job> jobs;
  std::set<std::string> names;  // of configurations
  for (const Case& one : cases) {
    if (!chosen(one, selection)) continue;
    std::vector<Settings> seen;
    for (Settings settings : chosen_variants(one, engine, selection, names)) {
      for (const auto& [name, value] : over) settings[name] = value;
      if (std::find(seen.begin(), seen.end(), settings) != seen.end()) continue;
      const std::string name = called_configuration(engine, one.name, settings).name;
      if (!selection.configuration.empty() && name != selection.configuration) {
        throw InputError(fmt::format("--set makes the configuration '{}' another, '{}'",
                                     selection.configuration, name));
      }
      seen.push_back(settings);
      jobs.push_back({one, engine, settings});
    }
  }
  if (jobs.empty() && !names.empty()) {
    throw InputError(
        fmt::format("engine '{}' runs none of these cases in a configuration '{}'; there are: {}",
                    engine.name, selection.configuration, fmt::join(names, "; ")));
  }
  return jobs;
}

Record run_job(const Job& job, double tolerance_scale, std::optional<Recording>* recording) {
  CaseRun run(job.which, job.engine, job.settings, tolerance_scale, recording != nullptr);
  run.limit_cpu(job.cpu_limit);
  if (job.finer != 1) run.refine_time(job.finer);
  std::string error, lacking;
  try {
    job.which.run(run);
    run.demand_expected_checks();
  } catch (const NotApplicable& reason) {
    lacking = reason.what();
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  Record record = run.record();
  if (!lacking.empty() && record.error.empty()) {
    record.verdict = Verdict::kNotApplicable;
    record.notes.insert(record.notes.begin(), lacking);
  }
  if (!error.empty()) {
    record.verdict = Verdict::kError;
    record.error = error;
  }
  record.environment = current_environment();
  if (recording) *recording = run.take_recording();
  return record;
}

void run_numbered(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        work(k);
      } catch (...) {
        next = count;
        throw;
      }
    }
  };
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::task_group group;
    for (int k = 1; k < threads; ++k) group.run(take);
    group.run_and_wait(take);
  });
}

void run_jobs(const std::vector<Job>& jobs, std::span<const std::size_t> order, int threads,
              double tolerance_scale, const std::function<void(std::size_t, Record)>& finished,
              const KeepRecording& keep) {
  std::mutex one_at_a_time;
  run_numbered(order.size(), threads, [&](std::size_t place) {
    const std::size_t k = order[place];
    std::optional<Recording> recording;
    Record record = run_job(jobs[k], tolerance_scale, keep ? &recording : nullptr);
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    if (recording) record.frames = keep(k, *recording);
    finished(k, std::move(record));
  });
}

}  // namespace stiction
