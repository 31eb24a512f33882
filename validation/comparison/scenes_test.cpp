// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/scenes.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

// A box on a slab, settled for 20 ms alone: what is compared is a state, not whether it is at rest.
ComparisonScene short_scene() {
  SlabSetup setup = comparison_slab();
  setup.cells = 2;
  return {.name = "short",
          .title = "",
          .problem = slab_problem(setup),
          .settings = {{"cells", "2"}},
          .settled = 0.02,
          .size = setup.box_size.x()};
}

// Else a program, which can only settle by itself, would begin elsewhere than the engine it is beside.
TEST(ComparisonScenes, AnEngineSettlesByItselfAsTheComparisonSettlesIt) {
  const EngineKind kind = find_engine("stiction");
  const ComparisonScene scene = short_scene();
  Settings settings{{"method", "quiet"}, {"rule", "conjugate-vector"}, {"cells", "2"}};
  const auto compared = kind.make(settings);
  compared->load(scene.problem, {});
  compared->restore(settled_without_memory(kind, scene, contacts_of(settings)).state);
  settings["settled"] = "0.02";
  const auto alone = kind.make(settings);
  alone->load(scene.problem, {});
  EXPECT_EQ(alone->state_hash(), compared->state_hash());
  EXPECT_EQ(alone->steps_done(), 0u);
  EXPECT_EQ(alone->cost().steps, 0u) << "settling is not billed";
  for (Engine* const one : {alone.get(), compared.get()}) one->advance(50);
  EXPECT_EQ(alone->state_hash(), compared->state_hash());
  EXPECT_EQ(alone->steps_done(), 50u);
  EXPECT_EQ(alone->settings().at("settled"), "0.02");
}

}  // namespace
}  // namespace stiction
