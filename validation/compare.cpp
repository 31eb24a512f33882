// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction compare`: iteration rules side by side → records → tables,
// findings.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>
#include <thread>

#include "reference/process/interruption.h"
#include "reports/formats/csv.h"
#include "reports/formats/markdown.h"
#include "reports/formats/work_precision.h"
#include "reports/record/record_store.h"
#include "reports/screen/command_line.h"
#include "reports/screen/help_page.h"
#include "reports/screen/program.h"
#include "reports/screen/progress_line.h"
#include "reports/screen/screen.h"
#include "reports/text/number.h"
#include "reports/text/text.h"
#include "solver/demand.h"
#include "solver/environment.h"
#include "solver/friction/catalog.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/comparison_table.h"
#include "validation/comparison/engines/compare_engines.h"
#include "validation/comparison/findings.h"
#include "validation/comparison/summary.h"
#include "validation/core/engine_options.h"
#include "validation/core/program.h"
#include "validation/core/runner.h"
#include "validation/engines/stiction/stiction_method.h"
#include "validation/shards/job_list.h"
#include "validation/shards/portion.h"
#include "validation/shards/shard_options.h"

namespace stiction {

namespace {

struct Arguments {
  Selection selection;
  std::vector<std::string> rules;
  std::vector<std::string> contacts;
  PortionWords portion;
  bool list = false;
  bool json = false;
  bool lines = false;
  bool quick = false;
  bool no_page = false;
  bool verbose = false;
  std::string out = "comparison-report";
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

// Options that both comparisons have.
void define_output(CLI::App& app, std::string& out, bool& verbose, bool& no_page) {
  app.add_flag("--verbose", verbose, "Print every table too, not what was found alone")
      ->group("What is written");
  app.add_option("--out", out,
                 "Folder for the reports; each run gets a folder of its own in it, 'latest' points "
                 "to the last")
      ->type_name("DIR")
      ->capture_default_str()
      ->group("What is written");
  app.add_flag("--no-page", no_page,
               "Leave out report.html, which ./stiction makes from the records with node")
      ->group("What is written");
}

void define_engines(CLI::App& app, EngineComparison& asked) {
  const char* const which = "What is compared";
  const char* const how = "How it runs";
  app.add_option("--engine", asked.engines,
                 "Only this engine: a name, or a program that speaks the engine protocol; "
                 "repeatable")
      ->type_name("NAME|COMMAND")
      ->group(which);
  app.add_option("--question", asked.questions, "Only questions whose id matches; repeatable")
      ->type_name("GLOB")
      ->group(which);
  app.add_flag("--quick", asked.quick, "Under three minutes: the chief questions")->group(which);
  app.add_flag("--list", asked.list, "Show the questions and end")->group(which);
  add_list_json(app, asked.json);
  add_portion(app, asked.portion);
  app.add_option("--jobs", asked.jobs, "Questions to ask at a time; more than one disturbs times")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str()
      ->group(how);
  app.add_option("--cpu-limit", asked.cpu_limit,
                 "CPU time for an answer, s; what takes longer is told as broken")
      ->type_name("S")
      ->check(finite_number(false))
      ->capture_default_str()
      ->group(how);
  for (CLI::Option* const option : add_engine_limits(app, asked.limits)) option->group(how);
  define_output(app, asked.out, asked.verbose, asked.no_page);
  set_help(
      app,
      {.name = "stiction-compare-engines",
       .summary = "engines side by side: who holds, who creeps, at which cost",
       .synopsis = {"./stiction compare engines [--engine NAME|COMMAND]... [OPTIONS]"},
       .description =
           "Asks every engine, in each configuration that it brings, how far its answers to some "
           "twenty "
           "questions with known answers are off (does a box creep, at which slope does it give, "
           "how far "
           "does it slide, ...), and some of them along a ladder of efforts. Prints who holds and "
           "at which "
           "cost, where others are closer or cheaper than this project's solver, and who broke.",
       .exit_codes = {{"0", "compared; an engine that breaks is a result"},
                      {"2", "could not run: bad input, no engine could be asked, a full disk"}},
       .files = {{"engine-report/latest/engines.md",
                  "every answer, and the cheapest way to each error"},
                 {"engine-report/latest/records.jsonl, records.csv", "the records behind it"},
                 {"engine-report/latest/report.html", "the page"}},
       .examples = {{"./stiction compare engines --quick", "the chief questions, three minutes"},
                    {"./stiction compare engines --engine stiction --engine ./my_engine",
                     "your own engine beside this project's solver"},
                    {"./stiction compare engines --question 'creep-*' --verbose",
                     "who creeps, with every answer"}},
       .see_also = {"./stiction help engine", "./stiction help validate",
                    "validation/comparison/engines/README.md"}});
}

std::string rule_help() {
  std::string text;
  for (const std::string& name : friction_rule_names()) {
    const RuleCard card = friction_rule_card(name);
    text += fmt::format("{}\n", name);
    text += bullet(fmt::format("remembers {} ({} B a contact); {}", card.memory,
                               friction_memory_bytes(name), card.guarantees),
                   69, "    ");
    for (const RuleParameter& parameter : friction_rule_parameters(name)) {
      text +=
          bullet(fmt::format("{}: {}", parameter.name, parameter_help(parameter)), 69, "    - ");
    }
  }
  return text;
}

void define(CLI::App& app, Arguments& arguments) {
  const char* const which = "What is compared";
  app.add_option("--scene", arguments.selection.globs,
                 "Only comparisons whose name matches, e.g. 'rules/slab' or 'gain/*'; repeatable")
      ->type_name("GLOB")
      ->group(which);
  app.add_option("--rule", arguments.rules, "Only this rule; repeatable")
      ->type_name("RULE")
      ->group(which);
  app.add_option("--contacts", arguments.contacts,
                 "Only the contacts of this method, paper, quiet or old; repeatable")
      ->type_name("METHOD")
      ->check(CLI::IsMember({"paper", "quiet", "old"}))
      ->group(which);
  app.add_flag("--quick", arguments.quick,
               "Under 20 seconds: three scenes, every rule, and one load")
      ->group(which);
  app.add_flag("--list", arguments.list, "Show the names of the comparisons and end")->group(which);
  add_list_json(app, arguments.json);
  add_portion(app, arguments.portion);
  add_lines(app, arguments.lines);
  app.add_option("--jobs", arguments.jobs, "Rules to run at a time")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str()
      ->group("How it runs");
  define_output(app, arguments.out, arguments.verbose, arguments.no_page);
  set_help(
      app,
      {.name = "stiction-compare",
       .summary = "friction rules side by side: speed against error",
       .synopsis = {"./stiction compare [--scene GLOB]... [--rule RULE]... [OPTIONS]",
                    "./stiction compare engines [OPTIONS]"},
       .description =
           "Sets every rule of static friction, on the paper's contacts and on the "
           "quiet ones, side by side "
           "on the same scenes: friction memory lost, loads of 0.1 to 0.95 of the cone, "
           "a box that falls, "
           "random poses, hard conditions, gains, work against precision in double and in "
           "single precision. Prints who "
           "wins each question "
           "with its figure and cost, and what failed.",
       .exit_codes = {{"0", "compared; a rule that fails on a scene is a result"},
                      {"1", "a timed run was not the computation that was looked at"},
                      {"2", "could not run: bad input, a full disk"}},
       .files = {{"comparison-report/latest/comparison.md",
                  "findings in sentences, and every table"},
                 {"comparison-report/latest/records.jsonl, records.csv, report.md",
                  "the records behind them"},
                 {"comparison-report/latest/report.html, plots/",
                  "the page, and its plots as SVG files"}},
       .examples = {{"./stiction compare --quick", "the chief scenes in seconds"},
                    {"./stiction compare --scene 'rules/*' --rule fixed-point --rule my-rule",
                     "a rule of your own against the paper's, where friction memory was lost"},
                    {"./stiction compare --scene 'claims/*'", "which of the paper's claims hold"},
                    {"./stiction compare --scene 'work-precision/*'",
                     "the cheapest method, sweeps, time step and mesh for an error"}},
       .see_also = {"./stiction help validate", "./stiction compare engines --help",
                    "solver/friction/README.md (how to write a rule)"},
       .more = {{"Rules",
                 "What they remember, guarantee and can be given (--set NAME=VALUE);\n"
                 "each is a header of solver/friction/rules/.\n\n" +
                     rule_help()}}});
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

// A table of each comparison once all of its rules are known, in order; printed with `verbose`. On a
// terminal a line tells what is done.
class Tables {
 public:
  Tables(const std::vector<Job>& jobs, const std::vector<Record>& records, bool verbose)
      : jobs_(jobs),
        records_(records),
        verbose_(verbose),
        known_(jobs.size(), false),
        progress_(jobs.size()) {
    show_progress();
  }

  // A rule that broke off says so as soon as it does.
  void complain(const Record& record) {
    progress_.clear();
    tell(fmt::format("stiction compare: {}: {}", record.case_name, record.error));
  }

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
      if (verbose_) {
        progress_.clear();
        show(text);
        std::fflush(stdout);
      }
      next_ = end;
    }
    show_progress();
  }

