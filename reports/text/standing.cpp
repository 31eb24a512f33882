// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/standing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reports/text/check_text.h"
#include "reports/text/configuration_text.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

constexpr std::size_t kMostCompared = 12;  // subsets are tried one by one

// Quantities of cases about rest, in the words that all of them use.
bool is_share_at_rest(const Claim& claim) {
  return claim.quantity == "share at rest" || claim.quantity == "share of configurations at rest";
}
bool is_slip(const Claim& claim) { return claim.quantity == "fastest contact slip"; }
bool is_drift(const Claim& claim) { return claim.quantity == "drift over 10 s"; }
bool is_motion_at_rest(const Claim& claim) {
  return is_slip(claim) || claim.quantity.starts_with("drift") ||
         claim.quantity.starts_with("creep");
}

bool is_decided(const Judgement& check) {
  return check.verdict != Verdict::kForInformation && check.verdict != Verdict::kNotApplicable;
}

// By the verdict, which knows of a tolerance that was scaled.
bool within(const Judgement& check) {
  return is_decided(check) ? check.verdict == Verdict::kPass : check.of_tolerance <= 1.0;
}

using Cases = std::set<std::string>;

Cases common(const Cases& a, const Cases& b) {
  Cases both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
  return both;
}

struct Group {
  std::vector<const Record*> records{};
  Cases cases{};
};

// The best subset of groups, as a mask, and the cases that they share.
std::pair<unsigned, Cases> shared_by(const std::vector<const Group*>& groups) {
  unsigned best = 0;
  Cases best_cases;
  std::size_t best_size = 0;
  for (unsigned mask = 1; mask < 1u << groups.size(); ++mask) {
    std::size_t members = 0;
    Cases cases;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if ((mask >> g & 1u) == 0) continue;
      cases = members++ == 0 ? groups[g]->cases : common(cases, groups[g]->cases);
    }
    const std::size_t size = members * (members - 1) / 2 * cases.size();
    if (size <= best_size) continue;
    best_size = size;
    best = mask;
    best_cases = std::move(cases);
  }
  return {best, best_cases};
}

void widen(std::optional<double>& most, double value) {
  if (most && std::isnan(*most)) return;  // the worst already
  if (!most || !(std::abs(value) <= *most)) most = std::abs(value);
}

// Records that take as many steps when they go to their end: of the same case, with the same settings
// beyond their configuration's, such as a time step.
std::string step_key(const Record& record) {
  return record.case_name + "\n" + settings_text(record.differs);
}

// Most steps that a record of one simulation took.
std::map<std::string, std::uint64_t> most_steps(const std::vector<Record>& records) {
  std::map<std::string, std::uint64_t> most;
  for (const Record& record : records) {
    if (record.simulations != 1) continue;
    std::uint64_t& steps = most[step_key(record)];
    steps = std::max(steps, record.cost.steps);
  }
  return most;
}

void look_at_rest(Standing& row, const Record& record) {
  for (const Judgement& check : record.checks) {
    if (is_share_at_rest(check.claim)) {
      row.least_at_rest = std::min(row.least_at_rest.value_or(check.value), check.value);
      row.most_at_rest = std::max(row.most_at_rest.value_or(check.value), check.value);
    }
    if (is_slip(check.claim)) widen(row.slip, check.value);
    if (is_drift(check.claim)) widen(row.drift, check.value);
    if (is_motion_at_rest(check.claim) && check.claim.tolerance > 0.0) {
      row.creeps = row.creeps || !within(check);
    }
  }
}

void count(Standing& row, const Record& record, bool shared,
           const std::map<std::string, std::uint64_t>& steps) {
  const bool held = holds(record), judged = is_judged(record);
  row.ran += judged;
  row.not_judged += !judged;
  row.held += held;
  look_at_rest(row, record);
  if (row.compared && !shared) return;
  row.shared += judged;
  row.held_shared += held;
  row.cpu_seconds += record.cost.cpu_seconds;
  const auto most = steps.find(step_key(record));
  row.ended_early += !held && record.simulations == 1 && most != steps.end() &&
                     10 * record.cost.steps < 9 * most->second;
}

}  // namespace

bool is_judged(const Record& record) {
  return record.verdict == Verdict::kError ||
         std::any_of(record.checks.begin(), record.checks.end(), is_decided);
}

bool holds(const Record& record) {
  return record.verdict != Verdict::kError && is_judged(record) &&
         std::all_of(record.checks.begin(), record.checks.end(),
                     [](const Judgement& one) { return !is_decided(one) || within(one); });
}

Standings standings_of(const std::vector<Record>& records) {
  std::set<std::string> engines;
  for (const Record& record : records) engines.insert(record.engine);
  std::map<std::string, Group> groups;
  for (const Record& record : records) {
    if (record.verdict == Verdict::kNotApplicable) continue;
    const std::string name = configuration_name(record);
    Group& group = groups[engines.size() > 1 ? one_line(record.engine) + ", " + name : name];
    group.records.push_back(&record);
    group.cases.insert(record.case_name);
  }
  std::vector<const Group*> candidates;
  for (const auto& [name, group] : groups) candidates.push_back(&group);
  std::stable_sort(candidates.begin(), candidates.end(), [](const Group* a, const Group* b) {
    return a->cases.size() > b->cases.size();
  });
  if (candidates.size() > kMostCompared) candidates.resize(kMostCompared);
  const auto [mask, cases] = shared_by(candidates);

  Standings all{.rows = {}, .shared_cases = cases.size()};
  const std::map<std::string, std::uint64_t> steps = most_steps(records);
  for (const auto& [name, group] : groups) {
    Standing row{.name = name, .records = group.records};
    for (std::size_t g = 0; g < candidates.size(); ++g) {
      row.compared = row.compared || (candidates[g] == &group && (mask >> g & 1u) != 0);
    }
    for (const Record* record : group.records) {
      count(row, *record, cases.contains(record->case_name), steps);
    }
    all.compared += row.compared;
    all.rows.push_back(std::move(row));
  }
  std::stable_sort(all.rows.begin(), all.rows.end(), [](const Standing& a, const Standing& b) {
    if (a.compared != b.compared) return a.compared;
    const std::size_t of_a = a.held_shared * b.shared, of_b = b.held_shared * a.shared;
    return of_a != of_b ? of_a > of_b : a.held > b.held;
  });
  return all;
}

}  // namespace stiction
