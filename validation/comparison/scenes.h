// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "validation/engine.h"
#include "validation/problem.h"
#include "validation/slab_problem.h"

namespace stiction {

/// Something that friction holds, and for how long it settles.
struct ComparisonScene {
  std::string name;
  std::string title;
  Problem problem;
  Settings settings;        ///< of the engine, whatever the rule
  double settled = 0.0;     ///< time at which all loads act and vibration has died out, s
  std::uint64_t steps = 0;  ///< watched from there on
  double size = 0.1;        ///< of a body, m
  bool quick = false;       ///< part of the quick set
};

/// The box on a slab of several comparisons.
SlabSetup comparison_slab();

/// Box on a slab (with vertices of one side in the other and of both), clamped box, box pyramid,
/// four balls, membrane, a piece of the basket.
std::vector<ComparisonScene> comparison_scenes();

/// A flat plate of 169 vertices on a slab, whose contacts' data stay in the cache.
ComparisonScene comparison_plate();

/// The scene settled on the contacts of `method` and then left without friction memory, the same
/// for each rule: it settles with the stored vector, and then does one step without any rule's
/// memory, which leaves every contact as if it were new. Scenes that settle differently have
/// different names or settings. Computed once a program run for each scene
/// and method, whoever asks first; safe to call from many threads.
Snapshot settled_without_memory(const EngineKind& kind, const ComparisonScene& scene,
                                const std::string& method);

}  // namespace stiction
