// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/comparison/comparison.h"

namespace stiction {

namespace {

const RuleOnContacts kFixedPoint{"fixed-point", ""}, kSecant{"secant", ""};

// Two iterations are called comparable when neither creeps more than three times faster anywhere.
constexpr double kComparable = 3.0;

// What a rule may cost to be called as cheap as the fixed point.
constexpr double kSameCost = 1.2;

constexpr double kSoon = 50.0;  // steps

RuleOnContacts on(const RuleOnContacts& who, const std::string& contacts) {
  return {who.rule, contacts};
}

std::string steps_words(double steps) {
  return std::isinf(steps) ? "never" : fmt::format("{:.0f} steps", steps);
}

std::string cost_words(const Figures& figures, const RuleOnContacts& who) {
  const double ratio = figures.of("cost/plate", who, kFrictionRatio);
  return std::isnan(ratio) ? "" : fmt::format(", {:.2g} × the friction cost", ratio);
}

// The readings of a rule on some contacts: "secant", "secant, memory = keep", …
std::vector<RuleOnContacts> readings(const Figures& figures, const RuleOnContacts& of,
                                     const std::string& contacts) {
  std::vector<RuleOnContacts> all;
  for (const RuleOnContacts& who : figures.rules("rules/")) {
    if (who.contacts == contacts &&
        (who.rule == of.rule || who.rule.rfind(of.rule + ", ", 0) == 0)) {
      all.push_back(who);
    }
  }
  return all;
}

double best_creep(const Figures& figures, const std::string& scene,
                  const std::vector<RuleOnContacts>& rules) {
  double best = std::numeric_limits<double>::infinity();
  for (const RuleOnContacts& who : rules) best = std::min(best, figures.of(scene, who, kCreep));
  return best;
}

// Whether a rule creeps less than another on a scene and needs no more steps; of two that never get
// there the creep alone decides.
bool beats(const Figures& figures, const std::string& scene, const RuleOnContacts& who,
           const RuleOnContacts& other) {
  return !figures.failed(scene, who) &&
         figures.of(scene, who, kStepsTo6) <= figures.of(scene, other, kStepsTo6) &&
         figures.of(scene, who, kCreep) < figures.of(scene, other, kCreep);
}

// Median over the scenes: the fixed point's creep on the paper's contacts over that of another.
double divided_by(const Figures& figures, const RuleOnContacts& other) {
  std::vector<double> ratios;
  for (const std::string& scene : figures.cases("rules/")) {
    const double value =
        figures.of(scene, on(kFixedPoint, "paper"), kCreep) / figures.of(scene, other, kCreep);
    if (std::isfinite(value)) ratios.push_back(value);
  }
  return spread_of(ratios).median;
}

}  // namespace

Sentences fixed_point_against_secant(const Figures& figures) {
  Sentences sentences;
  const std::vector<std::string> scenes = figures.cases("rules/");
  for (const char* contacts : {"paper", "quiet"}) {
    const auto fixed_point = readings(figures, kFixedPoint, contacts);
    const auto secant = readings(figures, kSecant, contacts);
    if (fixed_point.empty() || secant.empty()) continue;
    std::vector<double> ratios;
    std::size_t fixed_point_wins = 0;
    double least_fixed = std::numeric_limits<double>::infinity(), least_secant = least_fixed;
    std::vector<std::string> failures;
    const auto note_failures = [&](const std::string& scene,
                                   const std::vector<RuleOnContacts>& rules) {
      std::vector<std::string> names;
      for (const RuleOnContacts& who : rules) {
        if (figures.failed(scene, who)) names.push_back(who.rule);
      }
      if (names.empty()) return;
      failures.push_back(
          (names.size() == rules.size() ? "every " + rules.front().rule : listed(names)) + " on " +
          scene);
    };
    for (const std::string& scene : scenes) {
      const double a = best_creep(figures, scene, fixed_point);
      const double b = best_creep(figures, scene, secant);
      note_failures(scene, fixed_point);
      note_failures(scene, secant);
      ratios.push_back(b / a);
      fixed_point_wins += a < b;
      for (const RuleOnContacts& who : fixed_point) {
        least_fixed = std::min(least_fixed, figures.of(scene, who, kStepsTo6));
      }
      for (const RuleOnContacts& who : secant) {
        least_secant = std::min(least_secant, figures.of(scene, who, kStepsTo6));
      }
    }
    const Spread spread = spread_of(ratios);
    const bool comparable = spread.most <= kComparable && spread.least >= 1.0 / kComparable;
    sentences.push_back(fmt::format(
        "Fixed point against secant on {} contacts, the best reading of each: the secant's final "
        "creep is {:.2g} × that of the fixed point (median of {} scenes; {:.2g} to {:.2g}), the "
        "fixed "
        "point creeps less on {}. Soonest at 1e-6 m/s anywhere: fixed point {}, secant {}. The "
        "paper "
        "calls them comparable: {}. {}",
        contacts, spread.median, scenes.size(), spread.least, spread.most, fixed_point_wins,
        steps_words(least_fixed), steps_words(least_secant),
        comparable ? "confirmed" : "not confirmed",
        failures.empty() ? "Neither fails to hold a scene."
                         : "Failed to hold: " + listed(failures) + "."));
  }
  return sentences;
}

Sentences rules_that_beat_both(const Figures& figures) {
  const std::vector<std::string> scenes = figures.cases("rules/");
  std::vector<std::string> cheap, dear, unmeasured;
  bool compared = false;
  for (const RuleOnContacts& who : figures.rules("rules/")) {
    std::vector<RuleOnContacts> others = readings(figures, kFixedPoint, who.contacts);
    const auto secant = readings(figures, kSecant, who.contacts);
    if (others.empty() || secant.empty()) continue;
    others.insert(others.end(), secant.begin(), secant.end());
    if (std::find(others.begin(), others.end(), who) != others.end()) continue;
    compared = true;
    const bool all = std::all_of(scenes.begin(), scenes.end(), [&](const std::string& scene) {
      return std::all_of(others.begin(), others.end(), [&](const RuleOnContacts& other) {
        return beats(figures, scene, who, other);
      });
    });
    if (!all) continue;
    const double cost = figures.of("cost/plate", who, kFrictionRatio);
    auto& list = std::isnan(cost) ? unmeasured : cost <= kSameCost ? cheap : dear;
    const auto by_creep = std::count_if(
        scenes.begin(), scenes.end(),
        [&](const std::string& scene) { return std::isinf(figures.of(scene, who, kStepsTo6)); });
    list.push_back(who.words() + cost_words(figures, who) +
                   (by_creep == 0
                        ? ""
                        : fmt::format(" (on {} by creep alone, since none of them gets to "
                                      "1e-6 m/s)",
                                      by_creep)));
  }
  if (!compared) return {};
  const std::string claim = fmt::format(
      "every reading of fixed point and secant on all {} scenes, in steps to 1e-6 m/s and in final "
      "creep",
      scenes.size());
  Sentences sentences;
  if (!cheap.empty()) {
    sentences.push_back(fmt::format("At up to {} × the cost of the fixed point these beat {}: {}.",
                                    kSameCost, claim, listed(cheap)));
  } else if (unmeasured.empty()) {
    sentences.push_back(fmt::format("No rule at up to {} × the cost of the fixed point beats {}.",
                                    kSameCost, claim));
  }
  if (!dear.empty()) sentences.push_back("At a higher cost: " + listed(dear) + ".");
  if (!unmeasured.empty()) {
    sentences.push_back(fmt::format("These beat {}; their cost was not measured in this run: {}.",
                                    claim, listed(unmeasured)));
  }
  return sentences;
}

Sentences rules_within_fifty_steps(const Figures& figures) {
  Sentences sentences;
  for (const std::string& scene : figures.cases("rules/slab")) {
    std::vector<std::string> soon;
    RuleOnContacts nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const RuleOnContacts& who : figures.rules(scene)) {
      const double steps = figures.of(scene, who, kStepsTo9);
      if (steps <= kSoon) {
        soon.push_back(
            fmt::format("{} ({}{})", who.words(), steps_words(steps), cost_words(figures, who)));
      }
      if (steps < least) {
        least = steps;
        nearest = who;
      }
    }
    sentences.push_back(
        nearest.rule.empty() ? fmt::format("{}: none gets to 1e-9 m/s in all its steps.", scene)
        : soon.empty()
            ? fmt::format("{}: none gets to 1e-9 m/s within {} steps; nearest {}, {}.", scene,
                          kSoon, nearest.words(), steps_words(least))
            : fmt::format("{}: 1e-9 m/s within {} steps by {}.", scene, kSoon, listed(soon)));
  }
  return sentences;
}

