// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "validation/engine/engine.h"
#include "validation/engine/problem.h"
#include "validation/observe/observe.h"
#include "validation/problems/slopes/slab_problem.h"

namespace stiction {

/// Something that friction holds, and for how long it settles.
struct ComparisonScene {
  std::string name;
  std::string title;
  Problem problem;
  Settings settings;        ///< of the engine, whatever the rule
  double settled = 0.0;     ///< time at which all loads act and vibration has died out, s
  double released = 0.0;    ///< then let slide without friction up to this mean slip, m/s
  std::uint64_t steps = 0;  ///< watched from there on
  double size = 0.1;        ///< of a body, m
  bool quick = false;       ///< part of the quick set
};

/// The box on a slab of several comparisons.
SlabSetup comparison_slab();

/// Box on a slab (with vertices of one side in the other and of both), clamped box, box pyramid,
/// four balls, membrane, a piece of the basket.
std::vector<ComparisonScene> comparison_scenes();

/// The box on a slab that it loads by this share of the cone: tan θ = share · μ. `cells` of the
/// box along an edge: 2 make 9 contacts, 3 make 16.
ComparisonScene loaded_slab(double share, int cells);

/// A flat plate of 169 vertices on a slab, whose contacts' data stay in the cache.
ComparisonScene comparison_plate();

/// What of a rule's settings makes its contacts: the method, and the depth rule where it is given.
Settings contacts_of(const Settings& settings);

/// How a comparison begins.
struct Settled {
  Snapshot state;      ///< null: at the problem's own start
  ContactSlips slips;  ///< that there are in it
};

/// The scene settled on such contacts and then left without friction memory, the same for each
/// rule: it settles with the stored vector, and then does one step without any rule's memory, which
/// leaves every contact as if it were new; or, where it is to be `released`, as many steps without
/// friction as it takes until it slips that fast. Scenes that settle differently have different
/// names, settings or releases. Computed once a program run for each scene and contacts, whoever
/// asks first; safe to call from many threads.
Settled settled_without_memory(const EngineKind& kind, const ComparisonScene& scene,
                               const Settings& contacts);

}  // namespace stiction
