// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <utility>

#include "reports/text/names.h"
#include "reports/text/text.h"
#include "solver/demand.h"
#include "validation/core/runner.h"
#include "validation/sweep/study_keys.h"
#include "validation/user/quantity.h"

namespace stiction {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPoints = 10'000'000;

std::size_t read_count(TomlTable& table, const std::string& key, std::size_t most,
                       std::size_t least = 1) {
  const double count = table.number(key);
  if (!(count >= static_cast<double>(least) && count <= static_cast<double>(most)) ||
      count != std::floor(count)) {
    table.refuse(key, fmt::format("'{}' must be a whole number from {} to {}", key, least, most));
  }
  return static_cast<std::size_t>(count);
}

std::vector<double> spaced(const Axis& axis, std::size_t count) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = count == 1 ? 0.0 : static_cast<double>(k) / static_cast<double>(count - 1);
    // 0.15, not 0.15000000000000002: names are made of them.
    values.push_back(std::stod(fmt::format("{:.12g}", at_share(axis, share))));
  }
  return values;
}

[[noreturn]] void refuse_more_points(TomlTable& table) {
  table.refuse("vary", fmt::format("the study has more than {} points", kMostPoints));
}

// `room`: how many values it may have at most.
Axis read_axis(TomlTable& table, const std::shared_ptr<const ParsedFile>& problem, bool samples,
               std::size_t room) {
  const UserVariation varied = read_variation(table, problem);
  Axis axis{varied.what, varied.unit.empty() ? "1" : varied.unit, {}, 0.0, 0.0, false};
  if (!samples && table.has("values")) {
    axis.values = table.numbers_in(varied.unit, "values");
    if (axis.values.empty()) table.refuse("values", "'values' needs at least one number");
    if (std::set<double>(axis.values.begin(), axis.values.end()).size() != axis.values.size()) {
      table.refuse("values", "a value is given twice");
    }
    table.finish();
    return axis;
  }
  axis.from = table.number_in(varied.unit, "from");
  axis.to = table.number_in(varied.unit, "to");
  if (axis.from == axis.to) table.refuse("to", "'from' and 'to' must not be the same");
  const std::string scale = table.text("scale", "linear");
  if (scale != "linear" && scale != "log") {
    table.refuse("scale", "'scale' is \"linear\" or \"log\"");
  }
  axis.log = scale == "log";
  if (axis.log && !(axis.from * axis.to > 0.0)) {
    table.refuse("scale",
                 "a scale by factors needs 'from' and 'to' of one sign, neither of them 0");
  }
  if (!samples) {
    const std::size_t count = read_count(table, "count", kMostPoints);
    if (count > room) refuse_more_points(table);
    axis.values = spaced(axis, count);
    if (std::set<double>(axis.values.begin(), axis.values.end()).size() != count) {
      table.refuse("count", "so many values between 'from' and 'to' are the same to twelve digits");
    }
  }
  table.finish();
  return axis;
}

Samples read_samples(TomlTable table, std::size_t dimensions, std::size_t room) {
  Samples samples;
  const std::string method = table.text("method", "sobol");
  if (method == "sobol") {
    samples.method = reference::Sampling::kSobol;
  } else if (method == "halton") {
    samples.method = reference::Sampling::kHalton;
  } else if (method == "random") {
    samples.method = reference::Sampling::kRandom;
  } else {
    table.refuse("method", "'method' is \"sobol\", \"halton\" or \"random\"");
  }
  samples.count = read_count(table, "count", room);
  if (table.has("seed")) samples.seed = read_count(table, "seed", 1'000'000, 0);
  try {
    reference::unit_samples(samples.method, dimensions, 1, 0);
  } catch (const std::invalid_argument& error) {
    table.refuse("method", error.what());
  }
  table.finish();
  return samples;
}

std::size_t find_axis(TomlTable& table, const std::string& key, const Study& study) {
  const std::string name = table.text(key);
  for (std::size_t k = 0; k < study.axes.size(); ++k) {
    if (study.axes[k].vary == name) return k;
  }
  const auto name_of = [](const Axis& axis) { return axis.vary; };
  table.refuse(key, fmt::format("no axis varies '{}'; there are: {}", name,
                                listed_names(study.axes, name_of)));
}

