// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction sweep`: the points of a study → records, a table, diagrams.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <limits>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "reference/process/interruption.h"
#include "reports/formats/table.h"
#include "reports/record/record_store.h"
#include "reports/screen/command_line.h"
#include "reports/screen/help_page.h"
#include "reports/screen/progress_line.h"
#include "reports/screen/screen.h"
#include "reports/text/text.h"
#include "solver/demand.h"
#include "solver/environment.h"
#include "validation/core/engine_options.h"
#include "validation/core/program.h"
#include "validation/shards/job_list.h"
#include "validation/shards/portion.h"
#include "validation/shards/run_plan.h"
#include "validation/shards/shard.h"
#include "validation/shards/shard_options.h"
#include "validation/sweep/boundary.h"
#include "validation/sweep/earlier_points.h"
#include "validation/sweep/points.h"
#include "validation/sweep/results.h"
#include "validation/sweep/study_estimate.h"

namespace stiction {

namespace {

constexpr std::size_t kMostTold = 10;  // points that broke off; thousands may

struct Arguments {
  std::string study;
  std::string out = "sweep-report";
  std::vector<std::string> share;
  PortionWords portion;
  std::string point;
  bool help_study = false;
  bool dry_run = false;
  bool json = false;
  bool lines = false;
  bool list_engines = false;
  bool retry = false;
  bool fresh = false;
  bool no_page = false;
  double max_seconds = std::numeric_limits<double>::infinity();
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  ProgramLimits limits;
};

HelpPage help_page() {
  return {
      .name = "stiction-sweep",
      .summary = "runs the points of a study: parameters × engines",
      .synopsis = {"./stiction sweep STUDY.toml [OPTIONS]"},
      .description =
          "Runs a problem of your own, or cases, at each of thousands of points: slopes, "
          "frictions, steps, engines. Each point has a name that is a hash of what it is, and a "
          "finished one is never computed again: type the command once more and an interrupted "
          "sweep goes on, or the shards of several machines come together.",
      .exit_codes = {{"0", "every point has a result, whether its checks hold or not"},
                     {"1", "an outcome lies too far beyond the study's [boundary]"},
                     {"2", "could not run: bad input, a point that broke off, a full disk"}},
      .files = {{"sweep-report/STUDY/latest/records.jsonl", "every point, as soon as it is known"},
                {"sweep-report/STUDY/latest/points.csv", "a line a point: axes, verdict, values"}},
      .examples = {{"./stiction sweep --help-study", "all keys of a study's file"},
                   {"./stiction sweep validation/sweep/examples/hold-or-slide.toml --dry-run",
                    "its points, and about how long they take"},
                   {"./stiction sweep study.toml --shard 2/8", "the second of eight parts"}},
      .see_also = {"./stiction help validate", "validation/sweep/README.md"},
      .more = {}};
}

void define(CLI::App& app, Arguments& arguments) {
  app.add_option("study", arguments.study, "The study, a TOML file (--help-study explains it)")
      ->type_name("STUDY");
  app.add_flag("--help-study", arguments.help_study, "Explain the file of a study")
      ->group("What runs");
  app.add_flag("--dry-run", arguments.dry_run,
               "Say which points there are and about how long they take, and end")
      ->group("What runs");
  app.add_flag("--json", arguments.json, "With --dry-run: what a scheduler asks for, as JSON")
      ->group("What runs");
  // ./stiction asks for it, to build those that are programs.
  app.add_flag("--list-engines", arguments.list_engines,
               "Show the names of the study's engines and end")
      ->group("What runs");
  app.add_option(
         "--point", arguments.point,
         "Only the point of this name (points.csv has them), again; shows what it measured and "
         "writes nothing")
      ->type_name("HASH")
      ->group("What runs");
  add_portion(app, arguments.portion);
  app.add_flag("--retry", arguments.retry, "Points that broke off are computed again")
      ->group("What runs");
  app.add_flag(
         "--fresh", arguments.fresh,
         "Every point is computed, whatever is known: an engine's command names its files, not "
         "all that those load")
      ->group("What runs");
  app.add_option("--jobs", arguments.jobs, "Points to run at a time")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str()
      ->group("How it runs");
  app.add_option("--max-seconds", arguments.max_seconds,
                 "A point whose steps take more CPU time is given up, and its record says so")
      ->type_name("S")
      ->check(finite_number(false))
      ->group("How it runs");
  for (CLI::Option* const option : add_engine_limits(app, arguments.limits))
    option->group("How it runs");
  app.add_option("--out", arguments.out,
                 "Folder for the results: in it one for the study, and in that one for each run")
      ->type_name("DIR")
      ->capture_default_str()
      ->group("What is written");
  app.add_option("--share", arguments.share,
                 "Take finished points from runs in this folder too; repeatable")
      ->type_name("DIR")
      ->group("What runs");
  add_lines(app, arguments.lines);
  app.add_flag("--no-page", arguments.no_page,
               "Leave out report.html, which ./stiction makes from the records with node")
      ->group("What is written");
  set_help(app, help_page());
}

Record computed(const Points& points, std::size_t point, const Arguments& arguments) {
  Job job = points.job(point);
  job.cpu_limit = arguments.max_seconds;
  return points.finished(point, run_job(job, 1.0));
}

int run_one(const Points& points, const Arguments& arguments, const Screen& screen) {
  for (std::size_t point = 0; point < points.size(); ++point) {
    if (points.hash(point) != arguments.point) continue;
    const Record record = computed(points, point, arguments);
    show(table_rows(record, screen));
    if (!record.error.empty()) tell(record.case_name + ": " + record.error);
    return record.error.empty() ? kHolds : kCouldNotRun;
  }
  throw InputError(
      fmt::format("the study has no point '{}'; names are of one version of a study and one "
                  "revision of the suite",
                  one_line(arguments.point)));
}

int sweep(const Arguments& arguments) {
  set_program_limits(arguments.limits);
  const Screen screen = screen_of(STDOUT_FILENO);
  if (arguments.help_study) {
    show(study_help(screen.width));
    return kHolds;
  }
  if (arguments.study.empty()) throw InputError("which study? ./stiction sweep STUDY.toml");
  if (arguments.list_engines) {
    for (const std::string& name : engines_named(arguments.study)) show_line(name);
    return kHolds;  // what is wrong with the file is said when it runs
  }
  const Study study = read_study(arguments.study);
  const Points points(study);
  if (arguments.json && !arguments.dry_run) throw InputError("--json goes with --dry-run");
  if (arguments.dry_run) {
    show(arguments.json ? dry_run_json(study, points)
                        : dry_run_screen(study, points, arguments.jobs, screen));
    return kHolds;
  }
  if (!arguments.point.empty()) return run_one(points, arguments, screen);
  const std::string plan = points.plan();
  const std::optional<Parts> parts =
      parts_of({"sweep", {}, plan, points.size(), {}}, arguments.portion);
  const Shard shard = parts ? Shard{} : shard_from(arguments.portion.shard);
  const std::filesystem::path folder = std::filesystem::path(arguments.out) / study.name;
  std::set<std::filesystem::path> earlier;
  if (!arguments.fresh && !parts) earlier = record_files(folder, arguments.share);

  reference::WithLastWords<RecordStore> run([&] { return RecordStore::create(folder); });
  RecordStore& store = *run;
  write_plan(store, {"sweep", arguments.portion.command, plan, points.size(), shard});
  store.wait_for_disk_every(1.0);
  Results results(points.size());
  std::vector<std::size_t> own = shuffled_share(shard, points.size());
  const std::vector<std::size_t> told = own;
  if (shard.count > 1) tell(part_text(shard, own.size(), points.size(), "points"));
  const std::size_t found = parts
                                ? take_parts(*parts, store, points, results)
                                : take_over(earlier, store, points, own, arguments.retry, results);
  std::erase_if(own, [&](std::size_t point) { return results[point].known; });
  if (found > 0 && !parts)
    tell(fmt::format("{} points are known already, {} to go", found, own.size()));
  const auto began = std::chrono::steady_clock::now();
  ProgressLine progress(own.size());
  std::mutex one_at_a_time;
  std::size_t done = 0, broke = 0;
  run_numbered(own.size(), arguments.jobs, [&](std::size_t k) {
    const std::size_t point = own[k];
    const Record record = computed(points, point, arguments);
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    store.append(record);
    results[point] = result_of(record);
    if (arguments.lines) show_result_line(record);
    if (!record.error.empty() && ++broke <= kMostTold) {
      progress.clear();
      tell(record.case_name + ": " + record.error);
    }
    progress.show(++done, record.case_name);
  });
  progress.clear();
  if (broke > kMostTold) {
    tell(fmt::format("{} more points broke off; their records say why", broke - kMostTold));
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  const std::vector<Record> boundaries = boundary_records(study, points, results);
  for (const Record& one : boundaries) store.append(one);
  store.write_file("points.csv", points_csv(study, points, told, results));
  store.finish();
  if (!arguments.lines) {
    const std::string how = parts
                                ? fmt::format("from {} parts", parts->folders().size())
                                : fmt::format("{} computed in {:.3g} s", own.size(), took.count());
    show_line(fmt::format("{}: {} points, {}", study.title, points.size(), how));
    show(results_screen(study, results, screen));
    show(boundary_screen(boundaries, screen));
    show_line("Points: " + (store.folder() / "points.csv").string());
  }
  if (!arguments.no_page) store.tell_caller();
  const bool some_broke = std::any_of(results.begin(), results.end(), [](const PointResult& one) {
    return one.known && one.verdict == Verdict::kError;
  });
  return some_broke ? kCouldNotRun : exit_code(boundaries);
}

}  // namespace

}  // namespace stiction

int main(int argc, char** argv) {
  stiction::reference::end_in_order("stiction sweep");
  CLI::App app("Runs the points of a study.", "stiction sweep");
  stiction::Arguments arguments;
  arguments.portion.command = stiction::words_of(argc, argv);
  stiction::define(app, arguments);
  return stiction::run_program(app, argc, argv, [&] {
    stiction::check_environment();  // what cannot be had is refused before anything runs
    return stiction::sweep(arguments);
  });
}
