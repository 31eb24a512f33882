// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction validate`: cases → records → summary screen, report.md, junit.xml,
// records.csv.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <thread>

#include "reference/process/interruption.h"
#include "reports/formats/csv.h"
#include "reports/formats/junit.h"
#include "reports/formats/markdown.h"
#include "reports/formats/summary.h"
#include "reports/formats/vtk.h"
#include "reports/record/record_json.h"
#include "reports/record/record_store.h"
#include "reports/record/whole_file.h"
#include "reports/screen/command_line.h"
#include "reports/screen/help_page.h"
#include "reports/screen/screen.h"
#include "reports/text/configuration_text.h"
#include "solver/demand.h"
#include "solver/environment.h"
#include "validation/core/console.h"
#include "validation/core/digest.h"
#include "validation/core/engine_options.h"
#include "validation/core/program.h"
#include "validation/core/runner.h"
#include "validation/engine/conformance/conformance.h"
#include "validation/heap_counter.h"
#include "validation/judge/show_expectations.h"
#include "validation/shards/job_list.h"
#include "validation/shards/portion.h"
#include "validation/shards/shard_options.h"
#include "validation/user/problem_keys.h"
#include "validation/user/user_case.h"
#include "validation/user/user_screen.h"
#include "validation/user/vary.h"

