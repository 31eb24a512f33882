// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/decide/accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "benchmarks/track/measure/child.h"
#include "benchmarks/track/store/fingerprint.h"
#include "benchmarks/track/store/remembered.h"
#include "benchmarks/track/store/scratch.h"
#include "reports/record/record_json.h"
#include "reports/text/exit_code.h"

namespace stiction::track {

namespace {

double rank_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kShortfall:
    case Verdict::kRefuted:
      return 1.0;
    case Verdict::kFail:
      return 2.0;
    case Verdict::kError:
      return 3.0;
    default:
      return 0.0;
  }
}

// Digits of a check, or, where zero is expected and nothing says of what size, how many powers of
// ten its error is below its tolerance.
double digits_of(const Judgement& check, const Cost& cost) {
  constexpr double kNegligible = 3.0;  // a thousandth of a tolerance decides nothing
  if (!check.digits) {
    return std::isfinite(check.of_tolerance)
               ? std::min(-std::log10(check.of_tolerance), kNegligible)
               : 0.0;
  }
  const auto steps = static_cast<double>(std::max<std::uint64_t>(1, cost.steps));
  const double floor = -std::log10(steps * std::numeric_limits<double>::epsilon());
  // NaN has no digits.
  return std::isfinite(*check.digits) ? std::min(*check.digits, floor) : 0.0;
}

// "steps until …", "steps to …": fewer are better, unlike other quantities.
bool counts_steps(const Judgement& check) { return check.claim.quantity.rfind("steps", 0) == 0; }

void add_check(const Judgement& check, const Cost& cost, const std::string& subject,
               Measurements& measured) {
  if (check.verdict == Verdict::kForInformation || check.verdict == Verdict::kNotApplicable) return;
  measured.add({subject, "verdict: " + check.claim.quantity, "1", Kind::kVerdict},
               rank_of(check.verdict));
  // A value in its band is what it was.
  if (check.verdict == Verdict::kShortfall || check.verdict == Verdict::kRefuted) return;
  if (counts_steps(check)) {
    measured.add({subject, check.claim.quantity, "1", Kind::kCount}, check.value);
  } else {
    const char* what = check.digits ? "digits: " : "digits within tolerance: ";
    measured.add({subject, what + check.claim.quantity, "1", Kind::kDigits},
                 digits_of(check, cost));
  }
}

std::string value_of(const Record& record, const std::string& setting) {
  const auto found = record.settings.find(setting);
  return found == record.settings.end() ? "" : found->second;
}

// The records' values of these settings, one text a record.
std::set<std::string> variants(const std::vector<const Record*>& records,
                               const std::set<std::string>& settings) {
  std::set<std::string> texts;
  for (const Record* record : records) {
    std::string text;
    for (const std::string& setting : settings) text += value_of(*record, setting) + '\n';
    texts.insert(text);
  }
  return texts;
}

// As few settings as tell these records from each other: the one that tells most apart is taken
// first, of equals the first in the alphabet.
std::set<std::string> telling_settings(const std::vector<const Record*>& records) {
  std::set<std::string> names, chosen;
  for (const Record* record : records) {
    for (const auto& [name, value] : record->settings) names.insert(name);
  }
  for (std::size_t told = 1;;) {
    std::string best;
    for (const std::string& name : names) {
      std::set<std::string> with = chosen;
      with.insert(name);
      const std::size_t count = variants(records, with).size();
      if (count <= told) continue;
      told = count;
      best = name;
    }
    if (best.empty()) return chosen;
    chosen.insert(best);
  }
}

std::string subject_of(const Record& record, const std::set<std::string>& telling) {
  std::string subject = record.case_name;
  char sign = '@';
  for (const auto& [name, value] : record.settings) {
    if (!telling.contains(name)) continue;
    subject += fmt::format("{}{}={}", sign, name, value);
    sign = ',';
  }
  return subject;
}

// Runs validate, and gives its records.jsonl.
std::string run_validate(const Tree& tree, const CaseOptions& options) {
  const Scratch scratch;
  std::vector<std::string> words = {tree.program("validate").string(),
                                    "--out",
                                    scratch.folder().string(),
                                    "--no-page",
                                    "--jobs",
                                    "1"};
  words.insert(words.end(), options.begin(), options.end());
  const Ended ended = run(words);
  const std::string text = content_of(scratch.folder() / "latest" / "records.jsonl");
  // Without records it could not run at all; with them, code 2 is a case that broke off.
  if (ended.code > kCouldNotRun || text.empty()) {
    throw TrackError(
        fmt::format("the cases of {} cannot be run: {}", tree.label, last_line(ended.errors)));
  }
  return text;
}

}  // namespace

CaseAccuracy accuracy_of(const std::vector<Record>& records) {
  std::map<std::string, std::vector<const Record*>> by_case;
  for (const Record& record : records) by_case[record.case_name].push_back(&record);
  CaseAccuracy accuracy;
  for (const auto& [name, siblings] : by_case) {
    const std::set<std::string> telling = telling_settings(siblings);
    for (const Record* record : siblings) {
      const std::string subject = subject_of(*record, telling);
      accuracy.measurements.add({subject, "verdict", "1", Kind::kVerdict},
                                rank_of(record->verdict));
      accuracy.measurements.add({subject, "contact updates", "1", Kind::kCount},
                                static_cast<double>(record->cost.contact_updates));
      for (const Judgement& check : record->checks) {
        add_check(check, record->cost, subject, accuracy.measurements);
      }
      accuracy.state_hash[subject] = record->state_hash;
      accuracy.machine = machine_of(record->environment);
    }
  }
  return accuracy;
}

CaseAccuracy measure_accuracy(const Tree& tree, const CaseOptions& options, const Project& project,
                              bool fresh) {
  std::string key = content_hash(tree.program("validate"));
  for (const std::string& option : options) key += " " + option;
  const std::string text = remembered(project.work / "accuracy", key, fresh,
                                      [&] { return run_validate(tree, options); });
  std::istringstream stream(text);
  return accuracy_of(read_records(stream, "records of " + tree.label).records);
}

}  // namespace stiction::track
