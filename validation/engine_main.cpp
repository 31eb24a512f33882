// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction engine`: what engines there are, what one is and can, and whether
// its adapter speaks right.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "reference/process/interruption.h"
#include "reports/screen/command_line.h"
#include "reports/screen/help_page.h"
#include "reports/text/exit_code.h"
#include "solver/demand.h"
#include "solver/environment.h"
#include "validation/core/engine_options.h"
#include "validation/core/program.h"
#include "validation/engine/conformance/conformance.h"
#include "validation/engine/conformance/protocol_cost.h"
#include "validation/engine/engine.h"

namespace stiction {

namespace {

struct Arguments {
  std::string engine;
  std::vector<std::string> settings;
  ProgramLimits limits;
};

ExitCode list_engines() {
  for (const EngineKind& kind : engine_catalog()) {
    show_line(fmt::format("{:<20} {}", kind.name, kind.description));
  }
  for (const EngineProgram& one : engine_programs()) {
    try {
      show_line(fmt::format("{:<20} {}", one.name, find_engine(one.name).description));
    } catch (const std::exception&) {
      show_line(fmt::format("{:<20} not built yet; from Debian's {}", one.name, one.packages));
    }
  }
  return kHolds;
}

std::string text_of(const Settings& settings) {
  std::string text;
  for (const auto& [name, value] : settings) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value);
  }
  return text;
}

ExitCode show_engine(const Arguments& arguments) {
  const EngineKind kind = find_engine(arguments.engine);
  show_line(fmt::format("{}: {}", kind.name, kind.description));
  if (!kind.settings_help.empty()) show("\nSettings (--set NAME=VALUE):\n");
  for (const auto& [name, meaning] : kind.settings_help) {
    show_line(fmt::format("  {:<18} {}", name, meaning));
  }
  if (kind.configurations) {
    show("\nConfigurations:\n");
    for (const Configuration& one : kind.configurations("")) {
      show_line(fmt::format("  {:<18} {}", one.name, text_of(one.settings)));
      if (!one.source.empty()) show_line(fmt::format("  {:<18} {}", "", one.source));
    }
  }
  if (!kind.ladder.empty()) show("\nEfforts:\n");
  for (const Settings& one : kind.ladder) show_line(fmt::format("  {}", text_of(one)));
  return kHolds;
}

ExitCode check(const Arguments& arguments) {
  const EngineKind kind = find_engine(arguments.engine);
  show_line(fmt::format("{}: {}", kind.name, kind.description));
  show("\n");
  ExitCode code = kHolds;
  int failed = 0, held = 0;
  for (const Finding& one : check_conformance(kind, parse_settings(arguments.settings))) {
    const bool fails = one.conformity == Conformity::kFails;
    const char* const word = fails ? "FAIL" : one.conformity == Conformity::kHolds ? "ok" : "n/a";
    failed += fails ? 1 : 0;
    held += one.conformity == Conformity::kHolds ? 1 : 0;
    if (fails) code = kDoesNotHold;
    show_line(fmt::format("{:<5} {:<24} {}", word, one.name, one.sentence));
  }
  if (!kind.program.empty() && failed == 0) {
    const ProtocolCost cost = protocol_cost(kind, parse_settings(arguments.settings));
    show(fmt::format(
        "\nThe protocol: a request takes {:.0f} µs, of which {:.0f} µs are CPU time of the "
        "engine's "
        "process; an observation {:.0f} µs. A step with a body on the ground takes {:.3g} µs of "
        "CPU "
        "time.\n",
        1e6 * cost.request, 1e6 * cost.request_cpu, 1e6 * cost.observation, 1e6 * cost.step_cpu));
  }
  show(fmt::format("\n{} checks hold, {} fail{}\n", held, failed,
                   failed > 0 ? ": such an engine is not graded" : ""));
  return code;
}

