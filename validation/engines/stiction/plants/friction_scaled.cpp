// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: μ is 2 % too large.
#include "solver/scene/scene.h"

namespace stiction {

Scene unplanted_build_scene(const SceneDescription& description);

Scene build_scene(const SceneDescription& description) {
  Scene scene = unplanted_build_scene(description);
  scene.friction *= 1.02;
  for (HalfSpace& obstacle : scene.half_spaces) obstacle.friction *= 1.02;
  return scene;
}

}  // namespace stiction
