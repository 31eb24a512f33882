// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/decide/metric.h"

#include <cmath>
#include <utility>

namespace stiction::track {

namespace {

constexpr std::pair<Kind, const char*> kKinds[] = {{Kind::kTime, "time"},
                                                   {Kind::kCount, "count"},
                                                   {Kind::kDigits, "digits"},
                                                   {Kind::kVerdict, "verdict"},
                                                   {Kind::kOther, "other"}};

}  // namespace

bool higher_is_better(Kind kind) { return kind == Kind::kDigits; }

std::string to_string(Kind kind) {
  for (const auto& [known, word] : kKinds) {
    if (known == kind) return word;
  }
  return "unknown";
}

std::optional<Kind> parse_kind(const std::string& word) {
  for (const auto& [kind, known] : kKinds) {
    if (word == known) return kind;
  }
  return std::nullopt;
}

void Measurements::add(const Metric& metric, double sample) {
  if (!std::isfinite(sample)) return;
  Measurement& measurement = by_name_[metric.name()];
  measurement.metric = metric;
  measurement.samples.push_back(sample + 0.0);
}

void Measurements::merge(const Measurements& other) {
  for (const auto& [name, measurement] : other.all()) {
    for (const double sample : measurement.samples) add(measurement.metric, sample);
  }
}

const Measurement* Measurements::find(const std::string& name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &found->second;
}

}  // namespace stiction::track