Boundary read_boundary(TomlTable table, const Study& study) {
  Boundary boundary;
  boundary.along = find_axis(table, "along", study);
  const Axis& along = study.axes[boundary.along];
  std::string expected;
  if (table.is_text("expected")) {
    boundary.axis = find_axis(table, "expected", study);
    const Axis& other = study.axes[*boundary.axis];
    if (*boundary.axis == boundary.along || other.unit != along.unit) {
      table.refuse("expected",
                   "a boundary is expected at the value of another axis in the same unit");
    }
    expected = other.vary;
  } else {
    boundary.value = table.number_in(along.unit, "expected");
    expected = fmt::format("{:g}", boundary.value);
  }
  const std::string holds = table.text("holds", "below");
  if (holds != "below" && holds != "above") {
    table.refuse("holds", "'holds' is \"below\" or \"above\"");
  }
  boundary.holds_above = holds == "above";
  Claim& claim = boundary.claim;
  claim.quantity = "farthest wrong outcome";
  claim.unit = shown_unit(along.unit);
  claim.statement =
      fmt::format("points hold {} {} = {}, and fail beyond it", holds, along.vary, expected);
  claim.kind = ReferenceKind::kExternal;
  claim.tolerance = table.number_in(along.unit, "tolerance");
  if (!(claim.tolerance >= 0.0)) table.refuse("tolerance", "'tolerance' must not be negative");
  claim.reason = table.text("reason");
  claim.source = table.text("source", "the study's author");
  table.finish();
  return boundary;
}

EngineKind find_engine_of(TomlTable& table, const std::string& key, const std::string& words) {
  try {
    return find_engine(words);
  } catch (const InputError& error) {
    table.refuse(key, error.what());
  }
}

// The engine in those of its configurations that are asked for; `found` gets their names.
void add_engine(TomlTable& top, Study& study, const std::string& words,
                const std::vector<std::string>& wanted, std::set<std::string>& found) {
  const EngineKind kind = find_engine_of(top, "engines", words);
  const bool all = wanted.size() == 1 && wanted.front() == "all";
  const std::size_t before = study.engines.size();
  if (!wanted.empty() && kind.configurations) {
    for (const Configuration& one : kind.configurations("")) {
      const std::string name = called_configuration(kind, "", one.settings).name;
      if (!all && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
      found.insert(name);
      study.engines.push_back({kind, one.settings, name});
    }
  }
  if (study.engines.size() > before) return;
  if (!wanted.empty() && !all) {
    top.refuse("configurations",
               fmt::format("engine '{}' has none of these configurations", kind.name));
  }
  study.engines.push_back({kind, {}, ""});
}

// One with settings of its own.
void add_engine(TomlTable table, Study& study) {
  const EngineKind kind = find_engine_of(table, "name", table.text("name"));
  StudyEngine one{kind, {}, ""};
  for (auto& [name, value] : table.settings("settings")) one.settings[name] = value;
  try {
    kind.make(one.settings);
  } catch (const InputError& error) {
    table.refuse("settings", error.what());
  }
  one.configuration = called_configuration(kind, "", one.settings).name;
  study.engines.push_back(std::move(one));
  table.finish();
}

void read_engines(TomlTable& top, Study& study) {
  for (TomlTable& table : top.tables("engine", study_keys::engine())) add_engine(table, study);
  std::vector<std::string> engines, wanted;
  if (top.has("engines")) engines = top.texts("engines");
  if (engines.empty() && study.engines.empty()) engines = {"stiction"};
  if (!engines.empty() && top.is_text("configurations")) {
    wanted = {top.text("configurations")};
  } else if (!engines.empty() && top.has("configurations")) {
    wanted = top.texts("configurations");
  }
  std::set<std::string> found;
  for (const std::string& words : engines) add_engine(top, study, words, wanted, found);
  for (const std::string& name : wanted) {
    if (name == "all" || found.count(name) > 0) continue;
    top.refuse("configurations", fmt::format("no engine has a configuration '{}'", name));
  }
}

void read_cases(TomlTable& top, Study& study) {
  const std::vector<Case> catalog = case_catalog();
  for (const std::string& glob : top.texts("cases")) {
    const std::size_t before = study.cases.size();
    for (const Case& one : catalog) {
      if (!matches(glob, one.name)) continue;
      const bool known = std::any_of(study.cases.begin(), study.cases.end(),
                                     [&](const Case& other) { return other.name == one.name; });
      if (!known) study.cases.push_back(one);
    }
    if (study.cases.size() == before) {
      top.refuse("cases",
                 "no further case matches '" + glob + "'; ./stiction validate --list shows them");
    }
  }
}

std::shared_ptr<const ParsedFile> read_problem_of(TomlTable& top) {
  const fs::path file = top.folder() / top.text("problem");
  std::ifstream stream(file);
  if (!stream || fs::is_directory(file)) {
    top.refuse("problem", "cannot read '" + file.string() + "'");
  }
  const auto parsed = parse_toml(stream, file);
  for (const char* const own : {"sweep", "threshold"}) {
    if (!parsed->root.contains(own)) continue;
    top.refuse("problem", fmt::format("'{}' has a [{}] of its own; of a study's problem the study "
                                      "says what varies",
                                      file.string(), own));
  }
  read_parsed(parsed->file, parsed->root);  // what is wrong with it is said now
  return parsed;
}

// Cases have no file: their axes are settings of engines.
std::shared_ptr<const ParsedFile> no_problem() { return std::make_shared<ParsedFile>(); }

// A point that is there twice has one name.
void refuse_twice(TomlTable& top, const Study& study) {
  for (std::size_t k = 0; k < study.engines.size(); ++k) {
    for (std::size_t other = 0; other < k; ++other) {
      const StudyEngine &a = study.engines[k], &b = study.engines[other];
      const bool same = a.kind.name == b.kind.name && a.kind.program == b.kind.program &&
                        a.settings == b.settings;
      if (same) top.refuse("engines", "'" + name_of(a) + "' is given twice");
    }
  }
}

}  // namespace

