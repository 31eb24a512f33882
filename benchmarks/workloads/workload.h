// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction::bench {

/// The friction rule of all workloads, one sweep of which is timed: how many sweeps a step takes
/// depends on how much moves (`quiet` takes one at rest; `./stiction compare` times whole rules).
inline constexpr const char* kTimedRule = "stored-vector";

/// A scene of one size, and how it comes to rest.
struct Setup {
  SceneDescription description;  ///< its drag is set by `settle`
  /// Angular frequency of the slowest bounce of bodies on each other, rad/s: a drag of twice this
  /// rate ends it soonest.
  double bounce = 0.0;
  std::string rule = kTimedRule;  ///< of friction
};

/// Puts the bodies on a ground, the plane z = 0, with one friction for all that touches, under gravity.
void put_on_ground(double friction, Setup& setup);

/// Scenes that differ in size alone. A file in benchmarks/workloads/ returns one from a function
/// `workload_<file>()`; the build writes the catalog.
struct WorkloadFamily {
  std::string name;                ///< that of the file
  std::string title;               ///< one line for people
  std::vector<int> sizes;          ///< about how many contacts, increasing
  std::vector<int> full_sizes;     ///< more of them, with --full
  bool two_sided = true;           ///< bodies touch each other, not only obstacles
  std::function<Setup(int)> make;  ///< for about so many contacts
};

/// All families of the build, by name. Written by the build from benchmarks/workloads/.
std::vector<WorkloadFamily> family_catalog();

/// A scene at rest, ready to be timed, with the proof that it is.
struct Workload {
  std::string family;
  int size = 0;  ///< contacts asked for; `contacts` are those there are
  std::shared_ptr<const Scene> scene;
  Options options;
  State state;          ///< at rest
  Workspace workspace;  ///< warm: what the last step left
  /// How far from rest, in the worst of the last steps: the worst body's unbalanced force over its
  /// weight, and the mean slip of loaded contacts over what gravity adds to a free body's speed in one
  /// step.
  std::vector<Judgement> checks;

  std::size_t contacts() const {
    return workspace.contacts.size() + workspace.pairs.size() + workspace.edges.size();
  }
  double error() const;  ///< largest |error| of the checks, dimensionless
};

/// Takes `steps` ≥ 1 steps more, and checks the worst of the last 20 of them; of fewer than 40, of
/// their second half.
void go_on(Workload& work, int steps);

/// Builds the scene of a family and lets it come to rest.
Workload settle(const WorkloadFamily& family, int contacts);

}  // namespace stiction::bench
