// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "reports/text/names.h"
#include "validation/user/problem_keys.h"
#include "validation/user/quantity.h"
#include "validation/user/reading.h"

namespace stiction {

namespace {

const Observable& read_observable(TomlTable& table) {
  const std::string name = table.text("observable");
  for (const Observable& observable : observables()) {
    if (observable.name == name) return observable;
  }
  const auto name_of = [](const Observable& one) { return one.name; };
  table.refuse("observable", fmt::format("there is no observable '{}'; there are: {}", name,
                                         listed_names(observables(), name_of)));
}

std::size_t read_watched_body(TomlTable& table, const Reading& reading) {
  if (table.has("body")) return reading.bodies.find(table, "body", "body");
  if (reading.user.problem.bodies.size() == 1) return 0;
  table.refuse("body", "which 'body' is observed? There are: " + reading.bodies.listed());
}

Eigen::Vector3d downhill_on(TomlTable& table, const Reading& reading, std::size_t obstacle) {
  const UserProblem& user = reading.user;
  if (!user.level[obstacle]) return user.downhill[obstacle];
  table.refuse("direction",
               fmt::format("'{}' is level, so nothing is downhill on it: give three numbers, or an "
                           "'azimuth_deg' to the obstacle",
                           user.problem.obstacles[obstacle].name));
}

// The obstacle that a body stands on, itself or by way of others, or the only one.
Eigen::Vector3d downhill_of(TomlTable& table, const Reading& reading, std::size_t body) {
  const UserProblem& user = reading.user;
  std::optional<std::size_t> obstacle = user.supports[body].obstacle;
  if (!obstacle && user.downhill.size() == 1) obstacle = 0;
  if (obstacle) return downhill_on(table, reading, *obstacle);
  table.refuse("direction",
               user.downhill.empty()
                   ? "there is no obstacle, so nothing is \"downhill\": give three numbers"
                   : fmt::format("'{}' rests on no obstacle by its 'rests_on': say of which it is "
                                 "downhill, {{ downhill = \"NAME\" }}; there are: {}",
                                 user.problem.bodies[body].name, reading.obstacles.listed()));
}

Eigen::Vector3d read_watched_direction(TomlTable& table, const Reading& reading, std::size_t body) {
  if (table.is_text("direction")) {
    if (table.text("direction") == "downhill") return downhill_of(table, reading, body);
    table.refuse("direction",
                 "'direction' is three numbers, \"downhill\" or { downhill = \"OBSTACLE\" }");
  }
  if (!table.is_table("direction")) return read_direction(table, "direction");
  TomlTable inner = table.table("direction", problem_keys::direction());
  const std::size_t obstacle = reading.obstacles.find(inner, "downhill", "obstacle");
  inner.finish();
  return downhill_on(table, reading, obstacle);
}

UserWatch read_watch(TomlTable& table, const Reading& reading) {
  UserWatch watch;
  watch.observable = &read_observable(table);
  const Subject subject = watch.observable->subject;
  watch.contacts = subject == Subject::kContacts;
  watch.energies = subject == Subject::kScene;
  if (subject != Subject::kScene) watch.body = read_watched_body(table, reading);
  if (watch.contacts && table.has("against")) {
    watch.against = find_partner(table, "against", reading);
    const bool itself = watch.against->is_body && watch.against->index == watch.body;
    if (itself && !reading.user.problem.bodies[watch.body].self_collision) {
      table.refuse("against", "a body touches itself only with self_collision = true");
    }
  }
  if (subject == Subject::kTurn) refuse_point(table, reading, "observable", watch.body);
  if (subject == Subject::kCentre && table.has("relative_to")) {
    watch.relative_to = find_partner(table, "relative_to", reading);
    if (watch.relative_to->is_body && watch.relative_to->index == watch.body) {
      table.refuse("relative_to", "a body does not move over itself");
    }
  }
  if (watch.observable->in_direction) {
    watch.direction = read_watched_direction(table, reading, watch.body);
  }
  return watch;
}

// "largest speed of box relative to table"; the body only where there are several.
std::string name_of(const UserWatch& watch, const Problem& problem,
                    Extreme extreme = Extreme::kNone) {
  std::string name = extreme_word(extreme) + watch.observable->name;
  if (watch.observable->subject == Subject::kScene) return name;
  if (problem.bodies.size() > 1) name += " of " + problem.bodies[watch.body].name;
  return name + partner_words(watch, problem);
}

Extreme read_extreme(TomlTable& table, const Observable& observable) {
  if (observable.over_window || table.has("settles_below") || !table.has("extreme")) {
    return Extreme::kNone;
  }
  const std::string word = table.text("extreme");
  if (word == "largest") return Extreme::kLargest;
  if (word == "smallest") return Extreme::kSmallest;
  table.refuse("extreme", "'extreme' is \"largest\" or \"smallest\"");
}

std::optional<double> read_settles(TomlTable& table, const Observable& observable) {
  if (observable.over_window || !table.has("settles_below")) return std::nullopt;
  const double bound = table.number_in(observable.unit, "settles_below");
  if (!(bound >= 0.0)) table.refuse("settles_below", "'settles_below' must not be negative");
  return bound;
}

void read_times(TomlTable& table, const Problem& problem, UserCheck& one) {
  one.at = table.number("at", problem.duration);
  if (one.over_window()) one.from = table.number("from", 0.0);
  if (!(one.from >= 0.0 && one.from < one.at && one.at <= problem.duration)) {
    table.refuse("at", fmt::format("the times of a check must follow 0 ≤ from < at ≤ {} s",
                                   problem.duration));
  }
}

void read_claim(TomlTable& table, const std::string& unit, Claim& claim) {
  claim.unit = shown_unit(unit);
  claim.source = table.text("source", "the problem's author");
  claim.kind = ReferenceKind::kExternal;
  claim.expected = table.number_in(unit, "expected");
  claim.relative = table.flag("relative", false);
  if (table.has("scale")) claim.scale = table.number_in(unit, "scale");
  claim.tolerance = table.number_in(claim.relative ? "1" : unit, "tolerance");
  claim.reason = table.text("reason");
  if (!(claim.tolerance >= 0.0)) table.refuse("tolerance", "'tolerance' must not be negative");
  if (claim.scale && !(*claim.scale > 0.0)) {
    table.refuse("scale", "'scale' must be positive: what digits count from");
  }
  if (claim.relative && !scale_of(claim)) {
    table.refuse("relative",
                 "an error relative to an expected value of 0 has no meaning without a 'scale'");
  }
}

std::string times_of(const UserCheck& one) {
  if (!one.over_window()) return fmt::format(" at {:g} s", one.at);
  return fmt::format(" from {:g} s to {:g} s", one.from, one.at);
}

// Adds to each of those that are called the same what `words` says of it and its number among them.
template <class Words>
void tell_apart(std::vector<UserCheck>& checks, const Words& words) {
  std::map<std::string, int> count, seen;
  for (const UserCheck& one : checks) ++count[one.claim.quantity];
  for (UserCheck& one : checks) {
    const std::string name = one.claim.quantity;
    if (count[name] > 1) one.claim.quantity += words(one, ++seen[name]);
  }
}

}  // namespace

void read_check(TomlTable table, Reading& reading) {
  UserCheck one;
  one.watch = read_watch(table, reading);
  one.extreme = read_extreme(table, *one.watch.observable);
  one.settles_below = read_settles(table, *one.watch.observable);
  read_times(table, reading.user.problem, one);
  one.place = table.place();
  const std::string settles = one.settles_below ? "settling time of " : "";
  one.claim.quantity =
      table.text("quantity", settles + name_of(one.watch, reading.user.problem, one.extreme));
  one.claim.statement = table.text("claim", settles + one.watch.observable->meaning);
  read_claim(table, one.settles_below ? "s" : one.watch.observable->unit, one.claim);
  reading.user.checks.push_back(one);
  table.finish();
}

void read_series(TomlTable table, Reading& reading) {
  UserSeries one;
  one.watch = read_watch(table, reading);
  if (one.watch.observable->over_window) {
    table.refuse("observable", fmt::format("'{}' is observed over a window: a curve needs one of a "
                                           "time, like position or velocity",
                                           one.watch.observable->name));
  }
  one.name = name_of(one.watch, reading.user.problem);
  reading.user.series.push_back(one);
  table.finish();
}

void name_apart(UserProblem& user) {
  tell_apart(user.checks, [](const UserCheck& one, int) { return times_of(one); });
  tell_apart(user.checks,
             [](const UserCheck&, int number) { return fmt::format(" ({})", number); });
  std::map<std::string, int> seen;
  for (UserSeries& one : user.series) {
    if (const int number = ++seen[one.name]; number > 1) one.name += fmt::format(" ({})", number);
  }
}

}  // namespace stiction
