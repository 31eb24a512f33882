// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/kit/stiction_engine.h"

namespace stiction {

/// The functions of the table that every adapter with a class of its own fills alike. World(problem)
/// loads; time_step(), time(), advance(steps) and body(index, state) are as in stiction_engine.h.
template <class World>
stiction_engine world_functions() {
  stiction_engine engine{};
  engine.load = [](const stiction_problem* problem) -> void* { return new World(*problem); };
  engine.time_step = [](void* self) { return static_cast<World*>(self)->time_step(); };
  engine.advance = [](void* self, uint64_t steps) { static_cast<World*>(self)->advance(steps); };
  engine.time = [](void* self) { return static_cast<World*>(self)->time(); };
  engine.body = [](void* self, size_t index, stiction_body_state* state) {
    static_cast<World*>(self)->body(index, *state);
  };
  engine.end = [](void* self) { delete static_cast<World*>(self); };
  return engine;
}

}  // namespace stiction
