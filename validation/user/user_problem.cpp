// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/user_problem.h"

#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <utility>

#include "reports/text/text.h"
#include "validation/user/nesting.h"
#include "validation/user/problem_keys.h"
#include "validation/user/quantity.h"
#include "validation/user/read_motion.h"
#include "validation/user/start_overlap.h"
#include "validation/user/vary.h"

namespace stiction {

namespace {

Drag read_drag(TomlTable table) {
  const Drag drag{table.number("rate"), table.number("full_until"), table.number("ends")};
  if (!(drag.rate >= 0.0)) table.refuse("rate", "'rate' must not be negative");
  if (!(drag.full_until < drag.ends)) table.refuse("ends", "'ends' must follow 'full_until'");
  table.finish();
  return drag;
}

void refuse_overlap(TomlTable& top, const UserProblem& user) {
  const std::string wanted = top.text("initial_overlap", "refused");
  if (wanted != "refused" && wanted != "allowed") {
    top.refuse("initial_overlap", "'initial_overlap' is \"refused\" or \"allowed\"");
  }
  if (wanted == "allowed") return;
  const std::string overlap = overlap_at_start(user.problem);
  if (overlap.empty()) return;
  top.refuse("initial_overlap",
             overlap + "; move them apart, or say initial_overlap = \"allowed\"");
}

void read_scene(TomlTable& top, Reading& reading) {
  UserProblem& user = reading.user;
  user.title = top.text("title", "");
  user.problem.name = one_line(user.title);
  user.problem.duration = top.number("duration");
  if (!(user.problem.duration > 0.0)) top.refuse("duration", "'duration' must be positive");
  user.problem.gravity = read_gravity(top);
  if (top.has("drag")) user.problem.drag = read_drag(top.table("drag", problem_keys::drag()));
  if (top.has("friction")) user.problem.friction = read_friction(top);
  user.problem.restitution = top.number("restitution", 0.0);
  if (!(user.problem.restitution >= 0.0 && user.problem.restitution <= 1.0)) {
    top.refuse("restitution", "'restitution' must lie between 0 and 1");
  }
  if (top.has("engine")) {
    for (auto& [key, value] : top.settings("engine")) user.settings[key] = value;
  }
  for (TomlTable& table : top.tables("obstacle", problem_keys::obstacle())) {
    read_obstacle(table, reading);
  }
  for (TomlTable& table : top.tables("body", problem_keys::body())) read_body(table, reading);
  for (TomlTable& table : top.tables("load", problem_keys::load())) read_load(table, reading);
  for (TomlTable& table : top.tables("spring", problem_keys::spring())) {
    read_spring(table, reading);
  }
  for (TomlTable& table : top.tables("pair", problem_keys::pair())) read_pair(table, reading);
}

// What the problem refuses is told before it runs, and where the value stands.
void refuse_value(TomlTable& table, const std::string& key, const UserVariation& vary,
                  double value) {
  try {
    vary.with(value);
  } catch (const NotMeshed&) {
    return;  // the record's error
  } catch (const InputError& error) {
    table.refuse(key, error.what());
  }
}

UserThreshold read_threshold(TomlTable table, const std::shared_ptr<const ParsedFile>& parsed) {
  UserThreshold one;
  one.place = table.place();
  one.vary = read_variation(table, parsed);
  const std::string& unit = one.vary.unit;
  one.holds_at = table.number_in(unit, "holds_at");
  one.fails_at = table.number_in(unit, "fails_at");
  if (one.holds_at == one.fails_at) {
    table.refuse("fails_at", "'holds_at' and 'fails_at' must not be the same");
  }
  refuse_value(table, "holds_at", one.vary, one.holds_at);
  refuse_value(table, "fails_at", one.vary, one.fails_at);
  one.within = table.number_in(unit, "within");
  if (!(one.within > 0.0)) table.refuse("within", "'within' must be positive");
  one.claim.quantity = "threshold of " + one.vary.what;
  one.claim.unit = unit.empty() ? "1" : shown_unit(unit);
  one.claim.statement = table.text("claim", "from where on a check fails");
  one.claim.source = table.text("source", "the problem's author");
  one.claim.kind = ReferenceKind::kExternal;
  one.claim.expected = table.number_in(unit, "expected");
  one.claim.tolerance = table.number_in(unit, "tolerance");
  one.claim.reason = table.text("reason");
  if (!(one.claim.tolerance >= 0.5 * one.within)) {
    table.refuse("tolerance",
                 "'tolerance' must be at least half of 'within': so exactly is the "
                 "threshold found");
  }
  table.finish();
  return one;
}

UserSweep read_sweep(TomlTable table, const std::shared_ptr<const ParsedFile>& parsed) {
  UserSweep sweep{read_variation(table, parsed), {}};
  sweep.values = table.numbers_in(sweep.vary.unit, "values");
  if (sweep.values.empty()) table.refuse("values", "'values' needs at least one number");
  for (const double value : sweep.values) refuse_value(table, "values", sweep.vary, value);
  table.finish();
  return sweep;
}

}  // namespace

std::string value_text(const std::string& what, const std::string& unit, double value) {
  return fmt::format("{} = {:g}{}", what, value, unit.empty() || unit == "1" ? "" : " " + unit);
}

std::string extreme_word(Extreme extreme) {
  if (extreme == Extreme::kNone) return "";
  return extreme == Extreme::kLargest ? "largest " : "smallest ";
}

std::string partner_words(const Watched& watched, const Problem& problem) {
  const auto name = [&](const Partner& one) {
    return one.is_body ? problem.bodies[one.index].name : problem.obstacles[one.index].name;
  };
  if (watched.against) return " against " + name(*watched.against);
  return watched.relative_to ? " relative to " + name(*watched.relative_to) : "";
}

UserProblem read_parsed(const std::string& file, const toml::table& root) {
  TomlTable top(file, root, problem_keys::file());
  Reading reading;
  UserProblem& user = reading.user;
  user.file = file;
  read_scene(top, reading);
  if (user.problem.bodies.empty()) top.refuse("body", "the file describes no [[body]]");
  for (TomlTable& table : top.tables("check", problem_keys::check())) read_check(table, reading);
  for (TomlTable& table : top.tables("series", problem_keys::series())) {
    read_series(table, reading);
  }
  if (user.checks.empty()) top.refuse("check", "the file has no [[check]], so nothing could fail");
  name_apart(user);
  refuse_overlap(top, user);
  const bool threshold = top.has("threshold"), sweep = top.has("sweep");
  if (threshold && sweep) {
    top.refuse("sweep", "give [threshold] or [sweep], not both");
  }
  top.finish();
  return std::move(reading.user);
}

std::shared_ptr<const ParsedFile> parse_toml(std::istream& text,
                                             const std::filesystem::path& file) {
  const std::string source{std::istreambuf_iterator<char>(text), {}};
  refuse_deep_keys(source, file.string());
  const auto parsed = std::make_shared<ParsedFile>();
  parsed->file = file.string();
  try {
    parsed->root = toml::parse(source, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", file.string(), error.source().begin.line,
                                 one_line(error.description())));
  }
  return parsed;
}

UserProblem user_problem(std::istream& text, const std::filesystem::path& file) {
  const std::shared_ptr<const ParsedFile> parsed = parse_toml(text, file);
  UserProblem user = read_parsed(parsed->file, parsed->root);
  TomlTable top(parsed->file, parsed->root, problem_keys::file());
  if (top.has("threshold")) {
    user.threshold = read_threshold(top.table("threshold", problem_keys::threshold()), parsed);
  }
  if (top.has("sweep")) {
    user.sweep = read_sweep(top.table("sweep", problem_keys::sweep()), parsed);
  }
  return user;
}

}  // namespace stiction
