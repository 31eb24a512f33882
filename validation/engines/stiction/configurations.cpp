// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/configurations.h"

#include <fnmatch.h>

#include <algorithm>

namespace stiction {

namespace {

const Settings kOld{{"method", "old"}};
const Settings kPaper{{"method", "paper"}};
const Settings kSecant{{"method", "paper"}, {"rule", "secant"}};
const Settings kKeep{{"memory", "keep"}, {"method", "paper"}};
const Settings kWithoutMemory{{"method", "paper"}, {"rule", "none"}};
const Settings kQuiet{{"method", "quiet"}};
const std::vector<Settings> kMethods{kOld, kPaper, kSecant, kQuiet};
const std::vector<Settings> kOthers{kOld, kPaper, kSecant};
const std::vector<Settings> kRules{
    {{"rule", "fixed-point"}}, {{"rule", "none"}}, {{"rule", "conjugate-vector"}}};
const std::vector<Settings> kDefault{{}};

// Of a case or a glob, in which * crosses '/': the first that matches.
struct Row {
  const char* cases;
  std::vector<Settings> always;
  std::vector<Settings> only_full{};
  // Beside them, and nothing of it is judged: the paper's methods lose their digits to the first
  // perturbation, and no band holds what is left.
  std::vector<Settings> contrast{};
  std::vector<Settings> contrast_only_full{};
};

const std::vector<Row>& rows() {
  static const std::vector<Row> all = {
      {"bar-on-bed/*", kRules},
      {"clamp/half-spaces/*", kRules},
      {"clamp/row/shear/*", kMethods},
      {"clamp/row/threshold/*/half-step", {kPaper, kQuiet}},
      {"incline/above/acceleration/box", kRules},
      {"incline/at-critical/*", kRules},
      {"incline/below/*", kRules},
      {"incline/level/*", kRules},
      {"incline/restick/*", kRules},
      // The rules must agree against a fixed plane; one μ shows it.
      {"incline/threshold/mu=0.5/azimuth=0/yaw=0", kRules},
      {"incline/threshold/mu=0.5/azimuth=30/*", kRules},
      {"incline/threshold/mu=0.5/azimuth=45/yaw=0", kRules},
      {"paper/appendix-a-momentum/crossed-bars", {kQuiet}},  // the others have no contacts of edges
      {"paper/appendix-a-momentum/*", kMethods},
      {"paper/fig3-clamped-box/half-step", {kQuiet}},
      {"paper/fig3-clamped-box/threshold", {kPaper, kQuiet}},
      {"paper/fig3-clamped-box/threshold/flush", {kQuiet}},
      {"paper/fig3-clamped-box/threshold/offset", {kQuiet}},
      {"paper/fig3-clamped-box/threshold/offset/vertices", {kPaper}},
      {"paper/fig3-clamped-box*", kMethods},
      {"paper/fig4-membrane", {kPaper, kQuiet}, {kOld, kSecant}},
      {"paper/fig4-membrane/*", {kPaper, kQuiet}},
      {"paper/fig5-box-pyramid/flush", {kQuiet}},
      {"paper/fig5-box-pyramid/half-step", {kWithoutMemory, kPaper, kQuiet}},
      {"paper/fig5-box-pyramid/threshold", kMethods},
      {"paper/fig5-box-pyramid/*rigid-ground", {kPaper, kQuiet}},
      {"paper/fig5-box-pyramid*", {kOld, kWithoutMemory, kPaper, kSecant, kQuiet}},
      {"paper/fig6-basket/*", kMethods},
      {"paper/fig7-four-balls", {kOld, kQuiet}},
      {"paper/fig7-four-balls/*", {kPaper, kQuiet}},
      {"push-and-retract/*", kMethods},
      {"slab/rest/damping/*", {kQuiet}},
      {"slab/rest/many/*", {kQuiet}},
      {"slab/rest/random", {kPaper, kQuiet}, {kOld, kSecant}},
      {"slab/rest/*", kMethods},
      {"slab/threshold", {kPaper, kQuiet}, {kOld, kSecant, kKeep}},
      {"slab/threshold/fine", {kOld, kPaper, kSecant, kQuiet, kKeep}},
      {"two-body/*", kMethods},
      {"perturbed/half-space/*", kDefault},
      {"perturbed/paper/appendix-a-momentum/crossed-bars", {kQuiet}},
      {"perturbed/paper/fig3-clamped-box", {kQuiet}, {}, {}, kOthers},
      {"perturbed/*", {kQuiet}, {}, {kPaper}, {kOld, kSecant}},
      {"ladder/coincidence/*", {kQuiet}, {}, {}, kOthers},
      {"ladder/contacts/*", {kQuiet}, {}, {}, kOthers},
      {"ladder/size-ratio/*", {kQuiet}, {}, {}, kOthers},
      {"ladder/stack/*", {kQuiet}, {}, {}, kOthers},
      {"ladder/*", {kQuiet}, {}, {kPaper}, {kOld, kSecant}},
      {"gauntlet/*", {kQuiet}, {}, {}, kOthers},
      {"outcomes/slope", kRules},
      {"half-space/*", kDefault},
      {"incline/*", kDefault},
      {"*", {kQuiet}},
  };
  return all;
}

// What people call them. Without a method a scene has fixed half-spaces alone, on which methods differ
// by their rules: the paper's rules stand for its method, and give the same states.
const std::vector<Configuration>& named() {
  static const std::vector<Configuration> all = {
      {.settings = {}, .name = "quiet"},
      {.settings = {{"rule", "conjugate-vector"}}, .name = "quiet"},
      {.settings = {{"rule", "fixed-point"}}, .name = "paper, fixed point"},
      {.settings = {{"rule", "secant"}}, .name = "paper, secant"},
      {.settings = {{"rule", "none"}}, .name = "paper, no memory"},
      {.settings = kQuiet, .name = "quiet"},
      {.settings = kOld, .name = "old"},
      {.settings = kPaper, .name = "paper, fixed point"},
      {.settings = {{"method", "paper"}, {"rule", "fixed-point"}}, .name = "paper, fixed point"},
      {.settings = kSecant, .name = "paper, secant"},
      {.settings = kWithoutMemory, .name = "paper, no memory"}};
  return all;
}

// The one with the most of these settings and no other; a method goes before a rule.
Configuration nearest_named(const Settings& settings) {
  const bool has_method = settings.count("method") > 0;
  const Configuration* nearest = &named().front();
  for (const Configuration& one : named()) {
    const bool among =
        std::includes(settings.begin(), settings.end(), one.settings.begin(), one.settings.end());
    const bool comparable = has_method == (one.settings.count("method") > 0);
    if (among && comparable && one.settings.size() >= nearest->settings.size()) nearest = &one;
  }
  return *nearest;
}

}  // namespace

Configuration configuration_of(const Settings& settings) {
  const auto method = settings.find("method");
  Configuration one = nearest_named(settings);
  one.contrast = method != settings.end() && method->second == "old";
  one.keeps_angular_momentum = method == settings.end() || method->second == "quiet";
  one.lets_thrown_pass = method != settings.end() && method->second == "paper";
  return one;
}

std::vector<Configuration> configurations_of(const std::string& case_name) {
  const auto row = std::find_if(rows().begin(), rows().end(), [&](const Row& one) {
    return fnmatch(one.cases, case_name.c_str(), 0) == 0;
  });
  std::vector<Configuration> all;
  const auto add = [&](const std::vector<Settings>& some, bool only_full, bool contrast) {
    for (const Settings& settings : some) {
      Configuration one = configuration_of(settings);
      one.settings = settings;  // those of the nearest with a name among them
      one.only_full = only_full;
      one.contrast = one.contrast || contrast;
      all.push_back(std::move(one));
    }
  };
  add(row->always, false, false);
  add(row->only_full, true, false);
  add(row->contrast, false, true);
  add(row->contrast_only_full, true, true);
  return all;
}

const std::vector<Settings>& compared_methods() { return kMethods; }

std::vector<Configuration> method_configurations() {
  std::vector<Configuration> all;
  for (const Settings& settings : {kQuiet, kPaper, kSecant, kOld}) {
    all.push_back(configuration_of(settings));
  }
  return all;
}

std::optional<Settings> settings_without(Without what) {
  switch (what) {
    case Without::kFrictionMemory:
      return Settings{{"rule", "none"}};
    case Without::kPostCorrection:
      return Settings{{"post-correction", "off"}};
    case Without::kStabilisation:
      return kWithoutMemory;
  }
  return std::nullopt;
}

}  // namespace stiction
