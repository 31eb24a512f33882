// SPDX-License-Identifier: GPL-3.0-or-later
// A person's problem: what can be simulated, or one sentence; and then the same of the scene that the
// solver makes of it, of a few of its steps, and of the protocol, by which the kit reads the problem.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "fuzz/property.h"
#include "solver/demand.h"
#include "solver/step.h"
#include "validation/engine/kit/problem_reader.h"
#include "validation/engine/protocol/problem_json.h"
#include "validation/engines/stiction/stiction_scene.h"
#include "validation/user/user_problem.h"

using namespace stiction;

namespace {

// No mesher: it would be a process an input.
const bool kNoMesher = setenv("STICTION_MESHER", "/nowhere/mesh_surface", 1) == 0;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(data, data + size);
  if (!kNoMesher || text.find("surface") != std::string::npos) return -1;
  std::istringstream stream(text);
  const auto user =
      fuzz::value_or_sentence<InputError>([&] { return user_problem(stream, "a.toml"); });
  if (!user) return 0;
  const auto told =
      fuzz::value_or_sentence<InputError>([&] { return problem_json(user->problem); });
  if (told) {
    // Without sentence, as the suite must not write what the kit can't read.
    const auto owned = kit::read_problem({{"problem", *told}});
    fuzz::hold(owned->problem().body_count == user->problem.bodies.size() &&
                   owned->problem().duration == user->problem.duration,
               "the kit reads the problem that was written");
  }
  if (user->problem.bodies.size() > 4) return 0;
  const auto scene = fuzz::value_or_sentence<InputError>(
      [&] { return build_scene(scene_description(user->problem, {.cells = 2, .ball = 2})); });
  if (!scene) return 0;
  Options options;
  options.time_step = std::min(1e-3, 0.5 * scene->stable_time_step);
  const auto usable = fuzz::value_or_sentence<InputError>([&] {
    check_options(options, *scene);
    return true;
  });
  if (!usable) return 0;
  State state = initial_state(*scene);
  Workspace workspace;
  for (int k = 0; k < 3; ++k) step(*scene, options, state, workspace);
  return 0;
}
