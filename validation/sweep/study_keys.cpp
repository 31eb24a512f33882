// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/study_keys.h"

#include "validation/sweep/study.h"
#include "validation/user/problem_keys.h"

namespace stiction {

namespace study_keys {

namespace {

constexpr const char* kNeeded = "must be given";

}  // namespace

const TomlKeys& file() {
  static const TomlKeys keys = {
      "the study",
      "What stands at the top, before the first table.",
      {{"title", "", "\"text\"", "the file's name", "one line for people"},
       {"problem", "", "\"ramp.toml\"", "`cases`, if not this",
        "a problem of your own, from the folder of this file; what its checks claim is judged at "
        "each point. Without [sweep] and [threshold]"},
       {"cases", "", "[\"incline/restick/*\"]", "`problem`, if not this",
        "cases of the suite, by name; * and ? as in a shell. Their axes are settings of engines"},
       {"engines", "", "[\"stiction\", \"bullet\"]", "[\"stiction\"]",
        "names, or commands of programs that speak the engine protocol"},
       {"engine", "", "tables", "none", "see [[engine]]"},
       {"configurations", "", "[\"default\", \"best\"]", "what each of `engines` does by default",
        "by name, of each engine those that it has; \"all\" takes all. `./stiction engine show "
        "NAME` "
        "lists them"},
       {"keep_series", "", "true or false", "false",
        "whether records keep curves over time, some 8 kB a point"},
       {"axis", "", "tables", kNeeded, "see [[axis]]"},
       {"boundary", "", "a table", "none", "see [boundary]"},
       {"sample", "", "a table", "every combination of the axes' values", "see [sample]"}}};
  return keys;
}

const TomlKeys& engine() {
  static const TomlKeys keys = {
      "[[engine]]",
      "An engine with settings of its own, beside `engines`.",
      {{"name", "", "\"stiction\"", kNeeded, "a name, or the command of a program"},
       {"settings", "", "{ method = \"paper\", rule = \"secant\" }", kNeeded,
        "as `./stiction engine show NAME` lists them; where the problem's file sets the same, that "
        "holds"}}};
  return keys;
}

const TomlKeys& axis() {
  static const TomlKeys keys = {
      "[[axis]]",
      "What varies, and over which values. Values may have units: \"20 deg\".",
      {{"vary", "", "\"ramp.slope_deg\"", kNeeded, problem_keys::kVaries},
       {"values", "", "[10, 20, 30]", "`from`, `to` and `count`", "each of these"},
       {"from", "", "0", "needed without `values`", "the first value"},
       {"to", "", "40", "needed without `values`", "the last value"},
       {"count", "1", "21", "needed with `from`, but with [sample]", "how many, evenly spaced"},
       {"scale", "", "\"linear\" or \"log\"", "\"linear\"", "\"log\": evenly spaced by factors"}}};
  return keys;
}

const TomlKeys& sample() {
  static const TomlKeys keys = {
      "[sample]",
      "Points drawn from the box that the axes' `from` and `to` span, in place of a grid.",
      {{"method", "", "\"sobol\", \"halton\" or \"random\"", "\"sobol\"",
        "the first two fill the box more evenly (GSL)"},
       {"count", "1", "1000", kNeeded, "how many points for each engine"},
       {"seed", "1", "1", "0", "another draw; of a sequence how many points are skipped"}}};
  return keys;
}

const TomlKeys& boundary() {
  static const TomlKeys keys = {
      "[boundary]",
      "Where points must turn from holding to failing. Each engine is judged by its farthest point "
      "of the wrong outcome.",
      {{"along", "", "\"ramp.slope_tan\"", kNeeded, "the axis on which the boundary lies"},
       {"expected", "", "\"ramp.friction\" or 0.5", kNeeded,
        "the axis whose value it is, or a number; what lies on it has no wrong outcome"},
       {"holds", "", "\"below\" or \"above\"", "\"below\"", "on which side points must hold"},
       {"tolerance", "", "0", kNeeded, "how far beyond it an outcome may be wrong"},
       {"reason", "", "\"text\"", kNeeded, "why the tolerance is what it is"},
       {"source", "", "\"text\"", "the study's author", "where the boundary comes from"}}};
  return keys;
}

}  // namespace study_keys

std::string study_help(std::size_t width) {
  return keys_help({&study_keys::file(), &study_keys::engine(), &study_keys::axis(),
                    &study_keys::sample(), &study_keys::boundary()},
                   width);
}

}  // namespace stiction
