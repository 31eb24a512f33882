// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction bench`: cost per contact of every phase, how it grows, and what
// optional features cost those who don't use them. benchmarks/README.md explains the figures.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "benchmarks/bench/bench_records.h"
#include "benchmarks/bench/bench_summary.h"
#include "benchmarks/bench/console.h"
#include "benchmarks/bench/fixed.h"
#include "reference/process/interruption.h"
#include "reference/process/processors.h"
#include "reports/record/environment.h"
#include "reports/record/record_store.h"
#include "reports/record/whole_file.h"
#include "reports/screen/command_line.h"
#include "reports/screen/help_page.h"
#include "reports/screen/progress_line.h"
#include "reports/screen/screen.h"
#include "reports/text/exit_code.h"
#include "reports/text/number.h"
#include "solver/demand.h"
#include "solver/environment.h"

namespace stiction::bench {

namespace {

struct Arguments {
  std::string filter;
  std::string out_file;
  bool list = false;
  bool full = false;
  bool no_features = false;
  bool verbose = false;
  int threads = 1;
  bool list_fixed = false;
  bool machine = false;
  std::string fixed;
  int batches = 1;
  std::string out = "bench-report";
  // Of Google Benchmark's flags:
  bool given_min_time = false;
  bool interleaved = false;  // no workload is done before the end
};

void define(CLI::App& app, Arguments& arguments) {
  const char* const which = "What is measured";
  const char* const written = "What is written";
  const char* const one = "One benchmark, counted";
  app.add_option("--benchmark_filter", arguments.filter,
                 "Only benchmarks whose name matches; with '-' in front, only the others")
      ->type_name("REGEX")
      ->group(which);
  app.add_flag("--full", arguments.full, "Up to a million contacts as well: minutes, and gigabytes")
      ->group(which);
  app.add_flag("--no-features", arguments.no_features,
               "Leave out what optional features cost (as --benchmark_filter does)")
      ->group(which);
  app.add_option("--threads", arguments.threads,
                 "Beside one thread, as many inside a step: how much faster, and whether to the "
                 "same bits")
      ->type_name("N")
      ->check(CLI::Range(1, most_threads()))
      ->capture_default_str()
      ->group(which);
  app.add_flag("--list,--benchmark_list_tests", arguments.list, "Show the names and end")
      ->group(which);
  app.add_flag("--verbose", arguments.verbose,
               "Print a line each benchmark too, not what was found alone")
      ->group(written);
  app.add_option("--out", arguments.out, "Folder for the records; each run gets its own in it")
      ->type_name("DIR")
      ->capture_default_str()
      ->group(written);
  app.add_option("--benchmark_out", arguments.out_file, "Google Benchmark's report as a file too")
      ->type_name("FILE")
      ->group(written);
  app.add_option("--fixed", arguments.fixed,
                 "Do one benchmark's work --batches times without a clock, and print a line of "
                 "JSON: for instruction counts")
      ->type_name("NAME")
      ->group(one);
  app.add_option("--batches", arguments.batches, "How often --fixed does the work")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str()
      ->group(one);
  app.add_flag("--list-fixed", arguments.list_fixed,
               "Show the names of the benchmarks that --fixed takes, and end")
      ->group(one);
  app.add_flag("--machine", arguments.machine,
               "Print processor, compiler and flags as a line of JSON, and end")
      ->group(one);
  set_help(
      app,
      {.name = "stiction-bench",
       .summary = "what a contact costs, and how that grows",
       .synopsis = {"./stiction bench [--benchmark_filter REGEX] [--full] [OPTIONS]"},
       .description = "Measures the CPU time per contact of every phase of a step and of whole "
                      "steps, for 100 to 100 000 "
                      "contacts in several families of scenes that were first seen to be at rest; "
                      "how it grows with "
                      "their number; and what optional features cost those who leave them. Google "
                      "Benchmark's other "
                      "flags work too: --benchmark_repetitions=N, --benchmark_min_time=SECONDS, "
                      "--benchmark_out_format=json.",
       .exit_codes =
           {{"0", "measured"},
            {"1",
             "a workload was not at rest, a cost does not grow as it should, or a feature "
             "costs those who leave it"},
            {"2", "could not run: bad input, a full disk"}},
       .files = {{"bench-report/latest/bench.md",
                  "a line each benchmark, every exponent, every feature"},
                 {"bench-report/latest/records.jsonl", "the records behind them"},
                 {"bench-report/latest/report.html", "the page: cost over the number of contacts"}},
       .examples = {{"./stiction bench", "everything, five minutes"},
                    {"./stiction bench --benchmark_filter=friction/slab --verbose",
                     "friction alone, rule by rule, on one family"},
                    {"./stiction bench --threads 2 --benchmark_filter=^step/",
                     "whole steps on one thread and on two, in turn"},
                    {"./stiction bench --full --no-features", "up to a million contacts"}},
       .see_also = {"./stiction help track", "benchmarks/README.md"}});
}

void register_all(const std::vector<Chosen>& chosen, Measure& measure, bool given_min_time) {
  for (const Chosen& one : chosen) {
    auto* const registered = benchmark::RegisterBenchmark(
        one.name.c_str(), [&measure, one](benchmark::State& state) { measure.run(state, one); });
    registered->UseManualTime();
    if (!given_min_time) registered->MinTime(0.02);
  }
}

// Before minutes are spent: whether the file of Google Benchmark's report has a folder.
void demand_folder_of(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (std::filesystem::is_directory(folder)) return;
  throw InputError("--benchmark_out: there is no folder '" + folder.string() + "'");
}

bool any_fails(const std::vector<Record>& records) {
  return std::any_of(records.begin(), records.end(),
                     [](const Record& record) { return record.verdict == Verdict::kFail; });
}

int bench(const Arguments& arguments) {
  if (arguments.list_fixed) {
    for (const std::string& name : fixed_names()) show_line(name);
    return kHolds;
  }
  if (arguments.machine) {
    const Environment environment = current_environment();
    const nlohmann::json told = {{"machine", environment.machine},
                                 {"toolchain", environment.toolchain}};
    show_line(told.dump());
    return kHolds;
  }
  if (!arguments.fixed.empty()) {
    show(run_fixed(arguments.fixed, arguments.batches) + "\n");
    return kHolds;
  }
  const std::vector<Chosen> chosen = choose(arguments.filter, arguments.full);
  if (arguments.list) {
    for (const Chosen& one : chosen) show_line(one.name);
    return kHolds;
  }
  if (!arguments.out_file.empty()) demand_folder_of(arguments.out_file);
  reference::end_in_order("stiction bench");
  reference::WithLastWords<RecordStore> run([&] { return RecordStore::create(arguments.out); });
  RecordStore& store = *run;
  const MachinePeak machine = [] {
    const reference::OnFastestProcessor here;
    return measure_peak();
  }();
  benchmark::AddCustomContext("bytes_per_second", fmt::format("{}", machine.bytes_per_second));
  benchmark::AddCustomContext("flops_per_second", fmt::format("{}", machine.flops_per_second));
  const auto began = std::chrono::steady_clock::now();
  const Team team(arguments.threads);
  Measure measure(machine, team.size() > 1 ? &team : nullptr);
  register_all(chosen, measure, arguments.given_min_time);
  std::vector<Record> records;
  const auto keep = [&](Record record) {
    store.append(record);
    records.push_back(std::move(record));
  };
  const auto keep_workload = [&](const Measure::Settled& settled) {
    keep(workload_record(settled, measure.results()));
  };
  if (!arguments.interleaved) measure.when_done(keep_workload);
  const bool with_features = !arguments.no_features && arguments.filter.empty();
  std::vector<std::string> names;
  for (const Chosen& one : chosen) names.push_back(one.name);
  Console console(machine, std::move(names), with_features ? optional_features().size() : 0,
                  arguments.verbose);
  JsonFile json;
  // The names were chosen above: Google Benchmark would match "/manual_time" behind them too.
  benchmark::RunSpecifiedBenchmarks(&console, arguments.out_file.empty() ? nullptr : &json, ".");
  measure.finish();
  if (arguments.interleaved) {
    for (const Measure::Settled& settled : measure.settled()) keep_workload(settled);
  }
  const std::vector<Scaling> fits = scalings(measure.results());
  console.add(table(fits));
  std::vector<FeatureCost> features;
  std::string why_not;
  if (with_features) {
    auto measured = measure_features(why_not, [&](const std::string& what) { console.next(what); });
    if (measured) features = std::move(*measured);
    console.add(table(features));
  }
  std::string machine_gain;
  if (team.size() > 1) {
    machine_gain = fmt::format(
        "{} threads that share nothing go through memory {:.2f} times as fast as one here.",
        team.size(), memory_gain(team));
    console.add(machine_gain + "\n");
  }
  console.finished();

  for (Record& record : summary_records(fits, features)) keep(std::move(record));
  store.write_file("bench.md", "# What contact costs\n\n```\n" + console.text() + "```\n");
  store.finish();
  if (!arguments.out_file.empty()) write_whole(arguments.out_file, json.text());
  const Screen screen = screen_of(STDOUT_FILENO);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  if (arguments.verbose) show("\n");
  show(fmt::format(
      "{}\n", bullet(fmt::format("stiction bench · {} benchmarks · {} · one core: {:.1f} GB/s of "
                                 "memory, {:.1f} Gflop/s in double",
                                 chosen.size(), duration_text(seconds),
                                 1e-9 * machine.bytes_per_second, 1e-9 * machine.flops_per_second),
                     screen.width, "")));
  show(bench_summary(measure.results(), fits, features, records, screen));
  if (!machine_gain.empty()) show(bullet(machine_gain, screen.width));
  if (!why_not.empty()) {
    show(bullet("The cost of optional features was not measured: " + why_not + ".", screen.width));
  }
  show("\n");
  show_line(fmt::format("Every phase, size and rule: {}{}", (store.folder() / "bench.md").string(),
                        arguments.verbose ? "" : " (here: --verbose)"));
  store.tell_caller();
  return any_fails(records) ? kDoesNotHold : kHolds;
}

}  // namespace

}  // namespace stiction::bench

