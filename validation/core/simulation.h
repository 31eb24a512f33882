// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/recording/frames.h"
#include "validation/core/recorder.h"
#include "validation/engine/engine.h"

namespace stiction {

class PassageWatch;

/// What a simulation leaves behind.
struct Simulated {
  Cost cost{};                          ///< of all its steps
  std::uint64_t state_hash = 0;         ///< of its last state
  std::vector<std::string> passages{};  ///< bodies that passed through each other, a sentence each
  bool contrast = false;                ///< known to break: what goes wrong is a note, not an error
  std::string faults{};                 ///< of its arithmetic (arithmetic_watch.h); empty: none
  std::optional<Recording> recording{};
};

/// An engine that has taken a problem. Whether bodies pass through each other is watched from
/// outside (passage_watch.h).
class Simulation {
 public:
  /// `may_record`: whether a simulation of this case may still take frames; null where the run
  /// keeps none. Throws what the engine says when it refuses the problem.
  Simulation(const EngineKind& kind, const Settings& settings, const Problem& problem,
             const Accuracy& accuracy, bool* may_record = nullptr);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  double time() const;                ///< s
  void advance(std::uint64_t steps);  ///< whole steps
  void advance_to(double time);       ///< to the nearest step, never backwards

  /// From now on advancing takes a frame every `interval` (s) for the report's player: of the first
  /// simulation of a case that asks, and only where the run keeps frames. Between steps, so that
  /// neither the state nor the cost changes.
  void record_frames(double interval);

  /// Advancing throws InputError once the engine's steps have taken longer, s of CPU time.
  void limit_cpu(double seconds) { cpu_limit_ = seconds; }

  /// This simulation stands for a method that is known to break: bodies that pass through each
  /// other, and arithmetic without an answer, are a note in the record, not an error.
  void shows_contrast() { contrast_ = true; }

  Engine& engine() { return *engine_; }
  const Engine& engine() const { return *engine_; }

  /// To be called once, when nothing is advanced any more. Throws nothing: a watch that fails is a
  /// passage that says so.
  Simulated outcome() noexcept;

 private:
  std::unique_ptr<Engine> engine_;
  std::optional<Recorder> recorder_;  // where the run keeps frames
  std::unique_ptr<PassageWatch> watch_;
  bool* may_record_;
  std::string faults_;
  bool contrast_;
  double cpu_limit_ = std::numeric_limits<double>::infinity();
};

}  // namespace stiction
