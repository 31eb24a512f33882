// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "solver/demand.h"
#include "validation/observe/arithmetic_watch.h"
#include "validation/observe/passage_watch.h"

namespace stiction {

Simulation::Simulation(const EngineKind& kind, const Settings& settings, const Problem& problem,
                       const Accuracy& accuracy, bool* may_record)
    : engine_(kind.make(settings)),
      watch_(std::make_unique<PassageWatch>(problem)),
      may_record_(may_record),
      contrast_(kind.configuration && kind.configuration(settings).contrast) {
  engine_->load(problem, accuracy);
  if (may_record_ != nullptr) recorder_.emplace(problem);
}

Simulation::~Simulation() = default;

Simulated Simulation::outcome() noexcept {
  Simulated outcome;
  outcome.contrast = contrast_;
  try {
    outcome.faults = faults_;
    outcome.cost = engine_->cost();
    outcome.cost.simulated_seconds = static_cast<double>(outcome.cost.steps) * engine_->time_step();
    if (engine_->steps_done() > 0) watch_->look(*engine_, true);
    outcome.passages = watch_->found();
    outcome.state_hash = engine_->state_hash();
  } catch (const std::exception& error) {
    outcome.passages = {
        fmt::format("whether bodies pass through each other is not known: {}", error.what())};
  }
  if (recorder_ && recorder_->has_frames()) outcome.recording = std::move(*recorder_).recording();
  return outcome;
}

double Simulation::time() const {
  return static_cast<double>(engine_->steps_done()) * engine_->time_step();
}

void Simulation::advance_to(double time) {
  const auto target = static_cast<std::uint64_t>(std::llround(time / engine_->time_step()));
  if (target > engine_->steps_done()) advance(target - engine_->steps_done());
}

void Simulation::advance(std::uint64_t steps) {
  const std::uint64_t target = engine_->steps_done() + steps;
  // Under a limit by few steps at first, and then by twice as many, so that it is kept about.
  std::uint64_t most = std::isfinite(cpu_limit_) ? 1 : steps;
  const auto advance_until = [&](std::uint64_t step) {
    while (step > engine_->steps_done()) {
      const ArithmeticWatch arithmetic;
      engine_->advance(std::min(most, step - engine_->steps_done()));
      if (faults_.empty()) faults_ = arithmetic.found();
      if (engine_->cpu_seconds() > cpu_limit_) break;
      most = std::min(steps, 2 * most);
    }
    if (engine_->cpu_seconds() > cpu_limit_) {
      throw InputError(fmt::format("gave up at t = {:.3g} s: its CPU time is used up", time()));
    }
  };
  const auto frame = [this] { return recorder_ ? recorder_->due_step() : Recorder::kNever; };
  while (std::min(frame(), watch_->due_step()) <= target) {
    advance_until(std::min(frame(), watch_->due_step()));
    if (frame() <= engine_->steps_done()) recorder_->take(*engine_);
    if (watch_->due_step() <= engine_->steps_done()) watch_->look(*engine_);
  }
  advance_until(target);
}

void Simulation::record_frames(double interval) {
  if (!recorder_ || !*may_record_) return;
  *may_record_ = false;
  recorder_->start(*engine_, interval);
}

}  // namespace stiction