void define_help(CLI::App& app, CLI::App& list, CLI::App& show, CLI::App& check) {
  const std::vector<std::string> see_also = {
      "./stiction help validate", "./stiction compare engines --help",
      "validation/engine/kit/README.md (how to write an engine)",
      "validation/engine/protocol/README.md"};
  const std::vector<std::pair<std::string, std::string>> codes = {
      {"0", "done; every check holds"},
      {"1", "a check fails"},
      {"2", "could not run: no such engine"}};
  set_help(
      app,
      {.name = "stiction-engine",
       .summary = "what engines there are, and whether an adapter speaks right",
       .synopsis = {"./stiction engine check NAME|COMMAND [OPTIONS]",
                    "./stiction engine show NAME|COMMAND", "./stiction engine list"},
       .description =
           "An engine is a program in any language that speaks a small protocol over pipes, or one "
           "that is built in. These commands list those that the project knows, show what one can "
           "be given, and try an adapter against known answers before anything is graded.",
       .exit_codes = codes,
       .examples = {{"./stiction engine list", "what there is"},
                    {"./stiction engine show bullet", "its settings and configurations"},
                    {"./stiction engine check \"python3 my_engine.py\"", "does it speak right?"}},
       .see_also = see_also});
  set_help(
      list,
      {.name = "stiction-engine-list",
       .summary = "the engines that this project knows",
       .synopsis = {"./stiction engine list"},
       .description = "Prints a line an engine: its name and what it is. Those that are not built "
                      "yet are named with the Debian packages that they are built from.",
       .exit_codes = codes,
       .examples = {{"./stiction engine list", "all of them"},
                    {"./stiction engine list | grep -i double", "some"},
                    {"./stiction validate --engine bullet --quick", "validate one of them"}},
       .see_also = see_also});
  set_help(show,
           {.name = "stiction-engine-show",
            .summary = "settings, configurations and efforts of an engine",
            .synopsis = {"./stiction engine show NAME|COMMAND"},
            .description = "Prints what --set can change, the configurations that the engine is "
                           "validated in with the source of each, and its ladder of efforts.",
            .exit_codes = codes,
            .examples = {{"./stiction engine show stiction", "this project's solver"},
                         {"./stiction engine show mujoco", "another"},
                         {"./stiction engine show ./my_engine", "one of your own"}},
            .see_also = see_also});
  set_help(
      check,
      {.name = "stiction-engine-check",
       .summary = "tries an adapter against known answers",
       .synopsis = {"./stiction engine check NAME|COMMAND [--set NAME=VALUE]... [OPTIONS]"},
       .description = "Talks to the engine as the cases will: signs, frames, units, time, loads, "
                      "contacts, whether an answer repeats. Each failure is one sentence; an "
                      "engine with one is not graded.",
       .exit_codes = codes,
       .examples = {{"./stiction engine check ./my_engine", "a program"},
                    {"./stiction engine check \"python3 my_engine.py\" --set dt=1e-4",
                     "a script, with a setting"},
                    {"./stiction engine check ode", "one that comes with the project"}},
       .see_also = see_also});
}

}  // namespace

}  // namespace stiction

int main(int argc, char** argv) {
  stiction::reference::end_in_order("stiction engine");
  CLI::App app("Engines, and whether an adapter speaks right.", "stiction engine");
  stiction::Arguments arguments;
  app.require_subcommand(1);
  CLI::App* const list = app.add_subcommand("list", "The engines that this project knows");
  CLI::App* const show = app.add_subcommand("show", "Settings, configurations and efforts of one");
  CLI::App* const check = app.add_subcommand(
      "check", "Try an adapter against known answers; each failure in one sentence");
  for (CLI::App* const one : {show, check}) {
    one->add_option("engine", arguments.engine,
                    "A name, or a program that speaks the engine protocol "
                    "(validation/engine/protocol/README.md)")
        ->required();
    for (CLI::Option* const limit : stiction::add_engine_limits(*one, arguments.limits)) {
      limit->group("How it runs");
    }
  }
  check->add_option("--set", arguments.settings, "A setting of the engine")
      ->type_name("NAME=VALUE")
      ->group("How it runs");
  stiction::define_help(app, *list, *show, *check);
  return stiction::run_program(app, argc, argv, [&] {
    stiction::check_environment();  // what cannot be had is refused before anything runs
    stiction::set_program_limits(arguments.limits);
    return list->parsed()   ? stiction::list_engines()
           : show->parsed() ? stiction::show_engine(arguments)
                            : stiction::check(arguments);
  });
}