namespace {

// Whether a word is Google Benchmark's flag of that name; of any name, when it is empty.
bool is_flag(const std::string& word, const std::string& name) {
  const std::string start = "--benchmark_" + name;
  return word.rfind(start, 0) == 0 &&
         (name.empty() || word.size() == start.size() || word[start.size()] == '=');
}

}  // namespace

int main(int argc, char** argv) {
  using namespace stiction::bench;
  // Google Benchmark takes what it knows out of the words given to it; two of its flags we need
  // too.
  std::vector<char*> theirs = {argv[0]};
  std::vector<std::string> ours;
  Arguments arguments;
  std::string nowhere = "--benchmark_out=/dev/null";  // what goes to its file we write
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    arguments.given_min_time = arguments.given_min_time || is_flag(word, "min_time");
    arguments.interleaved = arguments.interleaved || is_flag(word, "enable_random_interleaving");
    if (is_flag(word, "filter") || is_flag(word, "out") || is_flag(word, "list_tests")) {
      ours.push_back(word);
    }
    if (is_flag(word, "")) {
      theirs.push_back(word.starts_with("--benchmark_out=") ? nowhere.data() : argv[k]);
    } else {
      ours.push_back(word);
    }
  }
  int count = static_cast<int>(theirs.size());
  benchmark::Initialize(&count, theirs.data());
  ours.insert(ours.end(), theirs.begin() + 1, theirs.begin() + count);  // unknown: refused below
  std::reverse(ours.begin(), ours.end());                               // as CLI11 wants them
  CLI::App app("Measures the cost per contact of every phase.", "stiction bench");
  define(app, arguments);
  const auto parse = [&] { app.parse(ours); };
  return stiction::run_program(app, parse, [&] {
    stiction::check_environment();  // what cannot be had is refused before anything is measured
    return bench(arguments);
  });
}
