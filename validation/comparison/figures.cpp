// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/figures.h"

#include <algorithm>
#include <cmath>

#include "solver/friction/catalog.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/comparison_table.h"

namespace stiction {

namespace {

// Another build may have other defaults, which the engine tells with the rest: there only what the
// variant sets tells a reading from others.
Settings telling_settings(const Record& record) {
  Settings settings = record.settings;
  if (settings.count(kBuild) == 0) return settings;
  for (const RuleParameter& parameter : friction_rule_parameters(settings.at("rule"))) {
    const std::string set = std::string(" ") + parameter.name + "=";
    if ((" " + record.variant).find(set) == std::string::npos) settings.erase(parameter.name);
  }
  return settings;
}

}  // namespace

Figures::Figures(const std::vector<Record>& records) : records_(records) {}

RuleOnContacts who_of(const Record& record) {
  return {rule_words(telling_settings(record)), contacts_words(record.settings),
          build_words(record.settings)};
}

const Record* Figures::find(const std::string& case_name, const RuleOnContacts& who) const {
  for (const Record& record : records_) {
    if (record.case_name == case_name && who_of(record) == who) return &record;
  }
  return nullptr;
}

double Figures::of(const std::string& case_name, const RuleOnContacts& who,
                   const std::string& quantity) const {
  const Record* record = find(case_name, who);
  return record ? figure(*record, quantity) : std::nan("");
}

bool Figures::failed(const std::string& case_name, const RuleOnContacts& who) const {
  const Record* record = find(case_name, who);
  if (record == nullptr) return false;
  return record->verdict == Verdict::kError || !record->failures.empty();
}

std::vector<std::string> Figures::cases(const std::string& prefix) const {
  std::vector<std::string> names;
  for (const Record& record : records_) {
    if (record.case_name.rfind(prefix, 0) != 0) continue;
    if (names.empty() || names.back() != record.case_name) names.push_back(record.case_name);
  }
  return names;
}

std::vector<RuleOnContacts> Figures::rules(const std::string& prefix) const {
  std::set<RuleOnContacts> all;
  for (const Record& record : records_) {
    if (record.case_name.rfind(prefix, 0) == 0) all.insert(who_of(record));
  }
  const std::vector<std::string> names = cases(prefix);
  std::erase_if(all, [&](const RuleOnContacts& who) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return find(name, who) == nullptr; });
  });
  return {all.begin(), all.end()};
}

Spread spread_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return {std::nan(""), std::nan(""), std::nan("")};
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back()};
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    text += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
  }
  return text;
}

}  // namespace stiction
