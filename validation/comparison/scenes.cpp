// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <mutex>

#include "solver/demand.h"
#include "validation/observe/observe.h"
#include "validation/problems/clamp_problem.h"
#include "validation/problems/piles/ball_pyramid_problem.h"
#include "validation/problems/piles/basket_problem.h"
#include "validation/problems/piles/pyramid_problem.h"
#include "validation/problems/slopes/incline_problem.h"
#include "validation/problems/slopes/membrane_problem.h"
#include "validation/problems/slopes/slab_problem.h"

namespace stiction {

namespace {

constexpr std::uint64_t kLongestRelease = 1000;  // steps

ComparisonScene slab() {
  const SlabSetup setup = comparison_slab();
  return {.name = "slab",
          .title = "a box on a deformable slab at 20°",
          .problem = slab_problem(setup),
          .settings = {{"cells", fmt::format("{}", setup.cells)}},
          .settled = 4.0,
          .steps = 3000,
          .size = setup.box_size.x(),
          .quick = true};
}

// The pose of slab/convergence: one vertex of the slab reaches into the box.
ComparisonScene both_sides() {
  SlabSetup setup = comparison_slab();
  setup.cells = 2;
  ComparisonScene scene = slab();
  scene.name = "slab-both-sides";
  scene.title =
      "… with vertices of both sides in each other, so that contacts say nearly the same twice";
  scene.problem = slab_problem(setup);
  scene.settings = {{"cells", fmt::format("{}", setup.cells)}};
  return scene;
}

ComparisonScene clamp() {
  ClampSetup setup;
  setup.bar = Vec3(0.04, 0.14, 0.08);
  setup.bar_cells = {1, 2, 1};
  setup.offset = 0.04;
  return {.name = "clamp",
          .title = "a box between two offset bars",
          .problem = clamp_problem(setup),
          .settings = {},
          .settled = 2.5,
          .steps = 3000,
          .size = setup.width};
}

ComparisonScene pyramid() {
  const PyramidSetup setup;
  return {.name = "box-pyramid",
          .title = "a pyramid of six boxes on a slope, tan θ = 0.2, μ = 0.3",
          .problem = pyramid_problem(setup),
          .settings = {{"cells", fmt::format("{}", setup.cells)}},
          .settled = setup.settled,
          .steps = 3000,
          .size = setup.width,
          .quick = true};
}

// Stiff balls of few facets, which stand on them: softer ones, or ones of more facets, go on
// rolling towards facets that fit into each other better, and friction then has nothing to hold.
ComparisonScene balls() {
  BallPyramidSetup setup;
  setup.frequency = 3;
  setup.friction = 0.4;
  setup.drag = {.rate = 30.0, .full_until = 1.4, .ends = 1.6};
  return {.name = "four-balls",
          .title = "a pyramid of four balls of 92 surface vertices, μ = 0.4",
          .problem = ball_pyramid_problem(setup),
          .settings = {{"ball", fmt::format("{}", setup.frequency)}},
          .settled = 1.8,
          .steps = 1000,
          .size = setup.radius};
}

ComparisonScene membrane() {
  MembraneSetup setup;
  setup.cells_along = 24;
  setup.cells_across = 2;
  Problem problem = membrane_problem(setup);
  // It stays at the first slope, and in a medium until it swings no more.
  Gravity& gravity = problem.gravity;
  while (gravity.time.back() > kMembraneLoaded) {
    gravity.time.pop_back();
    gravity.acceleration.pop_back();
  }
  problem.drag = {.rate = 20.0, .full_until = 4.0, .ends = 4.4};
  return {.name = "membrane",
          .title = "a box on a taut membrane, tan θ = 0.5, μ = 0.6",
          .problem = problem,
          .settings = {},
          .settled = 4.5,
          .steps = 2000,
          .size = setup.box_size.x()};
}

ComparisonScene basket() {
  const BasketSetup setup{.columns = 2, .layers = 2};
  return {.name = "basket",
          .title = "eight non-convex objects in a basket",
          .problem = basket_problem(setup),
          .settings = {},
          .settled = 5.0,
          .steps = 2000,
          .size = setup.edge};
}

}  // namespace

SlabSetup comparison_slab() {
  SlabSetup setup = slab_at_20_degrees();
  setup.cells = 3;
  setup.elasticity.damping_time = 1e-3;
  return setup;
}

ComparisonScene loaded_slab(double share, int cells) {
  SlabSetup setup = comparison_slab();
  setup.slope = std::atan(share * setup.friction);
  setup.cells = cells;
  return {.name = fmt::format("load={}", share),
          .title = fmt::format("a box of {} cells an edge that loads a slab by {} of the cone",
                               cells, share),
          .problem = slab_problem(setup),
          .settings = {{"cells", fmt::format("{}", setup.cells)}, {"dt", "1e-4"}},
          .settled = 2.0,
          .steps = 3000,
          .size = setup.box_size.x()};
}

ComparisonScene comparison_plate() {
  SlabSetup setup = comparison_slab();
  setup.box_size = Vec3(0.1, 0.1, 0.01);
  setup.cells = 12;
  setup.elasticity.damping_time = 2e-4;
  return {.name = "plate",
          .title = "a plate of 169 contacts on a slab",
          .problem = slab_problem(setup),
          .settings = {{"cells", fmt::format("{}", setup.cells)}, {"dt", "1e-4"}},
          .settled = 0.8,
          .size = setup.box_size.x()};
}

std::vector<ComparisonScene> comparison_scenes() {
  return {slab(), both_sides(), clamp(), pyramid(), balls(), membrane(), basket()};
}

Settings contacts_of(const Settings& settings) {
  Settings contacts{{"method", settings.at("method")}};
  const auto depth = settings.find("depth");
  if (depth != settings.end()) contacts["depth"] = depth->second;
  return contacts;
}

Settled settled_without_memory(const EngineKind& kind, const ComparisonScene& scene,
                               const Settings& contacts) {
  if (scene.settled == 0.0) return {};
  struct Entry {
    std::once_flag once;
    Settled settled;
  };
  static std::mutex mutex;
  static std::map<std::string, Entry> entries;
  Entry* entry = nullptr;
  {
    const std::lock_guard lock(mutex);
    std::string key = fmt::format("{}\n{}\n{}", kind.name, scene.name, scene.released);
    for (const Settings* settings : {&contacts, &scene.settings}) {
      for (const auto& [name, value] : *settings) key += '\n' + name + '=' + value;
    }
    entry = &entries[key];
  }
  std::call_once(entry->once, [&] {
    const auto engine_with = [&](const char* rule, double friction) {
      Settings settings = scene.settings;
      settings.insert(contacts.begin(), contacts.end());
      settings["rule"] = rule;
      Problem problem = scene.problem;
      problem.friction *= friction;
      std::unique_ptr<Engine> engine = kind.make(settings);
      engine->load(problem, {});
      return engine;
    };
    const auto settling = engine_with("stored-vector", 1.0);
    settling->advance(
        static_cast<std::uint64_t>(std::llround(scene.settled / settling->time_step())));
    const auto forgetting = engine_with("none", scene.released > 0.0 ? 0.0 : 1.0);
    forgetting->restore(settling->save());
    do {
      forgetting->advance(1);
      if (forgetting->steps_done() > settling->steps_done() + kLongestRelease) {
        throw InputError(fmt::format("{} does not slip at {} m/s within {} steps", scene.name,
                                     scene.released, kLongestRelease));
      }
    } while (slips_of(forgetting->contacts()).mean < scene.released);
    entry->settled = {forgetting->save(), slips_of(forgetting->contacts())};
  });
  return entry->settled;
}

}  // namespace stiction
