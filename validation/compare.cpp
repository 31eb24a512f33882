// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction compare`: iteration rules side by side → records → tables,
// findings.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <thread>

#include "reports/formats/csv.h"
#include "reports/formats/markdown.h"
#include "reports/record/record_store.h"
#include "solver/demand.h"
#include "solver/friction/catalog.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/comparison_table.h"
#include "validation/comparison/engines/compare_engines.h"
#include "validation/comparison/findings.h"
#include "validation/core/engine_options.h"
#include "validation/core/program.h"
#include "validation/core/runner.h"
#include "validation/engines/stiction/stiction_method.h"

namespace stiction {

namespace {

struct Arguments {
  Selection selection;
  std::vector<std::string> rules;
  std::vector<std::string> contacts;
  bool list = false;
  bool quick = false;
  bool no_page = false;
  std::string out = "comparison-report";
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

void define_engines(CLI::App& app, EngineComparison& asked) {
  app.add_option("--engine", asked.engines,
                 "Only this engine: a name, or a program that speaks the engine protocol; "
                 "repeatable")
      ->type_name("NAME|COMMAND");
  app.add_option("--question", asked.questions, "Only questions whose id matches; repeatable")
      ->type_name("GLOB");
  app.add_flag("--list", asked.list, "Show the questions and end");
  app.add_flag("--quick", asked.quick, "Under three minutes: the chief questions");
  app.add_option("--cpu-limit", asked.cpu_limit,
                 "CPU time for an answer, s; what takes longer is told as broken")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  add_engine_limits(app, asked.limits);
  app.add_option("--out", asked.out,
                 "Folder for the reports; each run gets a folder of its own in it, 'latest' points "
                 "to the last")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_flag("--no-page", asked.no_page,
               "Leave out report.html, which ./stiction makes from the records with node");
  app.add_option("--jobs", asked.jobs, "Questions to ask at a time; more than one disturbs times")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.footer("Exit code: 0 compared (an engine that breaks is a result), 2 could not run.");
}

std::string rule_help() {
  std::string text =
      "Rules (solver/friction/rules/), what they remember of a contact and guarantee, and their "
      "parameters\n(validate --set NAME=VALUE):\n";
  for (const std::string& name : friction_rule_names()) {
    const RuleCard card = friction_rule_card(name);
    text += fmt::format("  {:<17} {} ({} B): {}\n", name, card.memory, friction_memory_bytes(name),
                        card.guarantees);
    for (const RuleParameter& parameter : friction_rule_parameters(name)) {
      text += fmt::format("    {:<15} {}\n", parameter.name, parameter_help(parameter));
    }
  }
  return text;
}

void define(CLI::App& app, Arguments& arguments) {
  app.add_option("--scene", arguments.selection.globs,
                 "Only comparisons whose name matches, e.g. 'rules/slab' or 'gain/*'; repeatable")
      ->type_name("GLOB");
  app.add_option("--rule", arguments.rules, "Only this rule; repeatable")->type_name("RULE");
  app.add_option("--contacts", arguments.contacts, "Only the contacts of this method; repeatable")
      ->check(CLI::IsMember({"paper", "quiet"}));
  app.add_flag("--list", arguments.list, "Show the names of the comparisons and end");
  app.add_flag("--quick", arguments.quick,
               "Under 20 seconds: three scenes, every rule, and one load");
  app.add_option("--out", arguments.out,
                 "Folder for the reports; each run gets a folder of its own in it, 'latest' points "
                 "to the last")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_flag("--no-page", arguments.no_page,
               "Leave out report.html, which ./stiction makes from the records with node");
  app.add_option("--jobs", arguments.jobs, "Rules to run at a time")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.footer(
      rule_help() +
      "\nExit code: 0 compared (a rule that fails on a scene is a result), 1 a timed run was "
      "not the computation that was looked at, 2 could not run.");
}

// Those of the rules and contacts asked for.
std::vector<Job> chosen(std::vector<Job> jobs, const Arguments& arguments) {
  for (const std::string& rule : arguments.rules) {
    if (!is_friction_rule(rule)) {
      throw InputError(
          fmt::format("unknown friction rule '{}'; there are: {}", rule, friction_rule_list()));
    }
  }
  const auto is_in = [](const std::vector<std::string>& words, const std::string& word) {
    return words.empty() || std::find(words.begin(), words.end(), word) != words.end();
  };
  std::erase_if(jobs, [&](const Job& job) {
    return !is_in(arguments.rules, job.settings.at("rule")) ||
           !is_in(arguments.contacts, job.settings.at("method"));
  });
  if (jobs.empty()) throw InputError("no comparison has such a rule on such contacts");
  return jobs;
}

// Prints each comparison once all of its rules are known, in order.
class Tables {
 public:
  Tables(const std::vector<Job>& jobs, const std::vector<Record>& records)
      : jobs_(jobs), records_(records), known_(jobs.size(), false) {}

