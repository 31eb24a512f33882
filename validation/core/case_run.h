// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "reports/record/frames.h"
#include "reports/record/record.h"
#include "solver/hash.h"
#include "validation/core/case.h"
#include "validation/core/recorder.h"
#include "validation/engine/engine.h"

namespace stiction {

class CaseRun;
class PassageWatch;

/// An engine that has taken a problem. Whether bodies pass through each other is watched from
/// outside (passage_watch.h). Its cost and state hash go into the case's record when the
/// object ends, so no simulated step is ever left out of the bill.
class Simulation {
 public:
  Simulation(CaseRun& run, const EngineKind& kind, const Settings& settings, const Problem& problem,
             const Accuracy& accuracy);
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

  /// This simulation stands for a method that is known to break: bodies that pass through each
  /// other are a note in the record, not an error.
  void shows_contrast() { contrast_ = true; }

  Engine& engine() { return *engine_; }
  const Engine& engine() const { return *engine_; }

 private:
  CaseRun& run_;
  std::unique_ptr<Engine> engine_;
  std::optional<Recorder> recorder_;  // where the run keeps frames
  std::unique_ptr<PassageWatch> watch_;
  bool contrast_;
};

/// What a case is given to run with, and where it leaves what it found.
class CaseRun {
 public:
  /// `settings` are the variant's with the user's over them. A tolerance is multiplied by
  /// `tolerance_scale` before it is compared. The engine's expectations hold where the settings are
  /// those of one of the case's variants and the scale is 1.
  CaseRun(const Case& which, EngineKind engine, Settings settings, double tolerance_scale,
          bool keeps_frames = false);

  /// Starts the engine on a problem. Throws NotApplicable in the engine's words for what it lacks.
  std::unique_ptr<Simulation> simulate(const Problem& problem, const Accuracy& accuracy = {});
  /// The same with `over` over the run's settings: for studies of one engine, and of what an engine
  /// can leave out (settings_without).
  std::unique_ptr<Simulation> simulate_with(const Settings& over, const Problem& problem,
                                            const Accuracy& accuracy = {});
  /// Throws NotApplicable with these words where the engine has not got the feature.
  void need(bool Manifest::*feature, const std::string& words) const;
  /// What to lay over the run's settings to leave something out; none: the engine can't.
  std::optional<Settings> settings_without(Without what) const;

  /// Fills in error, digits and verdict from value, expected and tolerance, and keeps the check.
  /// |error| ≤ tolerance passes; a value that is no number fails; a check of which the engine's
  /// table expects a shortfall is judged by its band (verdict.h). Of a configuration for contrast a
  /// check without an expectation is only shown: it stands in the table and decides nothing.
  void check(Check check);
  /// This case lets bodies part, as a search for a threshold does, or throws them together: where a
  /// configuration lets them pass through each other then, that is a note and no error.
  void bodies_are_thrown() { passages_noted_ = passages_noted_ || configuration_.lets_thrown_pass; }
  /// The case counts passages itself: they are notes, not errors.
  void passages_are_noted() { passages_noted_ = true; }
  /// To be called once the case has run to its end: an expectation that no check met is a failing
  /// check, so that the table cannot rot.
  void demand_expected_checks();
  void note(std::string text) { record_.notes.push_back(std::move(text)); }
  void add(Series series) { record_.series.push_back(std::move(series)); }

  /// A run of the same engine with other settings, whose record can be included (shared_run.h).
  CaseRun part(const Settings& settings) const;
  /// Takes over the notes and passages of a part, its state hash, and its cost if this run `pays`.
  void include(const Record& part, bool pays);

  const EngineKind& engine() const { return engine_; }
  const Settings& settings() const { return settings_; }
  const Configuration& configuration() const { return configuration_; }

  /// The record so far, verdict and cost included; environment left to the caller. An error if
  /// bodies passed through each other.
  Record record() const;
  std::optional<Recording> take_recording() { return std::move(recording_); }

 private:
  friend class Simulation;
  void started(const Engine& engine);  // the record's settings are those of the first simulation
  void ended(const Engine& engine);
  void bill(const Cost& cost);
  void passed(const std::vector<std::string>& passages, bool noted);

  EngineKind engine_;
  Settings settings_;
  Configuration configuration_;
  double tolerance_scale_;
  Expectations expectations_;         // of this case and variant
  std::set<std::string> quantities_;  // checked so far
  Record record_;
  bool settings_resolved_ = false;
  bool passages_noted_ = false;
  bool keeps_frames_;
  bool recorded_ = false;  // a simulation of this case has been, or is being
  std::optional<Recording> recording_;
  Fnv1a hash_;
  std::vector<std::string> passages_;
  double timed_contacts_ = 0.0;  // contact updates of engines that timed them
  double contact_seconds_ = 0.0;
};

}  // namespace stiction
