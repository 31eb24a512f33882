// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction track`: tells whether a change made something slower, or less
// accurate. benchmarks/TRACKING.md explains how it decides.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>

#include "benchmarks/track/command/commands.h"
#include "benchmarks/track/store/history.h"
#include "benchmarks/track/store/scratch.h"
#include "reference/process/interruption.h"
#include "reports/record/whole_file.h"
#include "reports/screen/command_line.h"
#include "reports/screen/help_page.h"

namespace stiction::track {

namespace {

constexpr const char* kWhat = "What is measured";
constexpr const char* kShown = "What is shown";
constexpr const char* kWhere = "Where";

const std::vector<std::pair<std::string, std::string>> kExitCodes = {
    {"0", "nothing is worse"},
    {"1", "something is"},
    {"2", "could not measure: bad input, a revision that cannot be built; or could not keep it"},
    {"3", "something is better and nothing worse (with --report-improvement)"}};

void define_scope(CLI::App& app, Arguments& arguments) {
  app.add_option("--benchmark", arguments.scope.benchmarks,
                 "Only these of `bench --list-fixed`; repeatable")
      ->type_name("GLOB")
      ->group(kWhat);
  app.add_flag("--quick", arguments.quick, "Of the benchmarks only friction and the whole step")
      ->group(kWhat);
  app.add_flag("--full", arguments.full, "All cases of a validation, not one of each kind")
      ->group(kWhat);
  app.add_option("--rounds", arguments.scope.timing.least_rounds,
                 "How often each program is timed, at least")
      ->type_name("N")
      ->check(CLI::Range(9, 200))
      ->capture_default_str()
      ->group(kWhat);
  app.add_flag("--fresh", arguments.scope.fresh,
               "Count and compute anew what is remembered of a program")
      ->group(kWhat);
  app.add_flag("!--no-times", arguments.scope.times, "Leave the times out")->group(kWhat);
  app.add_flag("!--no-counts", arguments.scope.counts, "Leave the counts out")->group(kWhat);
  app.add_flag("!--no-accuracy", arguments.scope.accuracy, "Leave the cases out")->group(kWhat);
}

void define_output(CLI::App& app, Arguments& arguments) {
  app.add_flag("--verbose", arguments.verbose,
               "A table of times and instructions that did not change too")
      ->group(kShown);
  app.add_flag("--all", arguments.all, "A table of every metric")->group(kShown);
  CLI::Option* const json =
      app.add_flag("--json", arguments.json, "Everything, as JSON")->group(kShown);
  app.add_flag("--markdown", arguments.markdown, "A table for a pull request")
      ->excludes(json)
      ->group(kShown);
  app.add_flag("--report-improvement", arguments.report_improvement,
               "Exit code 3 when something is better and nothing worse")
      ->group(kShown);
  app.add_flag("--any-machine", arguments.scope.any_machine,
               "Compare different processors, compilers or flags too")
      ->group(kShown);
}

// The page of a subcommand; the options before it, like --history, are those of `track`.
void help_of(CLI::App& sub, const std::string& synopsis, const std::string& description,
             std::vector<std::pair<std::string, std::string>> examples) {
  set_help(sub, {.name = "stiction-track-" + sub.get_name(),
                 .summary = sub.get_description(),
                 .synopsis = {"./stiction track " + sub.get_name() + " " + synopsis},
                 .description = description,
                 .exit_codes = kExitCodes,
                 .files = {{"build/track/history.sqlite",
                            "the history, unless --history names another (benchmarks/schema.md)"}},
                 .examples = std::move(examples),
                 .see_also = {"./stiction help track", "benchmarks/TRACKING.md"}});
}

HelpPage help_page() {
  return {
      .name = "stiction-track",
      .summary = "whether a change made something slower, or less accurate",
      .synopsis = {"./stiction track --against REF [OPTIONS]",
                   "./stiction track COMMAND [OPTIONS]"},
      .description =
          "Builds another revision beside the present tree, measures both in turn (CPU times, "
          "counted "
          "instructions, digits and verdicts of validation cases) and decides by tests what "
          "changed. "
          "Prints what is worse and what is better, each with its evidence and the command that "
          "measures "
          "it again; a speed-up that costs digits is worse.",
      .exit_codes = kExitCodes,
      .files = {{"build/track/history.sqlite",
                 "every run, unless --no-record (benchmarks/schema.md)"},
                {"build/track/REVISION/", "other revisions and their builds"},
                {"sizes-report/latest/", "what `sizes` measured: records and their page"}},
      .examples =
          {{"./stiction track --against main", "the present tree against main"},
           {"./stiction track --against main --quick --markdown",
            "friction and whole steps only, as a table for a pull request"},
           {"./stiction track bisect --metric 'step/slab/contacts:1000#instructions' --good v0.1",
            "which revision made a step dearer"}},
      .see_also = {"./stiction help bench", "./stiction track COMMAND --help",
                   "benchmarks/TRACKING.md (how it decides)"}};
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
  help_of(record, "[OPTIONS]",
          "Measures the present tree alone and adds it to the history as a run of its own, so that "
          "trends and later comparisons have it.",
          {{"./stiction track record", "everything"},
           {"./stiction track record --quick", "friction and whole steps only"},
           {"./stiction track record --no-times", "what is deterministic, on a busy machine"}});
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
  help_of(
      history, "[--metric GLOB] [--out DIR] [OPTIONS]",
      "Lists the runs of this machine with their revisions, and metrics over them. With --out it "
      "writes trends as records, of which ./stiction makes a page.",
      {{"./stiction track history", "the runs"},
       {"./stiction track history --metric 'step/*#time'", "times of whole steps over them"},
       {"./stiction track history --out trends", "every trend as a page"}});
  CLI::App& compare =
      command(app, "compare", "Compare two runs of the history", track_compare, chosen);
  compare.add_option("before", arguments.other, "Id of a run")->required();
  compare.add_option("after", arguments.run, "Id of a run; without it the last");
  define_output(compare, arguments);
  help_of(compare, "BEFORE [AFTER] [OPTIONS]",
          "Compares two runs of the history as --against does, without measuring anything. Ids are "
          "those that `history` lists.",
          {{"./stiction track compare 12", "run 12 with the last"},
           {"./stiction track compare 12 13 --all", "every metric of two runs"},
           {"./stiction track compare 12 13 --json", "for a program"}});
  CLI::App& import = command(app, "import", "Add a file of Google Benchmark's JSON as a run",
                             track_import, chosen);
  import.add_option("file", arguments.file, "'-' is stdin")->required();
  help_of(
      import, "FILE",
      "Adds what another program has measured, as Google Benchmark's JSON, to the history as a "
      "run. "
      "Its machine is that of the file.",
      {{"./stiction track import results.json", "a file"},
       {"my_bench --benchmark_format=json | ./stiction track import -", "from a pipe"},
       {"./stiction track import results.json --history other.sqlite", "into another history"}});
  CLI::App& exported =
      command(app, "export", "Write a run as Google Benchmark's JSON", track_export, chosen);
  exported.add_option("file", arguments.file, "'-' is stdout")->required();
  exported.add_option("--run", arguments.run, "Id of the run; without it the last");
  help_of(
      exported, "FILE [--run ID]",
      "Writes a run of the history as Google Benchmark's JSON, which other trackers read. What it "
      "writes `import` reads.",
      {{"./stiction track export run.json", "the last run"},
       {"./stiction track export run.json --run 12", "another"},
       {"./stiction track export - | jq .benchmarks", "to a pipe"}});
  CLI::App& bisect =
      command(app, "bisect", "Find the revision that moved a metric", track_bisect, chosen);
  bisect.add_option("--metric", arguments.metric, "Its name, SUBJECT#WHAT")->required();
  bisect.add_option("--good", arguments.good, "A revision before it moved")->required();
  bisect.add_option("--bad", arguments.bad, "A revision after it moved")->capture_default_str();
  help_of(
      bisect, "--metric NAME --good REF [--bad REF]",
      "Builds and measures revisions between a good and a bad one until it has found the one that "
      "moved a metric. Those that cannot be built are stepped over and told.",
      {{"./stiction track bisect --metric 'step/slab/contacts:1000#instructions' --good v0.1",
        "which revision changed the instructions of a step"},
       {"./stiction track bisect --metric 'depth/slab/contacts:1000#time' --good v0.1",
        "which one changed a time"},
       {"./stiction track bisect --metric 'half-space/free-fall#verdict' --good HEAD~20 --bad "
        "HEAD~2",
        "which one broke a case"}});
}

void define_sizes(CLI::App& app, Arguments& arguments,
                  std::function<int(const Arguments&)>& chosen) {
  CLI::App& sizes =
      command(app, "sizes", "Whole steps of another revision and the present one, of all sizes",
              track_sizes, chosen);
  sizes
      .add_option("--threads", arguments.threads, "Threads inside a step, to be compared with one")
      ->type_name("N")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  sizes.add_flag("--full", arguments.full, "Workloads of up to a million contacts too");
  sizes
      .add_option("--out", arguments.out,
                  "Where the records and their page go; without it sizes-report")
      ->type_name("DIR");
  set_help(
      sizes,
      {.name = "stiction-track-sizes",
       .summary = sizes.get_description(),
       .synopsis = {"./stiction track sizes --against REF [--benchmark GLOB] [OPTIONS]"},
       .description =
           "Has steps that go on taken in turn by another revision, by the present one, by that "
           "in narrower registers and on more threads, for all sizes of bench's workloads; "
           "tells what whole steps and their phases cost, beside what the machine's bandwidth "
           "and arithmetic allow. Scenes and clock are the present tree's "
           "(benchmarks/yardstick/), whatever the other's bench timed. It decides nothing, and "
           "leaves the history as it is.",
       .exit_codes = {{"0", "all was at rest, and registers and threads left the same states"},
                      {"1", "something was not, or they did not"},
                      {"2", "could not measure: bad input, a revision that cannot be built"}},
       .files = {{"sizes-report/latest/records.jsonl", "the records, one a family and way"},
                 {"sizes-report/latest/report.html", "their page: cost over contacts"},
                 {"build/track/REVISION/", "other revisions and their builds"}},
       .examples = {{"./stiction track sizes --against HEAD~20",
                     "all default sizes, up to an hour"},
                    {"./stiction track sizes --against main --benchmark 'step/slab/*'",
                     "one family"},
                    {"./stiction track sizes --against main --full --benchmark "
                     "'*/contacts:1000000'",
                     "a million contacts"}},
       .see_also = {"./stiction help track", "benchmarks/TRACKING.md (what is measured)"}});
}

std::string last_words() {
  stiction::end_writing();
  return History::added() == 0 ? "; nothing of it is in the history"
                               : "; what was measured is in the history";
}

}  // namespace

}  // namespace stiction::track

