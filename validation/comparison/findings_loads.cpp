// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about the paper's scalar, its vector reading and the stored vector over the load, from a
// slip of 1e-3 m/s, and in how many poses they rest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/comparison/comparison.h"
#include "validation/comparison/findings.h"

namespace stiction {

namespace {

// "2" of "load/lost/cells=2/r=0.35" for "cells".
std::string value_in(const std::string& case_name, const std::string& name) {
  const std::size_t at = case_name.find(name + "=");
  if (at == std::string::npos) return "";
  const std::size_t from = at + name.size() + 1;
  return case_name.substr(from, case_name.find('/', from) - from);
}

// "8 to 37"; "40 to never" when it is found at some loads only.
std::string steps_spread(const std::vector<double>& steps) {
  const auto words = [](double value) {
    return std::isinf(value) ? "never" : fmt::format("{:.0f}", value);
  };
  const Spread spread = spread_of(steps);
  return spread.least == spread.most ? words(spread.least)
                                     : words(spread.least) + " to " + words(spread.most);
}

// "at 0.1, 0.2 and 0.35 (11 to 12 steps, the fastest contact 12 to 20)"; empty: at none.
std::string where_found(const Figures& figures, const std::vector<std::string>& cases,
                        const RuleOnContacts& who) {
  std::vector<std::string> loads;
  std::vector<double> mean, fastest;
  for (const std::string& name : cases) {
    const double steps = figures.of(name, who, kStepsTo9);
    if (!std::isfinite(steps) || figures.failed(name, who)) continue;
    loads.push_back(value_in(name, "r"));
    mean.push_back(steps);
    fastest.push_back(figures.of(name, who, kFastestTo9));
  }
  if (loads.empty()) return {};
  return fmt::format("at {} ({} steps, the fastest contact {})",
                     loads.size() == cases.size() ? "all" : listed(loads), steps_spread(mean),
                     steps_spread(fastest));
}

// Cases of the same parameters but the load, in the order of the records.
std::map<std::string, std::vector<std::string>> by_cells(const Figures& figures,
                                                         const std::string& prefix) {
  std::map<std::string, std::vector<std::string>> groups;
  for (const std::string& name : figures.cases(prefix)) {
    groups[value_in(name, "cells")].push_back(name);
  }
  return groups;
}

}  // namespace

Sentences loads_of_the_cone(const Figures& figures) {
  Sentences sentences;
  for (const auto& [cells, cases] : by_cells(figures, "load/lost/")) {
    std::string loads;
    for (const std::string& name : cases) {
      loads += (loads.empty() ? "" : ", ") + value_in(name, "r");
    }
    std::vector<std::string> parts, never;
    std::vector<double> start;
    for (const RuleOnContacts& who : figures.rules(cases.front())) {
      const std::string where = where_found(figures, cases, who);
      if (where.empty()) {
        never.push_back(who.words());
      } else {
        parts.push_back(who.words() + " " + where);
      }
      for (const std::string& name : cases) start.push_back(figures.of(name, who, kStartSlip));
    }
    sentences.push_back(fmt::format(
        "Loads of {} of the cone, memory lost (a slip of up to {:.1g} m/s), a box of {} cells an "
        "edge: the mean slip falls below 1e-9 m/s for good with {}; at none with {}.",
        loads, spread_of(start).most, cells,
        parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, "; ")),
        never.empty() ? "none" : listed(never)));
  }
  return sentences;
}

Sentences what_stops_the_vector(const Figures& figures) {
  const RuleOnContacts vector{"bias-vector", "paper"};
  std::vector<double> held, lost;  // contacts that slide at the end
  for (const std::string& name : figures.cases("load/")) {
    const double sliding = figures.of(name, vector, kSliding);
    if (std::isnan(sliding) || figures.failed(name, vector)) continue;
    (figures.of(name, vector, kCreep) <= 1e-9 ? held : lost).push_back(sliding);
  }
  if (held.empty() || lost.empty()) return {};
  const Spread at_rest = spread_of(held), creeping = spread_of(lost);
  return {fmt::format(
      "What stops the vector reading on the paper's contacts: at the end {:.0f} to {:.0f} contacts "
      "are at the cone in the {} runs that creep faster than 1e-9 m/s, {:.0f} to {:.0f} in the {} "
      "others. {}",
      creeping.least, creeping.most, lost.size(), at_rest.least, at_rest.most, held.size(),
      creeping.least > at_rest.most
          ? "A contact that one sweep clamps forgets its bias, so it never learns."
          : "That alone does not tell them apart.")};
}

Sentences from_sliding(const Figures& figures) {
  std::map<std::string, std::vector<std::string>> groups;  // by what happens
  for (const auto& [cells, cases] : by_cells(figures, "load/released/")) {
    groups["A box of " + cells + " cells an edge that slides at 1e-3 m/s"] = cases;
  }
  const std::vector<std::string> falls = figures.cases("falling-box/");
  if (!falls.empty()) groups["A box that falls on the slab (the paper's experiment)"] = falls;
  Sentences sentences;
  for (const auto& [what, cases] : groups) {
    std::vector<std::string> parts, never;
    bool within = false;
    for (const RuleOnContacts& who : figures.rules(cases.front())) {
      std::vector<double> mean, fastest;
      for (const std::string& name : cases) {
        const double steps = figures.of(name, who, kFrom3);
        if (!std::isfinite(steps) || figures.failed(name, who)) continue;
        mean.push_back(steps);
        fastest.push_back(figures.of(name, who, kFastestFrom3));
        within = within || steps <= 16.0;
      }
      if (mean.empty()) {
        never.push_back(who.words());
        continue;
      }
      parts.push_back(fmt::format("{} {} at {} of {} loads (the fastest contact {})", who.words(),
                                  steps_spread(mean), mean.size(), cases.size(),
                                  steps_spread(fastest)));
    }
    sentences.push_back(fmt::format(
        "{}, steps from 1e-3 m/s to 1e-9 m/s of mean slip: {}; never: {}. The paper's 8 to 16 are "
        "{}.",
        what, parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, "; ")),
        never.empty() ? "none" : listed(never), within ? "reached" : "not reached"));
  }
  return sentences;
}

Sentences poses_at_rest(const Figures& figures) {
  std::vector<std::string> cases = figures.cases("poses/");
  if (cases.empty()) return {};
  std::sort(cases.begin(), cases.end(), [](const std::string& a, const std::string& b) {
    return std::stod(value_in(a, "slope")) < std::stod(value_in(b, "slope"));
  });
  std::vector<std::string> parts;
  for (const RuleOnContacts& who : figures.rules("poses/")) {
    std::vector<std::string> counts;
    for (const std::string& name : cases) {
      counts.push_back(fmt::format("{:.0f} of {:.0f} at {}°", figures.of(name, who, kPosesAtRest),
                                   figures.of(name, who, kPoses), value_in(name, "slope")));
    }
    parts.push_back(who.words() + " " + listed(counts));
  }
  return {fmt::format("Poses at rest: {}.", fmt::join(parts, "; "))};
}

}  // namespace stiction
