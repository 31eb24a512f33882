// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction track`: tells whether a change made something slower, or less
// accurate. benchmarks/TRACKING.md explains how it decides.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "benchmarks/track/campaign.h"
#include "benchmarks/track/child.h"
#include "benchmarks/track/output.h"
#include "benchmarks/track/tree.h"

namespace stiction::track {

namespace {

namespace fs = std::filesystem;

enum ExitCode { kNothingWorse = 0, kRegressed = 1, kCouldNotMeasure = 2, kImproved = 3 };

struct Arguments {
  std::string against;
  std::string root;
  std::string build;
  std::string history;
  bool quick = false;
  bool full = false;
  bool json = false;
  bool markdown = false;
  bool all = false;
  bool report_improvement = false;
  bool no_record = false;
  Scope scope;
};

Project project_of(const Arguments& arguments) {
  Project project;
  project.root = arguments.root.empty()
                     ? last_line(demand_run("this is no clone of stiction",
                                            {"git", "rev-parse", "--show-toplevel"}))
                     : arguments.root;
  project.build =
      arguments.build.empty() ? project.root / "build/release" : fs::absolute(arguments.build);
  project.work = project.root / "build/track";
  return project;
}

int track_against(const Arguments& arguments) {
  const Project project = project_of(arguments);
  const Tree after = present_tree(project);
  const Tree before = build_tree(project, arguments.against);
  const Outcome outcome = compare_trees(project, before, after, arguments.scope);
  if (!arguments.no_record) {
    History history(arguments.history.empty() ? project.work / "history.sqlite"
                                              : fs::path(arguments.history));
    history.add(outcome.before);
    history.add(outcome.after);
  }
  fmt::print("{}", arguments.json       ? json_text(outcome)
                   : arguments.markdown ? markdown(outcome, arguments.all)
                                        : table(outcome, arguments.all));
  if (any(outcome.comparisons, Change::kWorse)) return kRegressed;
  const bool improved = any(outcome.comparisons, Change::kBetter);
  return improved && arguments.report_improvement ? kImproved : kNothingWorse;
}

}  // namespace

}  // namespace stiction::track

int main(int argc, char** argv) {
  using namespace stiction::track;
  CLI::App app("Tells whether a change made something slower, or less accurate.", "stiction track");
  Arguments arguments;
  app.add_option("--against", arguments.against, "The revision to compare with");
  app.add_option("--root", arguments.root);
  app.add_option("--build", arguments.build);
  try {
    app.parse(argc, argv);
    if (arguments.scope.cases.empty()) arguments.scope.cases = {"--quick"};
    return track_against(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kNothingWorse : kCouldNotMeasure;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stiction track: {}\n", error.what());
    return kCouldNotMeasure;
  }
}