CreepDivided creep_divided(const Figures& figures) {
  const RuleOnContacts stored{"stored-vector", ""};
  return {divided_by(figures, on(stored, "paper")), divided_by(figures, on(kFixedPoint, "quiet")),
          divided_by(figures, on(stored, "quiet"))};
}

Sentences rule_or_contacts(const Figures& figures) {
  const RuleOnContacts steady{"stored-vector, 8 sweeps", ""};
  const auto [by_rule, by_contacts, by_both] = creep_divided(figures);
  if (std::isnan(by_rule) || std::isnan(by_contacts) || std::isnan(by_both)) return {};
  return {fmt::format(
      "Rule or contacts: against the fixed point on the paper's contacts, the stored vector alone "
      "divides the final creep by {:.2g}, quiet contacts alone by {:.2g}, both by {:.2g} (medians "
      "over "
      "the scenes); eight sweeps on the paper's contacts by {:.2g}, on quiet ones by {:.2g}.",
      by_rule, by_contacts, by_both, divided_by(figures, on(steady, "paper")),
      divided_by(figures, on(steady, "quiet")))};
}

Record findings(const std::vector<Record>& records) {
  Record found;
  found.case_name = "findings";
  found.title = "what the comparison says";
  found.engine = records.front().engine;
  found.environment = records.front().environment;
  const Figures figures(records);
  const CreepDivided divided = creep_divided(figures);
  if (!std::isnan(divided.by_both)) {
    const char* better = "of the fixed point on the paper's contacts, median of the scenes";
    found.figures = {{"creep ÷ by the rule alone", "1", better, divided.by_rule},
                     {"creep ÷ by contacts alone", "1", better, divided.by_contacts},
                     {"creep ÷ by both", "1", better, divided.by_both}};
  }
  found.verdict = verdict_of(found);
  for (const auto part :
       {fixed_point_against_secant, rules_that_beat_both, rules_within_fifty_steps, frozen_steps,
        rule_or_contacts, loads_of_the_cone, what_stops_the_vector, from_sliding, poses_at_rest,
        hard_conditions, gain_sweeps, pareto_front, builds_beside}) {
    for (std::string& sentence : part(figures)) found.notes.push_back(std::move(sentence));
  }
  return found;
}

}  // namespace stiction
