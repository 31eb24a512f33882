// SPDX-License-Identifier: GPL-3.0-or-later
// What the work of a rule in another build of the engine comes to beside that in the engine as it is:
// the same scenes, steps and settings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/text/text.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/findings.h"

namespace stiction {

namespace {

// Of the case at which it is largest.
struct Largest {
  double value = -1.0;
  std::string words;
};

struct Beside {
  std::vector<double> speeds;  // CPU time over that of the build
  std::vector<double> shares;  // slipped ÷ free slide, of the build over that of the engine
  std::vector<double> creeps;  // m/s, of the build alone
  Largest slower;              // CPU time of the build over that of the engine
  std::size_t failures = 0, own_failures = 0;
};

std::string range_words(const Spread& spread) {
  return fmt::format("{:.2g} (median; {:.2g} to {:.2g})", spread.median, spread.least, spread.most);
}

}  // namespace

Sentences builds_beside(const Figures& figures) {
  std::map<std::string, Beside> builds;
  for (const std::string& name : figures.cases("work/")) {
    for (const RuleOnContacts& who : figures.rules(name)) {
      if (who.build.empty()) continue;
      const RuleOnContacts own{who.rule, who.contacts};
      const double seconds = figures.of(name, who, kCpuTime);
      const double own_seconds = figures.of(name, own, kCpuTime);
      if (std::isnan(seconds) || std::isnan(own_seconds)) continue;  // one was not compared
      Beside& beside = builds[who.build];
      beside.failures += figures.failed(name, who);
      beside.own_failures += figures.failed(name, own);
      if (figures.failed(name, who) || figures.failed(name, own)) continue;
      beside.speeds.push_back(own_seconds / seconds);
      beside.shares.push_back(figures.of(name, who, kSlippedShare) /
                              figures.of(name, own, kSlippedShare));
      beside.creeps.push_back(figures.of(name, who, kCreep));
      if (seconds / own_seconds <= beside.slower.value) continue;
      beside.slower = {seconds / own_seconds, fmt::format("{} at {}", own.words(), name)};
    }
  }
  Sentences sentences;
  for (const auto& [build, beside] : builds) {
    if (beside.speeds.empty()) continue;
    const Spread creep = spread_of(beside.creeps);
    sentences.push_back(fmt::format(
        "Work in {} beside the same rule, scene and steps in the engine as it is ({}): speed × {}, "
        "least with {}; way slipped × {}; final creep {:.2g} to {:.2g} m/s. Failed: {}, and {} in "
        "the engine as it is.",
        build, counted(beside.speeds.size(), "pair"), range_words(spread_of(beside.speeds)),
        beside.slower.words, range_words(spread_of(beside.shares)), creep.least, creep.most,
        beside.failures, beside.own_failures));
  }
  return sentences;
}

}  // namespace stiction
