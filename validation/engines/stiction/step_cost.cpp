// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/step_cost.h"

#include <algorithm>
#include <numeric>

#include "reference/statistics/two_samples.h"

namespace stiction {

namespace {

// One step of so many is timed.
constexpr std::uint64_t kTimedEvery = 16;
// The median of half as many is good to 4 % of their spread, 1.25 σ/√1024; more would grow with the
// run. Even, so that the time after thinning out is one that is kept.
constexpr std::size_t kMostTimes = 2048;

// What an empty PhaseTimer adds, s: the smallest of many, since noise only adds.
double clock_overhead() {
  double smallest = 1.0;
  for (int k = 0; k < 200; ++k) {
    PhaseSeconds seconds{};
    { const PhaseTimer timer(&seconds, Phase::kForces); }
    smallest = std::min(smallest, seconds[0]);
  }
  return smallest;
}

}  // namespace

StepCost::StepCost() : overhead_(clock_overhead()) {}

PhaseSeconds* StepCost::phases_of(std::uint64_t step) {
  return step % kTimedEvery == 0 ? &phase_seconds_ : nullptr;
}

void StepCost::add_step(const Workspace& workspace) {
  ++steps_;
  if (workspace.phase_seconds == nullptr) return;
  ++timed_steps_;
  note_contact_time(workspace.contacts.size() + workspace.pairs.size() + workspace.edges.size());
}

// The step just timed, per contact, less what reading the clock costs.
void StepCost::note_contact_time(std::size_t contacts) {
  const auto since = [](double now, double& last, double phases, double overhead) {
    const double spent = now - last - phases * overhead;
    last = now;
    return spent;
  };
  const auto of = [this](Phase phase) { return phase_seconds_[static_cast<std::size_t>(phase)]; };
  const double contact =
      since(of(Phase::kNormalForce) + of(Phase::kFriction), contact_seconds_, 2.0, overhead_);
  const double all = since(std::accumulate(phase_seconds_.begin(), phase_seconds_.end(), 0.0),
                           all_seconds_, static_cast<double>(phase_seconds_.size()), overhead_);
  if (contacts == 0 || with_contacts_++ % stride_ != 0) return;
  if (seconds_per_contact_.size() == kMostTimes) thin_out();
  const auto count = static_cast<double>(contacts);
  seconds_per_contact_.push_back({contact / count, all / count});
}

ContactTime StepCost::time_of(double PerContact::*part) const {
  if (seconds_per_contact_.empty()) return {};
  std::vector<double> ns;
  for (const PerContact& seconds : seconds_per_contact_) ns.push_back(1e9 * (seconds.*part));
  const reference::Quartiles quartiles = reference::quartiles(std::move(ns));
  return {quartiles.median, quartiles.lower, quartiles.upper};
}

// Every other one stays, and from now on every other one is kept.
void StepCost::thin_out() {
  for (std::size_t k = 0; 2 * k < kMostTimes; ++k) {
    seconds_per_contact_[k] = seconds_per_contact_[2 * k];
  }
  seconds_per_contact_.resize(kMostTimes / 2);
  stride_ *= 2;
}

Cost StepCost::total(std::uint64_t contact_updates) const {
  Cost cost;
  cost.cpu_seconds = cpu_seconds_;
  cost.steps = steps_;
  cost.contact_updates = contact_updates;
  for (std::size_t p = 0; p < phase_seconds_.size(); ++p) {
    const double net =
        std::max(0.0, phase_seconds_[p] - overhead_ * static_cast<double>(timed_steps_));
    // Scaled up from the timed steps to all steps.
    cost.phase_seconds[kPhaseNames[p]] =
        timed_steps_ == 0 ? 0.0
                          : net * static_cast<double>(steps_) / static_cast<double>(timed_steps_);
  }
  cost.contact_phases = time_of(&PerContact::contact_phases);
  cost.whole_step = time_of(&PerContact::whole_step);
  return cost;
}

}  // namespace stiction