std::string name_of(const StudyEngine& engine) {
  return engine.configuration.empty() ? engine.kind.name
                                      : engine.kind.name + ", " + engine.configuration;
}

double at_share(const Axis& axis, double share) {
  if (!axis.log) return axis.from + share * (axis.to - axis.from);
  return axis.from * std::pow(axis.to / axis.from, share);
}

std::size_t Study::designs() const {
  if (samples) return samples->count;
  std::size_t count = 1;
  for (const Axis& axis : axes) count *= axis.values.size();
  return count;
}

std::size_t Study::size() const {
  return designs() * engines.size() * std::max<std::size_t>(1, cases.size());
}

Study read_study(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream || fs::is_directory(file)) {
    throw InputError("cannot read '" + one_line(file.string()) + "'");
  }
  const auto parsed = parse_toml(stream, file);
  TomlTable top(parsed->file, parsed->root, study_keys::file());
  Study study;
  study.file = file;
  study.name = one_line(file.stem().string());
  study.title = one_line(top.text("title", study.name));
  if (top.has("problem") == top.has("cases")) {
    top.refuse("problem", "a study has a 'problem' or 'cases', one of them");
  }
  if (top.has("problem")) {
    study.problem = read_problem_of(top);
    study.problem_name = one_line(fs::path(top.text("problem")).stem().string());
  } else {
    read_cases(top, study);
  }
  read_engines(top, study);
  const bool samples = top.has("sample");
  const auto varied = study.problem ? study.problem : no_problem();
  std::set<std::string> names;
  std::size_t room =
      kMostPoints / std::max<std::size_t>(1, study.cases.size()) / study.engines.size();
  for (TomlTable& table : top.tables("axis", study_keys::axis())) {
    study.axes.push_back(read_axis(table, varied, samples, room));
    const Axis& axis = study.axes.back();
    if (!names.insert(axis.vary).second) {
      table.refuse("vary", "'" + axis.vary + "' varies on another axis too");
    }
    if (!study.problem && !axis.vary.starts_with("engine.")) {
      table.refuse("vary", "of cases the settings of an engine vary: engine.KEY");
    }
    room /= std::max<std::size_t>(1, axis.values.size());
    if (room == 0) refuse_more_points(table);
  }
  refuse_twice(top, study);
  if (study.axes.empty()) top.refuse("axis", "a study needs an [[axis]]");
  if (samples)
    study.samples =
        read_samples(top.table("sample", study_keys::sample()), study.axes.size(), room);
  if (top.has("boundary")) {
    study.boundary = read_boundary(top.table("boundary", study_keys::boundary()), study);
  }
  study.keeps_series = top.flag("keep_series", false);
  top.finish();
  return study;
}

std::vector<std::string> engines_named(const fs::path& file) {
  std::ifstream stream(file);
  std::shared_ptr<const ParsedFile> parsed = no_problem();
  try {
    parsed = parse_toml(stream, file);
  } catch (const InputError&) {
    return {};
  }
  std::vector<std::string> names;
  const auto add = [&](const toml::node* node) {
    if (node != nullptr && node->is_string()) names.push_back(node->as_string()->get());
  };
  if (const toml::array* const list = parsed->root["engines"].as_array()) {
    for (const toml::node& one : *list) add(&one);
  }
  if (const toml::array* const tables = parsed->root["engine"].as_array()) {
    for (const toml::node& one : *tables) {
      if (one.is_table()) add(one.as_table()->get("name"));
    }
  }
  return names;
}

}  // namespace stiction
