// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction merge`: the parts of a run → the run, as it is in one piece.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "reports/screen/command_line.h"
#include "reports/screen/help_page.h"
#include "reports/text/names.h"
#include "reports/text/text.h"
#include "solver/demand.h"
#include "solver/environment.h"
#include "validation/shards/parts.h"

namespace stiction {

namespace {

struct Arguments {
  std::vector<std::string> folders;
  std::string out = "merged-report";
  bool no_page = false;
  bool trust = false;
};

HelpPage help_page() {
  return {
      .name = "stiction-merge",
      .summary = "puts the parts of a run together",
      .synopsis = {"./stiction merge DIR... [--out DIR]"},
      .description =
          "Takes the records of the parts that validate, compare or sweep computed with --shard, "
          "on "
          "one machine or several, and writes what the same command writes in one piece: records, "
          "tables, page. Only times differ, and each record says where it was computed. Refuses "
          "parts of different runs, and a run of which something is missing. To be called in the "
          "folder where the parts were: their command's files are read again, to see that they are "
          "the same.",
      .exit_codes = {{"as the run's", "0: every check holds; 1: some check fails"},
                     {"2",
                      "could not run: a part is missing, parts of different runs, a full disk"}},
      .files = {{"merged-report/latest/", "as of the run in one piece"}},
      .examples = {{"./stiction validate --shard 1/2 --out parts", "one half"},
                   {"./stiction validate --shard 2/2 --out parts", "the other, anywhere"},
                   {"./stiction merge parts", "the whole"}},
      .see_also = {"./stiction help validate", "./stiction help sweep",
                   "validation/shards/README.md"},
      .more = {}};
}

// The folders may come from anywhere, and an engine that is a command is started to ask what it is.
// Behind --engine each word up to the next option may be one.
void demand_names(const std::vector<std::string>& words) {
  constexpr std::string_view kOption = "--engine", kNames = "abcdefghijklmnopqrstuvwxyz0123456789_";
  bool names_engines = false;
  for (const std::string& word : words) {
    std::string_view engine = word;
    if (word.starts_with("--")) {
      const std::size_t equals = std::min(word.find('='), word.size());
      names_engines = engine.substr(0, equals) == kOption;
      engine.remove_prefix(std::min(equals + 1, word.size()));
    }
    if (!names_engines || engine.find_first_not_of(kNames) == std::string_view::npos) continue;
    throw InputError(fmt::format(
        "the parts are of the engine '{}', a command that merging starts: --trust allows it",
        one_line(std::string(engine))));
  }
}

std::vector<std::string> command_of(const Parts& parts, const Arguments& arguments) {
  const RunPlan& plan = parts.plan();
  const bool is_sweep = plan.program == "sweep";
  if (!is_sweep && plan.program != "validate" && plan.program != "compare") {
    throw InputError("there is no program '" + one_line(plan.program) +
                     "' whose parts could be merged");
  }
  const std::string missing = parts.missing();
  if (!missing.empty()) {
    throw InputError(missing +
                     (is_sweep ? "; the sweep without --shard computes what is missing" : ""));
  }
  if (!arguments.trust) demand_names(plan.words);
  std::vector<std::string> words = {plan.program};
  words.insert(words.end(), plan.words.begin(), plan.words.end());
  for (const std::string& folder : arguments.folders) {
    words.insert(words.end(), {"--parts", folder});
  }
  words.insert(words.end(), {"--out", arguments.out});
  if (arguments.no_page) words.emplace_back("--no-page");
  return words;
}

// The program goes on as the one that the parts are of.
[[noreturn]] void become(const std::vector<std::string>& words) {
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / words.front();
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  throw std::runtime_error("cannot start '" + program.string() +
                           "': " + std::generic_category().message(errno));
}

}  // namespace

}  // namespace stiction

int main(int argc, char** argv) {
  CLI::App app("Puts the parts of a run together.", "stiction merge");
  stiction::Arguments arguments;
  app.add_option("folder", arguments.folders,
                 "Where the parts are: their own folders, or one that all are in")
      ->type_name("DIR")
      ->required();
  app.add_option("--out", arguments.out, "Folder for the results, as of the run")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_flag("--no-page", arguments.no_page,
               "Leave out report.html, which ./stiction makes from the records with node");
  app.add_flag(
      "--trust", arguments.trust,
      "Start the engine of the parts where it is a command, as run.json in their folders has it");
  stiction::set_help(app, stiction::help_page());
  return stiction::run_program(app, argc, argv, [&]() -> int {
    stiction::check_environment();
    stiction::become(stiction::command_of(stiction::Parts(arguments.folders), arguments));
  });
}
