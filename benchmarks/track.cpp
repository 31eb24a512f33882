// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction track`: tells whether a change made something slower, or less
// accurate. benchmarks/TRACKING.md explains how it decides.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>

#include "benchmarks/track/command/commands.h"

namespace stiction::track {

namespace {

constexpr const char* kFooter =
    "Exit code: 0 nothing is worse, 1 something is, 2 could not measure (bad input, a revision "
    "that "
    "cannot be built), 3 something is better (with --report-improvement).";

void define_scope(CLI::App& app, Arguments& arguments) {
  app.add_option("--benchmark", arguments.scope.benchmarks,
                 "Only these of `bench --list-fixed`; repeatable")
      ->type_name("GLOB");
  app.add_flag("--quick", arguments.quick, "Of the benchmarks only friction and the whole step");
  app.add_flag("--full", arguments.full, "All cases of a validation, not one of each kind");
  app.add_option("--rounds", arguments.scope.timing.least_rounds,
                 "How often each program is timed, at least")
      ->check(CLI::Range(9, 200))
      ->capture_default_str();
  app.add_flag("--fresh", arguments.scope.fresh,
               "Count and compute anew what is remembered of a program");
  app.add_flag("!--no-times", arguments.scope.times, "Leave the times out");
  app.add_flag("!--no-counts", arguments.scope.counts, "Leave the counts out");
  app.add_flag("!--no-accuracy", arguments.scope.accuracy, "Leave the cases out");
}

void define_output(CLI::App& app, Arguments& arguments) {
  CLI::Option* const json = app.add_flag("--json", arguments.json, "Everything, as JSON");
  app.add_flag("--markdown", arguments.markdown, "A table for a pull request")->excludes(json);
  app.add_flag("--all", arguments.all, "Show metrics that did not change too");
  app.add_flag("--report-improvement", arguments.report_improvement,
               "Exit code 3 when something is better and nothing worse");
  app.add_flag("--any-machine", arguments.scope.any_machine,
               "Compare different processors, compilers or flags too");
}

// A subcommand that runs `function`.
CLI::App& command(CLI::App& app, const char* name, const char* help,
                  int (*function)(const Arguments&), std::function<int(const Arguments&)>& chosen) {
  CLI::App* const sub = app.add_subcommand(name, help);
  sub->callback([&chosen, function] { chosen = function; });
  sub->fallthrough();  // options like --history may stand behind it
  return *sub;
}

void define_commands(CLI::App& app, Arguments& arguments,
                     std::function<int(const Arguments&)>& chosen) {
  CLI::App& record =
      command(app, "record", "Measure the present tree and keep it", track_record, chosen);
  define_scope(record, arguments);
  CLI::App& history =
      command(app, "history", "Show the runs, and metrics over them", track_history, chosen);
  history.add_option("--metric", arguments.metric, "Metrics whose name matches, e.g. '*#time'")
      ->type_name("GLOB");
  history.add_flag("--all", arguments.all, "Show every metric");
  history.add_flag("--any-machine", arguments.scope.any_machine, "Runs of other machines too");
  history
      .add_option("--out", arguments.out,
                  "Write trends as records, for the report page and SVG files")
      ->type_name("DIR");
  CLI::App& compare =
      command(app, "compare", "Compare two runs of the history", track_compare, chosen);
  compare.add_option("before", arguments.other, "Id of a run")->required();
  compare.add_option("after", arguments.run, "Id of a run; without it the last");
  define_output(compare, arguments);
  CLI::App& import = command(app, "import", "Add a file of Google Benchmark's JSON as a run",
                             track_import, chosen);
  import.add_option("file", arguments.file, "'-' is stdin")->required();
  CLI::App& exported =
      command(app, "export", "Write a run as Google Benchmark's JSON", track_export, chosen);
  exported.add_option("file", arguments.file, "'-' is stdout")->required();
  exported.add_option("--run", arguments.run, "Id of the run; without it the last");
  CLI::App& bisect =
      command(app, "bisect", "Find the revision that moved a metric", track_bisect, chosen);
  bisect.add_option("--metric", arguments.metric, "Its name, SUBJECT#WHAT")->required();
  bisect.add_option("--good", arguments.good, "A revision before it moved")->required();
  bisect.add_option("--bad", arguments.bad, "A revision after it moved")->capture_default_str();
}

}  // namespace

}  // namespace stiction::track

int main(int argc, char** argv) {
  using namespace stiction::track;
  CLI::App app("Tells whether a change made something slower, or less accurate.", "stiction track");
  Arguments arguments;
  std::function<int(const Arguments&)> chosen;
  app.add_option("--against", arguments.against,
                 "Build this revision beside the present tree, measure both in turn, and decide")
      ->type_name("REF");
  define_scope(app, arguments);
  define_output(app, arguments);
  app.add_flag("--no-record", arguments.no_record, "Leave the history as it is");
  app.add_option("--history", arguments.history,
                 "The history's SQLite file; without it history.sqlite in that folder")
      ->type_name("FILE");
  app.add_option("--work", arguments.work,
                 "Folder for other revisions and the history; without it build/track")
      ->envname("STICTION_TRACK_WORK")
      ->type_name("DIR");
  app.add_option("--build", arguments.build,
                 "Folder with the present tree's programs; without it build/release")
      ->type_name("DIR");
  app.add_option("--root", arguments.root)->group("");  // set by ./stiction
  app.require_subcommand(0, 1);
  app.footer(kFooter);
  define_commands(app, arguments, chosen);
  try {
    app.parse(argc, argv);
    if (!chosen) {
      if (arguments.against.empty()) {
        throw CLI::RequiredError("--against REF, or a subcommand,");
      }
      chosen = track_against;
    }
    return chosen(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? stiction::kHolds : stiction::kCouldNotRun;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stiction track: {}\n", error.what());
    return stiction::kCouldNotRun;
  }
}
