// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/compare_engines.h"

#include <fmt/format.h>
#include <fnmatch.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "reference/process/interruption.h"
#include "reports/formats/csv.h"
#include "reports/record/record_store.h"
#include "reports/screen/program.h"
#include "reports/screen/progress_line.h"
#include "reports/screen/screen.h"
#include "reports/text/names.h"
#include "reports/text/number.h"
#include "solver/demand.h"
#include "validation/comparison/engines/build_pairs.h"
#include "validation/comparison/engines/engine_matrix.h"
#include "validation/comparison/engines/engine_summary.h"
#include "validation/comparison/engines/trials.h"
#include "validation/core/program.h"
#include "validation/engine/conformance/conformance.h"
#include "validation/shards/job_list.h"

namespace stiction {

namespace {

constexpr double kQuickLimit = 5.0;  // s of CPU time for an answer

std::vector<Question> chosen_questions(const EngineComparison& asked) {
  std::vector<Question> chosen;
  for (const std::string& glob : asked.questions) {
    const auto& all = engine_questions();
    if (std::none_of(all.begin(), all.end(), [&](const Question& one) {
          return fnmatch(glob.c_str(), one.id.c_str(), 0) == 0;
        })) {
      throw InputError(fmt::format("no question matches '{}'; there are: {}", glob,
                                   listed_names(all, [](const Question& one) { return one.id; })));
    }
  }
  for (const Question& one : engine_questions()) {
    const bool named = std::any_of(
        asked.questions.begin(), asked.questions.end(),
        [&](const std::string& glob) { return fnmatch(glob.c_str(), one.id.c_str(), 0) == 0; });
    if (asked.questions.empty() ? !asked.quick || one.quick : named) chosen.push_back(one);
  }
  return chosen;
}

// Engines that could not be asked are told, each in a sentence; a run of none is an error.
struct Engines {
  std::vector<EngineKind> asked;
  std::vector<std::string> left_out;
};

Engines find_engines(const EngineComparison& comparison) {
  std::vector<std::string> names = comparison.engines;
  if (names.empty()) {
    for (const EngineKind& kind : engine_catalog()) {
      if (kind.name != "plain") names.push_back(kind.name);  // an example of an adapter
    }
    for (const EngineProgram& one : engine_programs()) names.push_back(one.name);
  }
  Engines engines;
  for (const std::string& name : names) {
    try {
      EngineKind kind = find_engine(name);
      demand_conformance(kind, {});
      for (const EngineKind& other : engines.asked) {
        if (other.name != kind.name) continue;
        throw InputError(fmt::format("two engines call themselves '{}': '{}' and '{}'", kind.name,
                                     other.program, kind.program));
      }
      engines.asked.push_back(std::move(kind));
    } catch (const InputError& why) {
      engines.left_out.push_back(why.what());
    }
  }
  if (engines.asked.empty()) {
    throw InputError("no engine can be asked: " + listed_names(engines.left_out));
  }
  return engines;
}

std::string sources_text(const std::vector<EngineKind>& engines) {
  std::string text;
  for (const EngineKind& engine : engines) {
    text += fmt::format("- {}: {}\n", engine.name, engine.description);
    if (!engine.configurations) continue;
    for (const Configuration& one : engine.configurations("")) {
      if (one.source.empty()) continue;
      std::string settings;
      for (const auto& [name, value] : one.settings) settings += fmt::format(" {}={}", name, value);
      text += fmt::format("  - {}:{} ({})\n", one.name, settings, one.source);
    }
  }
  return text;
}

}  // namespace

ExitCode compare_engines(const EngineComparison& asked) {
  set_program_limits(asked.limits);
  const std::vector<Question> questions = chosen_questions(asked);
  if (asked.json && !asked.list) throw InputError("--json goes with --list");
  if (asked.list && !asked.json) {
    for (const Question& one : questions) {
      show_line(fmt::format("{:<14} {:<32} {}", one.id, one.case_name, one.words));
    }
    return kHolds;
  }
  const Engines engines = find_engines(asked);
  for (const std::string& sentence : engines.left_out) {
    tell("stiction compare engines: left out: " + sentence);
  }
  const std::vector<Trial> trials = engine_trials(engines.asked, questions, asked.quick);
  std::vector<Job> all;
  for (const Trial& trial : trials) {
    all.push_back(trial.job);
    all.back().cpu_limit = asked.quick ? std::min(asked.cpu_limit, kQuickLimit) : asked.cpu_limit;
  }
  const Portion portion("compare", all, Together::kNothing, asked.portion);
  const std::vector<Job>& jobs = portion.jobs();
  if (asked.json) {
    show(job_list_json(portion));
    return kHolds;
  }

  reference::WithLastWords<RecordStore> run([&] { return RecordStore::create(asked.out); });
  RecordStore& store = *run;
  std::vector<Record> records(jobs.size());
  const auto began = std::chrono::steady_clock::now();
  std::size_t done = 0;
  ProgressLine progress(jobs.size());
  portion.run(store, asked.jobs, 1.0, [&](std::size_t index, Record record) {
    const Trial& trial = trials[portion.number(index)];
    record.settings["configuration"] = trial.configuration;
    record.settings["effort"] = std::to_string(trial.effort);
    store.append(record);
    records[index] = std::move(record);
    ++done;
    const Trial& next = trials[portion.number(std::min(index + 1, jobs.size() - 1))];
    progress.show(done, row_name(next) + ", " + next.job.which.name);
  });
  progress.clear();
  if (!portion.is_whole()) {
    portion.finish_part(store);
    return kHolds;
  }
  const std::vector<Record> made = engine_records(questions, trials, records);
  for (const Record& record : made) store.append(record);
  const EngineAnswers answers(questions, made);
  const std::vector<std::string> found = engine_findings(answers);
  Record findings;
  findings.case_name = "engines/findings";
  findings.title = "what the engines' answers say";
  findings.verdict = Verdict::kForInformation;
  findings.notes = found;
  findings.figures = builds_figures(answers);
  for (const std::string& sentence : engines.left_out) {
    findings.notes.push_back("Left out: " + sentence);
  }
  findings.environment = records.front().environment;
  store.append(findings);

  const std::string matrix = engine_matrix(answers);
  std::string said;
  for (const std::string& sentence : found) said += "- " + sentence + "\n";
  const Screen screen = screen_of(STDOUT_FILENO);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  show(fmt::format(
      "{}\n", bullet(fmt::format("stiction compare engines · {} engines in {} configurations · {} "
                                 "questions · {}",
                                 engines.asked.size(), answers.rows().size(), questions.size(),
                                 duration_text(seconds)),
                     screen.width, "")));
  show(engine_summary(answers, screen));
  if (asked.verbose) show(fmt::format("\n{}\n{}", said, engine_matrix(answers, screen.width)));
  const std::string cheapest = cheapest_ways(answers);
  std::string builds = builds_tables(answers);
  if (!builds.empty()) builds = "\n## Other builds beside their engine\n\n" + builds;
  store.write_file(
      "engines.md",
      fmt::format("# Engines side by side\n\n{}\n## Findings\n\n{}\n## The cheapest way to an "
                  "error\n\n{}\n{}\n## Engines and their configurations\n\n{}",
                  matrix, said, cheapest, builds, sources_text(engines.asked)));
  store.write_file("records.csv", csv_table(records));
  store.finish();
  show("\n");
  show_line(fmt::format("Every answer: {}{}", (store.folder() / "engines.md").string(),
                        asked.verbose ? "" : " (here: --verbose)"));
  if (!asked.no_page) store.tell_caller();
  return kHolds;
}

}  // namespace stiction