  void finished(std::size_t index) {
    known_[index] = true;
    while (next_ < jobs_.size()) {
      const std::size_t end = end_of(next_);
      if (!std::all_of(known_.begin() + offset(next_), known_.begin() + offset(end),
                       [](bool known) { return known; })) {
        break;
      }
      const std::string text = section(next_, end);
      text_ += text;
      fmt::print("{}", text);
      std::fflush(stdout);
      next_ = end;
    }
    if (isatty(STDERR_FILENO)) {
      const auto done = std::count(known_.begin(), known_.end(), true);
      fmt::print(stderr, "\r\033[K[{}/{}]{}", done, jobs_.size(),
                 next_ == jobs_.size() ? "\r\033[K" : "");
    }
  }

  const std::string& text() const { return text_; }

 private:
  static std::ptrdiff_t offset(std::size_t index) { return static_cast<std::ptrdiff_t>(index); }

  std::size_t end_of(std::size_t begin) const {
    std::size_t end = begin;
    while (end < jobs_.size() && jobs_[end].which.name == jobs_[begin].which.name) ++end;
    return end;
  }

  std::string section(std::size_t begin, std::size_t end) const {
    std::vector<const Record*> rows;
    for (std::size_t k = begin; k < end; ++k) rows.push_back(&records_[k]);
    return fmt::format("\n## {}: {}\n\n{}", jobs_[begin].which.name, jobs_[begin].which.title,
                       comparison_table(rows));
  }

  const std::vector<Job>& jobs_;
  const std::vector<Record>& records_;
  std::vector<bool> known_;
  std::size_t next_ = 0;
  std::string text_;
};

int compare(Arguments& arguments) {
  Selection& selection = arguments.selection;
  if (arguments.quick) selection.set = CaseSet::kQuick;
  const std::vector<Job> jobs = chosen(select_jobs(comparison_catalog(), selection), arguments);
  if (arguments.list) {
    std::string last;
    for (const Job& job : jobs) {
      if (job.which.name != last) fmt::print("{:<34} {}\n", job.which.name, job.which.title);
      last = job.which.name;
    }
    return kHolds;
  }
  RecordStore store = RecordStore::create(arguments.out);
  std::vector<Record> records(jobs.size());
  Tables tables(jobs, records);
  run_jobs(jobs, arguments.jobs, 1.0, [&](std::size_t index, Record record) {
    if (record.verdict == Verdict::kError) {
      fmt::print(stderr, "stiction compare: {}: {}\n", record.case_name, record.error);
    }
    store.append(record);
    records[index] = std::move(record);
    tables.finished(index);
  });
  const Record found = findings(records);
  if (!found.notes.empty() || !found.checks.empty()) store.append(found);
  std::string text = "\n## Findings\n\n";
  for (const std::string& sentence : found.notes) text += "- " + sentence + "\n";
  fmt::print("{}", text);
  store.write_file("comparison.md", "# Iteration rules side by side\n" + text + tables.text());
  store.write_file("report.md", markdown_report(records));
  store.write_file("records.csv", csv_table(records));
  store.finish();
  fmt::print("\nReport: {}\n", (store.folder() / "comparison.md").string());
  if (!arguments.no_page) store.tell_caller();
  if (std::fflush(stdout) != 0) throw InputError("the tables could not be written to stdout");
  return exit_code(records);
}

}  // namespace

}  // namespace stiction

int main(int argc, char** argv) {
  // A write beyond a file size limit shall be an error with a sentence, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app("Sets iteration rules of static friction side by side: speed against error.",
               "stiction compare");
  stiction::Arguments arguments;
  stiction::define(app, arguments);
  stiction::EngineComparison engines;
  CLI::App* const of_engines = app.add_subcommand(
      "engines", "Sets engines side by side: who holds, who creeps, at which cost");
  stiction::define_engines(*of_engines, engines);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? stiction::kHolds : stiction::kCouldNotRun;
  }
  try {
    if (of_engines->parsed()) return stiction::compare_engines(engines);
    return stiction::compare(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "stiction compare: {}\n", error.what());
    return stiction::kCouldNotRun;
  }
}