int main(int argc, char** argv) {
  using namespace stiction::track;
  stiction::reference::end_in_order("stiction track");
  forget_git_variables();
  CLI::App app("Tells whether a change made something slower, or less accurate.", "stiction track");
  Arguments arguments;
  std::function<int(const Arguments&)> chosen;
  app.add_option("--against", arguments.against,
                 "Build this revision beside the present tree, measure both in turn, and decide")
      ->type_name("REF")
      ->group(kWhat);
  define_scope(app, arguments);
  define_output(app, arguments);
  app.add_flag("--no-record", arguments.no_record, "Leave the history as it is")->group(kWhere);
  app.add_option("--history", arguments.history,
                 "The history's SQLite file; without it history.sqlite in --work")
      ->type_name("FILE")
      ->group(kWhere);
  app.add_option("--work", arguments.work,
                 "Folder for other revisions and the history; without it build/track")
      ->envname("STICTION_TRACK_WORK")
      ->type_name("DIR")
      ->group(kWhere);
  app.add_option("--build", arguments.build,
                 "Folder with the present tree's programs; without it build/release")
      ->type_name("DIR")
      ->group(kWhere);
  app.add_option("--root", arguments.root)->group("");  // set by ./stiction
  app.require_subcommand(0, 1);
  set_help(app, help_page());
  define_commands(app, arguments, chosen);
  define_sizes(app, arguments, chosen);
  const auto parse = [&] {
    app.parse(argc, argv);
    if (chosen) return;
    if (arguments.against.empty()) throw CLI::RequiredError("--against REF, or a subcommand,");
    chosen = track_against;
  };
  return stiction::run_program(app, parse, [&] {
    const stiction::reference::LastWords words(last_words, [] { Scratch::remove_all(); });
    return chosen(arguments);
  });
}