  const std::string& text() const { return text_; }

 private:
  void show_progress() {
    const auto done = static_cast<std::size_t>(std::count(known_.begin(), known_.end(), true));
    if (done == jobs_.size()) return progress_.clear();
    const auto next =
        static_cast<std::size_t>(std::find(known_.begin(), known_.end(), false) - known_.begin());
    progress_.show(done, jobs_[next].which.name + ", " + rule_words(jobs_[next].settings));
  }

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
  bool verbose_;
  std::vector<bool> known_;
  ProgressLine progress_;
  std::size_t next_ = 0;
  std::string text_;
};

std::size_t count_cases(const std::vector<Job>& jobs) {
  std::set<std::string> names;
  for (const Job& job : jobs) names.insert(job.which.name);
  return names.size();
}

double seconds_since(std::chrono::steady_clock::time_point began) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

int compare(Arguments& arguments) {
  Selection& selection = arguments.selection;
  if (arguments.quick) selection.set = CaseSet::kQuick;
  std::vector<Job> all = chosen(select_jobs(comparison_catalog(), selection), arguments);
  if (arguments.json && !arguments.list) throw InputError("--json goes with --list");
  if (arguments.list && !arguments.json) {
    std::string last;
    for (const Job& job : all) {
      if (job.which.name != last)
        show_line(fmt::format("{:<34} {}", job.which.name, job.which.title));
      last = job.which.name;
    }
    return kHolds;
  }
  const auto began = std::chrono::steady_clock::now();
  // Which builds there are is no matter of the list.
  if (!arguments.json) all = with_builds(std::move(all));
  const Portion portion("compare", all, Together::kNothing, arguments.portion);
  const std::vector<Job>& jobs = portion.jobs();
  if (arguments.list) {
    show(job_list_json(portion));
    return kHolds;
  }
  reference::WithLastWords<RecordStore> run([&] { return RecordStore::create(arguments.out); });
  RecordStore& store = *run;
  std::vector<Record> records(jobs.size());
  Tables tables(jobs, records, arguments.verbose);
  portion.run(store, arguments.jobs, 1.0, [&](std::size_t index, Record record) {
    if (record.verdict == Verdict::kError) tables.complain(record);
    store.append(record);
    if (arguments.lines) show_result_line(record);
    records[index] = std::move(record);
    tables.finished(index);
  });
  if (!portion.is_whole()) {
    portion.finish_part(store);
    return exit_code(records);
  }
  const Record found = findings(records);
  if (!found.notes.empty() || !found.checks.empty()) store.append(found);
  std::string text = "\n## Findings\n\n";
  for (const std::string& sentence : found.notes) text += "- " + sentence + "\n";
  if (arguments.verbose) show(fmt::format("{}\n", text));
  store.write_file("comparison.md", "# Iteration rules side by side\n" + text +
                                        work_precision_markdown(records) + tables.text());
  store.write_file("report.md", markdown_report(records));
  store.write_file("records.csv", csv_table(records));
  store.finish();
  if (arguments.lines) {
    if (!arguments.no_page) store.tell_caller();
    return exit_code(records);
  }
  const Screen screen = screen_of(STDOUT_FILENO);
  show(bullet(
      fmt::format("stiction compare · {} runs of {} · {}", records.size(),
                  counted(count_cases(jobs), "comparison"), duration_text(seconds_since(began))),
      screen.width, ""));
  std::string summary = comparison_summary(records, found, screen);
  summary.erase(summary.find_last_not_of('\n') + 1);
  show(fmt::format("\n{}\n\n", summary));
  show_line(fmt::format("{}, and every table: {}{}", counted(found.notes.size(), "finding"),
                        (store.folder() / "comparison.md").string(),
                        arguments.verbose ? "" : " (here: --verbose)"));
  if (!arguments.no_page) store.tell_caller();
  return exit_code(records);
}

}  // namespace

}  // namespace stiction

int main(int argc, char** argv) {
  stiction::reference::end_in_order("stiction compare");
  CLI::App app("Sets iteration rules of static friction side by side: speed against error.",
               "stiction compare");
  stiction::Arguments arguments;
  stiction::define(app, arguments);
  stiction::EngineComparison engines;
  arguments.portion.command = engines.portion.command = stiction::words_of(argc, argv);
  CLI::App* const of_engines = app.add_subcommand(
      "engines", "Sets engines side by side: who holds, who creeps, at which cost");
  stiction::define_engines(*of_engines, engines);
  return stiction::run_program(app, argc, argv, [&]() -> int {
    stiction::check_environment();  // what cannot be had is refused before anything runs
    if (of_engines->parsed()) return stiction::compare_engines(engines);
    return stiction::compare(arguments);
  });
}
