// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "reports/record/record.h"
#include "reports/recording/frames.h"
#include "solver/hash.h"
#include "validation/core/case.h"
#include "validation/core/simulation.h"
#include "validation/engine/engine.h"

namespace stiction {

/// What a case is given to run with, and where it leaves what it found.
class CaseRun {
 public:
  /// `settings` are the variant's with the user's over them. A tolerance is multiplied by
  /// `tolerance_scale` before it is compared. The engine's expectations hold where the settings are
  /// those of one of the case's variants, the scale is 1 and time steps are the usual ones
  /// (refine_time).
  CaseRun(const Case& which, EngineKind engine, Settings settings, double tolerance_scale,
          bool keeps_frames = false);

  /// A simulation whose outcome the run takes over when the case lets go of it, so that no simulated
  /// step is ever left out of the bill. It must not outlive the run.
  struct TakeOver {
    CaseRun* run = nullptr;
    void operator()(Simulation* simulation) const;
  };
  using Running = std::unique_ptr<Simulation, TakeOver>;

  /// Starts the engine on a problem. Throws NotApplicable in the engine's words for what it lacks.
  Running simulate(const Problem& problem, const Accuracy& accuracy = {});
  /// The same with `over` over the run's settings: for studies of one engine, and of what an engine
  /// can leave out (settings_without).
  Running simulate_with(const Settings& over, const Problem& problem,
                        const Accuracy& accuracy = {});
  /// Throws NotApplicable with these words where the engine has not got the feature.
  void need(bool Manifest::*feature, const std::string& words) const;
  /// What to lay over the run's settings to leave something out; none: the engine can't.
  std::optional<Settings> settings_without(Without what) const;

  /// Judges a value, in the claim's unit, and keeps what is found; `worst` tells where the worst
  /// offender stood. |error| ≤ tolerance passes; a value that is no number fails; a check of which
  /// the engine's table expects a shortfall is judged by its band (verdict.h). Of a configuration
  /// for contrast a check without an expectation is for information: it stands in the table and
  /// decides nothing.
  void check(Claim claim, double value, std::string worst = "");
  /// Keeps a value that nothing is decided by.
  void show(Claim claim, double value, std::string worst = "");
  /// This case lets bodies part, as a search for a threshold does, or throws them together: where a
  /// configuration lets them pass through each other then, that is a note and no error.
  void bodies_are_thrown() { passages_noted_ = passages_noted_ || configuration_.lets_thrown_pass; }
  /// The case counts passages itself: they are notes, not errors.
  void passages_are_noted() { passages_noted_ = true; }
  /// Simulations end with an InputError when their steps have taken so much CPU time in all, s.
  void limit_cpu(double seconds) { cpu_limit_ = seconds; }
  /// Simulations from now on take 1/finer of their time steps. What the engine is expected to fall
  /// short of at its own step is then for information.
  void refine_time(int finer);
  int finer() const { return finer_; }
  /// To be called once the case has run to its end: an expectation that no check met is a failing
  /// check, so that the table cannot rot.
  void demand_expected_checks();
  void note(std::string text) { record_.notes.push_back(std::move(text)); }
  void add(Series series) { record_.series.push_back(std::move(series)); }
  void add(Figure figure) { record_.figures.push_back(std::move(figure)); }
  void add(Failure failure) { record_.failures.push_back(std::move(failure)); }

  /// A run of the same engine with other settings, whose record can be included (shared_run.h).
  CaseRun part(const Settings& settings) const;
  /// A run of another case, on this engine in disguise (stability/perturbed_engine.h).
  CaseRun nested(const Case& which, EngineKind engine, Settings settings) const;
  /// Takes over the notes and passages of a part, its state hash, and its cost if this run `pays`.
  void include(const Record& part, bool pays);
  /// Takes over the cost of a part alone.
  void pay(const Cost& cost) { bill(cost); }

  const EngineKind& engine() const { return engine_; }
  const Settings& settings() const { return settings_; }
  const Configuration& configuration() const { return configuration_; }

  /// The record so far, verdict and cost included; environment left to the caller. An error if
  /// bodies passed through each other.
  Record record() const;
  std::optional<Recording> take_recording() { return std::move(recording_); }

 private:
  void started(const Engine& engine);  // the record's settings are those of the first simulation
  void ended(Simulated outcome);
  void bill(const Cost& cost);
  void passed(const std::vector<std::string>& passages, bool noted);

  EngineKind engine_;
  Settings settings_;
  Configuration configuration_;
  double tolerance_scale_;
  int finer_ = 1;
  double cpu_limit_ = std::numeric_limits<double>::infinity();
  Expectations expectations_;         // of this case and variant
  std::set<std::string> quantities_;  // checked so far
  Record record_;
  bool settings_resolved_ = false;
  bool passages_noted_ = false;
  bool keeps_frames_;
  bool may_record_ = true;  // no simulation of this case has been recorded, or is being
  std::optional<Recording> recording_;
  Fnv1a hash_;
  std::vector<std::string> passages_;
  std::set<std::string> faults_;             // of arithmetic
  double timed_contacts_ = 0.0;              // contact updates of engines that timed them
  ContactTime contact_phases_, whole_step_;  // × those, ns
};

}  // namespace stiction
