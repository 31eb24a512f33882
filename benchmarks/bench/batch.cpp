// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/batch.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>

#include "solver/friction/catalog.h"
#include "solver/hash.h"
#include "solver/step.h"
#include "validation/engine/cpu_time.h"

namespace stiction::bench {

namespace {

// Steps after which a rule's memory no longer grows: fixed points settle in 8 to 16.
constexpr int kRuleSteps = 16;

std::string without_spaces(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

// Both clocks, from when it was made.
class Clocks {
 public:
  Batch::Seconds passed() const {
    const double cpu = thread_cpu_seconds() - cpu_;
    return {cpu, std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count()};
  }

 private:
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  double cpu_ = thread_cpu_seconds();
};

template <class Value>
void add(const std::vector<Value>& values, Fnv1a& hash) {
  hash.add(values.data(), values.size() * sizeof(Value));
}

// Field by field: the padding between them is nobody's.
void add(const PairContact& c, const PairSite& site, Fnv1a& hash) {
  const std::int32_t numbers[] = {c.vertex, c.other, site.element, site.triangle};
  hash.add(numbers, sizeof numbers);
  hash.add(c.partner, sizeof c.partner);
  hash.add(c.weight, sizeof c.weight);
  const double values[] = {c.depth, c.inverse_mass, c.normal_force};
  hash.add(values, sizeof values);
  hash.add(c.normal.data(), sizeof c.normal);
  hash.add(c.friction_force.data(), sizeof c.friction_force);
}

}  // namespace

std::vector<Timed> timed_parts() {
  const std::string usual = kTimedRule;
  std::vector<Timed> parts;
  for (std::size_t p = 0; p < kPhaseNames.size(); ++p) {
    const auto phase = static_cast<Phase>(p);
    const std::string name = without_spaces(kPhaseNames[p]);
    if (phase != Phase::kFriction) {
      parts.push_back({name, phase, false, usual});
      if (phase == Phase::kDetect) parts.push_back({name + ":afresh", phase, false, usual, true});
      continue;
    }
    for (const std::string& rule : friction_rule_names()) {
      parts.push_back({name + ":" + rule, phase, false, rule});
    }
  }
  parts.push_back({"step", {}, true, usual});
  return parts;
}

std::string benchmark_name(const Timed& timed, const std::string& family, int size) {
  return timed.name + "/" + family + "/contacts:" + std::to_string(size);
}

Batch::Batch(const Workload& settled, const Timed& timed)
    : settled_(settled), work_(settled), timed_(timed) {
  if (timed.rule != work_.options.rule) {
    work_.options.rule = timed.rule;
    go_on(work_, kRuleSteps);
  }
  if (!timed.whole_step) {
    for (std::size_t p = 0; p < static_cast<std::size_t>(timed.phase); ++p) {
      run_phase(static_cast<Phase>(p), *work_.scene, work_.options, work_.state, work_.workspace);
    }
  }
  start_ = work_.state;
  velocity_ = work_.workspace.velocity;
  pairs_ = work_.workspace.pairs;
}

void Batch::restore() {
  if (timed_.whole_step) {
    work_.state = start_;
    return;
  }
  Workspace& workspace = work_.workspace;
  switch (timed_.phase) {
    case Phase::kForces:
    case Phase::kPredict:
      return;  // these read the state and write the workspace afresh
    case Phase::kDetect:
      if (!timed_.afresh) return;
      // All have come too far for their lists.
      for (Vec3& from : workspace.search.reference) {
        from.setConstant(std::numeric_limits<Real>::infinity());
      }
      return;
    case Phase::kDepth:
      workspace.pairs = pairs_;
      return;
    case Phase::kNormalForce:
      workspace.velocity = velocity_;
      return;
    case Phase::kFriction:
      workspace.velocity = velocity_;
      work_.state.obstacle_friction = start_.obstacle_friction;
      work_.state.pair_friction = start_.pair_friction;
      work_.state.edge_friction = start_.edge_friction;
      return;
    case Phase::kIntegrate:
      workspace.velocity = velocity_;
      work_.state.position = start_.position;
      work_.state.velocity = start_.velocity;
      return;
  }
}

void Batch::run(const Team* team) {
  work_.workspace.team = team;
  if (timed_.whole_step) {
    step(*work_.scene, work_.options, work_.state, work_.workspace);
  } else {
    run_phase(timed_.phase, *work_.scene, work_.options, work_.state, work_.workspace);
  }
}

void Batch::warm() {
  time();
  if (timed_.afresh) time();  // lists change places with those of the last time: both have to grow
}

Batch::Seconds Batch::time(const Team* team) {
  if (timed_.goes_on()) return time_going_on(team);
  restore();
  const Clocks start;
  run(team);
  return start.passed();
}

void Batch::begin() {
  work_.state = settled_.state;
  work_.workspace = settled_.workspace;
}

const Team* Batch::chosen(const Team& team) {
  TeamChoice choice(team);
  begin();
  work_.workspace.team_choice = &choice;
  for (int k = 0; k < TeamChoice::kFirst + TeamChoice::kTrial; ++k) {
    step(*work_.scene, work_.options, work_.state, work_.workspace);
  }
  work_.workspace.team_choice = nullptr;
  return choice.chosen();
}

Batch::Seconds Batch::time_going_on(const Team* team) {
  if (timed_.whole_step && team != nullptr) team = chosen(*team);
  begin();
  Workspace& workspace = work_.workspace;
  workspace.team = team;
  PhaseSeconds of_phases{};
  if (!timed_.whole_step) workspace.phase_seconds = &of_phases;
  const Clocks start;
  for (int k = 0; k < kStepsInARow; ++k) {
    step(*work_.scene, work_.options, work_.state, workspace);
  }
  if (timed_.whole_step) return start.passed();
  workspace.phase_seconds = nullptr;
  const double seconds = of_phases[static_cast<std::size_t>(timed_.phase)];
  return {seconds, seconds};
}

std::uint64_t Batch::hash() const {
  const Workspace& workspace = work_.workspace;
  Fnv1a hash;
  const std::uint64_t state = hash_of(work_.state);
  hash.add(&state, sizeof state);
  for (const Force& force : workspace.force) hash.add(force.f.data(), sizeof force.f);
  for (const Velocity& velocity : workspace.velocity) hash.add(velocity.v.data(), sizeof(Vec3));
  for (const PairContact& pair : workspace.pairs) add(pair, workspace.pairs.site_of(pair), hash);
  for (const EdgeContact& edge : workspace.edges) {
    hash.add(&edge.key, sizeof edge.key);
    hash.add(&edge.normal_force, sizeof edge.normal_force);
    hash.add(edge.friction_force.data(), sizeof edge.friction_force);
  }
  const OneSidedContacts& contacts = workspace.contacts;
  add(contacts.key, hash);
  add(contacts.depth, hash);
  add(contacts.normal_force, hash);
  for (const Vec3& force : contacts.friction_force) hash.add(force.data(), sizeof force);
  return hash.value();
}

}  // namespace stiction::bench
