// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/comparison.h"

#include <fmt/format.h>

#include <map>

#include "solver/friction/catalog.h"
#include "validation/engine/build_of.h"
#include "validation/engines/stiction/stiction_method.h"

namespace stiction {

namespace {

// Readings and numbers of sweeps beside a rule's default.
const std::multimap<std::string, Settings> kReadings = {
    {"bias-vector", {{"memory", "keep"}}},
    {"fixed-point", {{"alpha", "-0.1"}}},  // the paper's, in s/m
    {"fixed-point", {{"memory", "keep"}}},
    {"secant", {{"memory", "keep"}}},
    {"secant", {{"safeguard", "off"}}},
    {"stored-vector", {{"sweeps", "4"}}},
    {"stored-vector", {{"sweeps", "8"}}},
};

std::vector<Settings> on_both_contacts(const std::vector<Settings>& rules) {
  std::vector<Settings> variants;
  for (const char* method : {"paper", "quiet"}) {
    for (Settings settings : rules) {
      settings["method"] = method;
      variants.push_back(std::move(settings));
    }
  }
  return variants;
}

// Another build of the engine, which is told the rest of a variant's settings.
EngineKind in_build(const EngineKind& engine, const std::string& build) {
  EngineKind kind = engine;
  try {
    kind = build_of(engine, build);
  } catch (const NotApplicable& why) {
    kind.make = [words = std::string(why.what())](const Settings&) -> std::unique_ptr<Engine> {
      throw NotApplicable(words);
    };
    return kind;
  }
  kind.make = [make = kind.make](Settings settings) {
    settings.erase(kBuild);
    return make(settings);
  };
  return kind;
}

std::vector<Settings> readings_of(const std::string& rule) {
  std::vector<Settings> all{{{"rule", rule}}};
  const auto [begin, end] = kReadings.equal_range(rule);
  for (auto reading = begin; reading != end; ++reading) {
    all.push_back(reading->second);
    all.back()["rule"] = rule;
  }
  return all;
}

}  // namespace

std::vector<Settings> all_rules() {
  std::vector<Settings> rules;
  for (const std::string& rule : friction_rule_names()) {
    for (Settings& reading : readings_of(rule)) rules.push_back(std::move(reading));
  }
  return on_both_contacts(rules);
}

std::vector<Job> with_builds(std::vector<Job> jobs) {
  std::map<std::string, EngineKind> known;
  for (Job& job : jobs) {
    const auto asked = job.settings.find(kBuild);
    if (asked == job.settings.end()) continue;
    const auto found = known.find(asked->second);
    job.engine =
        found != known.end()
            ? found->second
            : known.emplace(asked->second, in_build(job.engine, asked->second)).first->second;
  }
  return jobs;
}

std::vector<Settings> chief_rules() {
  std::vector<Settings> rules;
  for (const char* rule : {"fixed-point", "secant", "stored-vector", "conjugate-vector"}) {
    rules.push_back(readings_of(rule).front());
  }
  return on_both_contacts(rules);
}

std::vector<Settings> scalar_and_vector() {
  std::vector<Settings> variants;
  for (const char* depth : {"projection", "consistent"}) {
    for (const char* rule : {"fixed-point", "bias-vector", "stored-vector"}) {
      variants.push_back({{"method", "paper"}, {"depth", depth}, {"rule", rule}});
    }
  }
  for (const char* rule : {"fixed-point", "bias-vector", "stored-vector", "conjugate-vector"}) {
    variants.push_back({{"method", "quiet"}, {"rule", rule}});
  }
  return variants;
}

std::string build_words(const Settings& settings) {
  const auto found = settings.find(kBuild);
  if (found == settings.end()) return "";
  return found->second == "single" ? "single precision" : "build " + found->second;
}

std::string contacts_words(const Settings& settings) {
  const std::string& method = settings.at("method");
  const auto depth = settings.find("depth");
  Options own;
  const Settings given{{"method", method}};
  SettingsReader reader(given);
  read_method(reader, own);
  return depth == settings.end() || depth->second == method_settings(own, true).at("depth")
             ? method
             : fmt::format("{}, {} depth", method, depth->second);
}

std::string rule_words(const Settings& settings) {
  const std::string& rule = settings.at("rule");
  const Settings usual = rule_settings({.rule = rule});
  std::string words = rule;
  for (const RuleParameter& parameter : friction_rule_parameters(rule)) {
    const auto found = settings.find(parameter.name);
    if (found == settings.end()) continue;
    const auto known = usual.find(parameter.name);
    if (known != usual.end() && known->second == found->second) continue;
    words += fmt::format(", {} = {}", parameter.name, found->second);
  }
  const auto sweeps = settings.find("sweeps");
  if (sweeps != settings.end()) {
    const bool fewer = friction_rule_card(rule).sweeps > 1;  // it may end them before
    words += fmt::format(", {}{} sweeps", fewer ? "at most " : "", sweeps->second);
  }
  return words;
}

}  // namespace stiction