namespace stiction {

namespace {

struct Arguments {
  std::vector<std::string> problems;
  Selection selection;
  std::vector<std::string> settings;
  PortionWords portion;
  bool list = false;
  bool json = false;
  bool lines = false;
  bool quick = false;
  bool full = false;
  bool vtk = false;
  bool no_page = false;
  bool verbose = false;
  bool help_problem = false;
  bool check_only = false;
  double max_seconds = std::numeric_limits<double>::infinity();
  std::string out = "validation-report";
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  double tolerance_scale = 1.0;
  int finer = 1;
  std::string show_expectations;
  ProgramLimits limits;
};

std::string engine_help() {
  std::string text;
  for (const EngineKind& kind : engine_catalog()) {
    text += bullet(kind.name + ": " + kind.description, 69, "");
    for (const auto& [name, meaning] : kind.settings_help) {
      text += bullet(name + ": " + meaning, 69, "    - ");
    }
  }
  text += "\nPrograms, built when they are called for (./stiction engine show NAME):\n";
  for (const EngineProgram& one : engine_programs()) {
    text += bullet(fmt::format("{} (Debian: {})", one.name, one.packages), 69, "    ");
  }
  return text;
}

HelpPage help_page() {
  return {
      .name = "stiction-validate",
      .summary = "runs validation cases, or problems of your own, and writes a report",
      .synopsis = {"./stiction validate [--case GLOB]... [--engine NAME|COMMAND] [OPTIONS]",
                   "./stiction validate PROBLEM.toml... [OPTIONS]"},
      .description =
          "Simulates cases whose answer is known and says of each measured figure how far it is "
          "from that, "
          "by which tolerance it is judged and what it cost. Prints who holds, how accurately and "
          "at which "
          "cost, then every check that fails with the command that runs its case again.",
      .exit_codes = {{"0", "every check holds, or falls short as expected"},
                     {"1", "some check fails"},
                     {"2", "could not run: bad input, a case that broke off, a full disk"}},
      .files = {{"validation-report/latest/records.jsonl, records.csv",
                 "every figure; reports/record/schema.md explains the fields"},
                {"validation-report/latest/report.md, junit.xml",
                 "every check as text, and for CI"},
                {"validation-report/latest/report.html",
                 "the page: opens offline, with plots and recordings"},
                {"validation-report/latest/frames/, vtk/",
                 "recordings; vtk/ with --vtk, for ParaView"}},
      .examples = {{"./stiction validate --quick", "one case of each kind, in seconds"},
                   {"./stiction validate --case 'slab/*' --set kappa=0.7",
                    "some cases with a setting changed"},
                   {"./stiction validate --finer 2",
                    "does what holds hold at half the time step too?"},
                   {"./stiction validate --engine \"python3 my_engine.py\"",
                    "an engine of your own in every case that it can take"}},
      .see_also = {"./stiction help compare", "./stiction help report", "./stiction help engine",
                   "validation/user/TUTORIAL.md", "validation/user/examples/ramp.toml"},
      .more = {{"Engines and their settings", engine_help()}}};
}

void define(CLI::App& app, Arguments& arguments) {
  app.add_option(
         "problem", arguments.problems,
         "Your own problems, as TOML files (--help-problem explains them); without any, the "
         "built-in cases run")
      ->type_name("PROBLEM");
  app.add_option("--case", arguments.selection.globs,
                 "Only cases whose name matches, e.g. 'incline/*' or '*/mu=0.3/*'; repeatable")
      ->type_name("GLOB")
      ->group("What runs");
  app.add_option("--suite", arguments.selection.suite,
                 "Another suite than the usual one: 'stability', hard cases, how many digits "
                 "survive and where it breaks")
      ->type_name("NAME")
      ->group("What runs");
  app.add_flag("--help-problem", arguments.help_problem,
               "Explain the file of a problem: all tables, keys, observables and units")
      ->group("What runs");
  app.add_flag("--check-only", arguments.check_only,
               "Read your problems, say in words what they are and about how long they take, draw "
               "them, and end")
      ->group("What runs");
  app.add_flag("--list", arguments.list, "Show the names of the cases and end")->group("What runs");
  add_list_json(app, arguments.json);
  add_portion(app, arguments.portion);
  app.add_flag("--quick", arguments.quick, "A few seconds: one case of each kind")
      ->group("What runs");
  app.add_flag("--full", arguments.full, "The long cases as well")->group("What runs");
  app.add_option("--engine", arguments.selection.engine,
                 "The engine to validate: a name from below, or a program that speaks the engine "
                 "protocol, e.g. \"python3 my_engine.py\"")
      ->type_name("NAME|COMMAND")
      ->capture_default_str()
      ->group("What runs");
  app.add_option(
         "--configuration", arguments.selection.configuration,
         "Only this one of the engine's configurations ('./stiction engine show' lists them)")
      ->type_name("NAME")
      ->group("What runs");
  for (CLI::Option* const option : add_engine_limits(app, arguments.limits))
    option->group("How it runs");
  app.add_option("--perturb", arguments.selection.perturbation,
                 "Runs each case in a way that must not matter, e.g. turned/1 or ulp/3; an unknown "
                 "name lists them all")
      ->type_name("NAME")
      ->group("How it runs");
  app.add_option("--set", arguments.settings, "A setting of the engine, over that of each case")
      ->type_name("NAME=VALUE")
      ->group("How it runs");
  app.add_option("--out", arguments.out,
                 "Folder for the reports; each run gets a folder of its own in it, 'latest' points "
                 "to the last")
      ->type_name("DIR")
      ->capture_default_str()
      ->group("What is written");
  app.add_flag("--vtk", arguments.vtk,
               "Write what the cases record for ParaView too: vtk/*.pvd in the run's folder")
      ->group("What is written");
  app.add_flag("--no-page", arguments.no_page,
               "Leave out report.html, which ./stiction makes from the records with node")
      ->group("What is written");
  add_lines(app, arguments.lines);
  app.add_flag("--verbose", arguments.verbose,
               "Print every check of every record, as report.md has it")
      ->group("What is written");
  app.add_option("--max-seconds", arguments.max_seconds,
                 "A case whose steps take more CPU time is given up, and its record says so")
      ->type_name("S")
      ->check(finite_number(false))
      ->group("How it runs");
  app.add_option("--jobs", arguments.jobs, "Cases to run at a time")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str()
      ->group("How it runs");
  app.add_option_function<std::string>(
         "--threads",
         // Programs that run as engines hear of it too.
         [](const std::string& wanted) { ::setenv("STICTION_THREADS", wanted.c_str(), 1); },
         "Threads inside a step of this project's solver [1], used where they pay, as in scenes of "
         "some 10 000 contacts; the digits are the same")
      ->type_name("N")
      ->check(CLI::Range(1, most_threads()))
      ->group("How it runs");
  app.add_option("--tolerance-scale", arguments.tolerance_scale,
                 "Multiplies every tolerance; 0 fails whatever is not exact and so shows every "
                 "residual")
      ->type_name("S")
      ->check(finite_number(true))
      ->capture_default_str()
      ->group("How it runs");
  app.add_option(
         "--finer", arguments.finer,
         "Time steps are 1/N of those that cases take else: does what holds still hold? What "
         "is expected to fall short is then for information")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str()
      ->group("How it runs");
  app.add_option(
         "--show-expectations", arguments.show_expectations,
         "Run nothing: list what the engine is expected to fall short of beside what this "
         "run measured, and its failures, as rows of validation/engines/stiction/expectations/")
      ->type_name("RECORDS.jsonl")
      ->group("What is written");
  set_help(app, help_page());
}

void list_cases(const std::vector<Case>& cases, const Selection& selection) {
  std::string last;
  for (const Job& job : select_jobs(cases, selection)) {
    if (job.which.name == last) continue;
    last = job.which.name;
    show_line(fmt::format("{:<46} {:<6} {}", job.which.name,
                          job.which.set == CaseSet::kDefault ? "" : name_of(job.which.set),
                          job.which.title));
  }
}

// Refuses, before anything runs, settings that are unknown or out of range, and those that no job
// uses.
void refuse_settings(const std::vector<Job>& jobs) {
  std::map<std::string, std::string> idle;
  std::set<std::string> used;
  for (const Job& job : jobs) {
    job.engine.make(job.settings);
    if (!job.engine.idle) continue;
    const std::map<std::string, std::string> here = job.engine.idle(job.settings);
    idle.insert(here.begin(), here.end());
    for (const auto& [name, value] : job.settings) {
      if (here.count(name) == 0) used.insert(name);
    }
  }
  for (const auto& [name, sentence] : idle) {
    if (used.count(name) == 0) throw InputError(sentence);
  }
}

std::string rerun(const Record& record, const Arguments& arguments) {
  const double scale = arguments.tolerance_scale;
  return rerun_command(record, arguments.problems, arguments.selection.engine) +
         (scale == 1.0 ? "" : fmt::format(" --tolerance-scale {}", scale));
}

std::filesystem::path earlier_records(const std::string& out) {
  return std::filesystem::path(out) / "latest" / "records.jsonl";
}

int validate(Arguments& arguments) {
  set_program_limits(arguments.limits);
  set_heap_count(heap_counter());
  if (arguments.quick && arguments.full) throw InputError("--quick and --full exclude each other");
  if (arguments.lines && arguments.verbose) {
    throw InputError("--lines and --verbose exclude each other");
  }
  if (!arguments.show_expectations.empty()) {
    const RecordFile file = read_records(std::filesystem::path(arguments.show_expectations));
    show(show_expectations(file.records, find_engine(arguments.selection.engine)));
    return kHolds;
  }
  if (arguments.help_problem) {
    show(problem_help(screen_of(STDOUT_FILENO).width));
    return kHolds;
  }
  Selection& selection = arguments.selection;
  selection.settings = parse_settings(arguments.settings);
  if (arguments.quick) selection.set = CaseSet::kQuick;
  if (arguments.full) selection.set = CaseSet::kFull;

  const std::vector<UserCase> problems = read_user_problems(arguments.problems);
  std::vector<Case> cases;
  for (const UserCase& one : problems) cases.push_back(one.which);
  // Which of the built-in ones are wanted says nothing of what is named.
  if (!problems.empty()) selection.set = CaseSet::kFull;
  if (cases.empty()) cases = cases_for(find_engine(selection.engine));
  if (arguments.list && !arguments.json) {
    if (!arguments.quick) selection.set = CaseSet::kFull;
    list_cases(cases, selection);
    return kHolds;
  }
  if (arguments.json && !arguments.list) throw InputError("--json goes with --list");
  std::vector<Job> all = select_jobs(cases, selection);
  for (Job& job : all) {
    job.cpu_limit = arguments.max_seconds;
    job.finer = arguments.finer;
  }
  refuse_settings(all);
  // What is put together was computed by an engine that spoke right.
  if (arguments.portion.parts.empty()) {
    demand_conformance(find_engine(selection.engine), selection.settings);
  }
  std::string depends = fmt::format("{}\n", arguments.tolerance_scale);
  for (const std::string& file : arguments.problems) {
    std::ifstream text(file);
    depends += hash_of_file(file) + "\n" + surface_words(*parse_toml(text, file));
  }
  const Portion portion("validate", all, Together::kCases, arguments.portion, depends);
  const std::vector<Job>& jobs = portion.jobs();
  if (arguments.list) {
    show(job_list_json(portion));
    return kHolds;
  }
  if (arguments.check_only) {
    if (problems.empty()) throw InputError("--check-only needs a problem's file");
    const reference::LastWords words([] {
      end_writing();
      return "";
    });
    show_problems(problems, jobs, arguments.out);
    return kHolds;
  }
  if (!portion.is_whole()) tell(portion.text());
  if (arguments.tolerance_scale != 1.0) tell(scale_sentence(arguments.tolerance_scale));
  if (arguments.finer != 1) {
    const bool some_expected =
        arguments.tolerance_scale == 1.0 && selection.settings.empty() && problems.empty();
    tell(finer_sentence(arguments.finer) +
         (some_expected ? "; what is expected to fall short at those is for information" : ""));
  }
  tell_long_runs(problems, jobs);

  reference::WithLastWords<RecordStore> run([&] { return RecordStore::create(arguments.out); });
  RecordStore& store = *run;
  const Screen screen = screen_of(STDOUT_FILENO);
  std::vector<Record> records(jobs.size());
  Console console(jobs, screen,
                  {.verbose = arguments.verbose,
                   .quiet = arguments.lines,
                   .earlier = earlier_records(arguments.out),
                   .rerun = [&](const Record& record) { return rerun(record, arguments); }});
  const auto start = std::chrono::steady_clock::now();
  const auto finished = [&](std::size_t index, Record record) {
    store.append(record);
    console.finished(index, record);
    if (arguments.lines) show_result_line(record);
    records[index] = std::move(record);
  };
  const auto keep = [&](std::size_t index, const Recording& recording) {
    const std::string stem = file_stem(jobs[index].which.name, portion.number(index));
    write_frames(store.folder() / "frames" / (stem + ".bin"), recording);
    if (arguments.vtk) write_vtk(store.folder() / "vtk", stem, recording);
    return "frames/" + stem + ".bin";
  };
  portion.run(store, arguments.jobs, arguments.tolerance_scale, finished, keep);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  store.write_file("report.md", markdown_report(records));
  store.write_file("junit.xml", junit_xml(records));
  store.write_file("records.csv", csv_table(records));
  store.finish();
  const auto fails_beside_the_table = [](const Record& record) {
    return record.verdict == Verdict::kFail && record.variant.empty();
  };
  if (problems.empty() && !selection.settings.empty() &&
      std::any_of(records.begin(), records.end(), fails_beside_the_table)) {
    tell("with --set no shortfall is expected: what falls short fails");
  }
  if (arguments.lines) {
    if (!arguments.no_page) store.tell_caller();
    return exit_code(records);
  }
  show(fmt::format("{}{}", arguments.verbose ? "\n" : "",
                   summary_screen(records, screen, took.count())));
  if (!arguments.verbose) show("All checks: --verbose, or report.md\n");
  show_line("Report: " + (store.folder() / "report.md").string());
  if (!arguments.no_page) store.tell_caller();
  return exit_code(records);
}

}  // namespace

}  // namespace stiction

int main(int argc, char** argv) {
  stiction::reference::end_in_order("stiction validate");
  CLI::App app("Runs the validation cases and writes a report.", "stiction validate");
  stiction::Arguments arguments;
  arguments.portion.command = stiction::words_of(argc, argv);
  stiction::define(app, arguments);
  return stiction::run_program(app, argc, argv, [&] {
    stiction::check_environment();  // what cannot be had is refused before anything runs
    return stiction::validate(arguments);
  });
}
