// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction bench`: cost per contact of every phase, how it grows, and what
// optional features cost those who don't use them. benchmarks/README.md explains the figures.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "benchmarks/bench/bench_records.h"
#include "benchmarks/bench/console.h"
#include "benchmarks/bench/fixed.h"
#include "reports/record/environment.h"
#include "reports/record/record_store.h"
#include "reports/text/exit_code.h"
#include "solver/demand.h"

namespace stiction::bench {

namespace {

struct Arguments {
  std::string filter;
  std::string out_file;
  bool list = false;
  bool full = false;
  bool no_features = false;
  bool list_fixed = false;
  bool machine = false;
  std::string fixed;
  int batches = 1;
  std::string out = "bench-report";
};

void define(CLI::App& app, Arguments& arguments) {
  app.add_flag("--full", arguments.full,
               "Up to a million contacts as well: minutes, and gigabytes");
  app.add_flag("--no-features", arguments.no_features,
               "Leave out the table of optional features (as --benchmark_filter does)");
  app.add_option("--out", arguments.out, "Folder for the records; each run gets its own in it")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--benchmark_filter", arguments.filter,
                 "Only benchmarks whose name matches; with '-' in front, only the others")
      ->type_name("REGEX");
  app.add_option("--benchmark_out", arguments.out_file, "Google Benchmark's report as a file too")
      ->type_name("FILE");
  app.add_flag("--list,--benchmark_list_tests", arguments.list, "Show the names and end");
  app.add_flag("--list-fixed", arguments.list_fixed,
               "Show the names of the benchmarks that --fixed takes, and end");
  app.add_flag("--machine", arguments.machine,
               "Print processor, compiler and flags as a line of JSON, and end");
  app.add_option("--fixed", arguments.fixed,
                 "Do one benchmark's work --batches times without a clock, and print a line of "
                 "JSON: for instruction counts")
      ->type_name("NAME");
  app.add_option("--batches", arguments.batches, "How often --fixed does the work")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.footer(
      "Google Benchmark's other flags work too: --benchmark_repetitions=N, "
      "--benchmark_min_time=SECONDS, --benchmark_out_format=json.\n"
      "Exit code: 0 measured, 1 a workload was not at rest, 2 could not run (bad input).");
}

void register_all(const std::vector<Chosen>& chosen, Measure& measure, bool given_min_time) {
  for (const Chosen& one : chosen) {
    auto* const registered = benchmark::RegisterBenchmark(
        one.name.c_str(), [&measure, one](benchmark::State& state) { measure.run(state, one); });
    registered->UseManualTime();
    if (!given_min_time) registered->MinTime(0.02);
  }
}

int write_records(const std::vector<Record>& records, const std::string& out) {
  RecordStore store = RecordStore::create(out);
  int code = kHolds;
  for (const Record& record : records) {
    store.append(record);
    if (record.verdict != Verdict::kFail) continue;
    code = kDoesNotHold;
    const Judgement* const worst = worst_check(record.checks);
    fmt::print(stderr, "stiction bench: {}: {} is {:.3g}, not {:.3g} ± {:.3g} {}\n",
               record.case_name, worst->claim.quantity, worst->value, worst->claim.expected,
               worst->claim.tolerance, worst->worst);
  }
  store.finish();
  fmt::print("\nRecords: {}\n", store.folder().string());
  store.tell_caller();
  return code;
}

int bench(const Arguments& arguments, bool given_min_time) {
  if (arguments.list_fixed) {
    for (const std::string& name : fixed_names()) fmt::print("{}\n", name);
    return kHolds;
  }
  if (arguments.machine) {
    const Environment environment = current_environment();
    const nlohmann::json told = {{"machine", environment.machine},
                                 {"toolchain", environment.toolchain}};
    fmt::print("{}\n", told.dump());
    return kHolds;
  }
  if (!arguments.fixed.empty()) {
    fmt::print("{}\n", run_fixed(arguments.fixed, arguments.batches));
    return kHolds;
  }
  const std::vector<Chosen> chosen = choose(arguments.filter, arguments.full);
  if (arguments.list) {
    for (const Chosen& one : chosen) fmt::print("{}\n", one.name);
    return kHolds;
  }
  const MachinePeak machine = measure_peak();
  benchmark::AddCustomContext("bytes_per_second", fmt::format("{}", machine.bytes_per_second));
  benchmark::AddCustomContext("flops_per_second", fmt::format("{}", machine.flops_per_second));
  Measure measure(machine);
  register_all(chosen, measure, given_min_time);
  Console console(machine);
  JsonFile json;
  // The names were chosen above: Google Benchmark would match "/manual_time" behind them too.
  benchmark::RunSpecifiedBenchmarks(&console, arguments.out_file.empty() ? nullptr : &json, ".");
  const std::vector<Scaling> fits = scalings(measure.results());
  print(fits);
  std::vector<FeatureCost> features;
  if (!arguments.no_features && arguments.filter.empty()) {
    std::string why_not;
    if (auto measured = measure_features(why_not)) {
      features = std::move(*measured);
      print(features);
    } else {
      fmt::print("\nThe cost of optional features was not measured: {}.\n", why_not);
    }
  }
  return write_records(records_of(measure, fits, features), arguments.out);
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
  bool given_min_time = false;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    given_min_time = given_min_time || is_flag(word, "min_time");
    if (is_flag(word, "filter") || is_flag(word, "out") || is_flag(word, "list_tests")) {
      ours.push_back(word);
    }
    if (is_flag(word, "")) {
      theirs.push_back(argv[k]);
    } else {
      ours.push_back(word);
    }
  }
  int count = static_cast<int>(theirs.size());
  benchmark::Initialize(&count, theirs.data());
  ours.insert(ours.end(), theirs.begin() + 1, theirs.begin() + count);  // unknown: refused below
  std::reverse(ours.begin(), ours.end());                               // as CLI11 wants them
  CLI::App app("Measures the cost per contact of every phase.", "stiction bench");
  Arguments arguments;
  define(app, arguments);
  try {
    app.parse(ours);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? stiction::kHolds : stiction::kCouldNotRun;
  }
  try {
    return bench(arguments, given_min_time);
  } catch (const std::exception& error) {
    fmt::print(stderr, "stiction bench: {}\n", error.what());
    return stiction::kCouldNotRun;
  }
}
