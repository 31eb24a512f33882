// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stiction::track {

/// What a metric counts, and so how two of its measurements are compared and which way is better.
enum class Kind {
  kTime,     ///< sampled, noisy, lower is better
  kCount,    ///< deterministic work (instructions, contact updates, allocations), lower is better
  kDigits,   ///< deterministic accuracy in digits, higher is better
  kVerdict,  ///< deterministic; 0 holds or decides nothing, 1 falls short as expected or refuted,
             ///< 2 fails, 3 broke off
  kOther,    ///< imported from another program; compared as a time
};

struct Metric {
  std::string subject{};  ///< what was run, e.g. "friction:fixed-point/slab/contacts:1000"
  std::string what{};     ///< what was measured of it, e.g. "time", "instructions", "digits: creep"
  std::string unit{};     ///< SI, "1" when dimensionless
  Kind kind = Kind::kTime;

  /// How a person names it: subject#what.
  std::string name() const { return subject + "#" + what; }

  bool operator==(const Metric&) const = default;
};

bool higher_is_better(Kind kind);

/// Spelling in the history ("time", "count", …), and back; nothing for an unknown word.
std::string to_string(Kind kind);
std::optional<Kind> parse_kind(const std::string& word);

/// A metric's samples in the order they were taken; deterministic metrics have one.
struct Measurement {
  Metric metric;
  std::vector<double> samples;
};

/// Measurements of one revision, by Metric::name().
class Measurements {
 public:
  /// Adds a sample; −0 as 0, for the history keeps no sign of it. Values that are not finite are left
  /// out: they can be neither compared nor stored.
  void add(const Metric& metric, double sample);
  void merge(const Measurements& other);

  const Measurement* find(const std::string& name) const;
  const std::map<std::string, Measurement>& all() const { return by_name_; }

 private:
  std::map<std::string, Measurement> by_name_;
};

}  // namespace stiction::track
