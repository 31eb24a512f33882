// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// A rule as it stood in a comparison.
struct RuleOnContacts {
  std::string rule;  ///< as rule_words() puts it
  std::string
      contacts;  ///< as contacts_words() puts it: "paper", "quiet", "paper, consistent depth"
  std::string build{};  ///< of the engine, as build_words() puts it: "single precision"; mostly ""
  auto operator<=>(const RuleOnContacts&) const = default;
  std::string words() const {
    return rule + " on " + contacts + " contacts" + (build.empty() ? "" : " in " + build);
  }
};

/// The records of a comparison, to be asked for figures.
class Figures {
 public:
  explicit Figures(const std::vector<Record>& records);

  /// Value of a quantity; NaN when it was not compared.
  double of(const std::string& case_name, const RuleOnContacts& who,
            const std::string& quantity) const;

  /// Names of the cases that begin with `prefix`, and the rules that stood in all of them.
  std::vector<std::string> cases(const std::string& prefix) const;
  std::vector<RuleOnContacts> rules(const std::string& prefix) const;
  bool failed(const std::string& case_name, const RuleOnContacts& who) const;

  const std::vector<Record>& records() const { return records_; }

 private:
  const Record* find(const std::string& case_name, const RuleOnContacts& who) const;

  const std::vector<Record>& records_;
};

/// Who stood in a record.
RuleOnContacts who_of(const Record& record);

/// Least, median and largest of some figures, but those that are no number.
struct Spread {
  double least = 0.0, median = 0.0, most = 0.0;
};
Spread spread_of(std::vector<double> values);

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words);

}  // namespace stiction
