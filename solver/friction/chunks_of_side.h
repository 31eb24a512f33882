// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>

#include "solver/contact/contact_order.h"
#include "solver/lanes/lane_width.h"
#include "solver/lanes/packed_vec3.h"

namespace stiction::friction_phase {

// Calls work(k, chunk), a lambda that is always inlined, for the chunks of a side's order (see
// sides.h), compiled for the registers that the side's vectors go through.
template <class Side, class Work>
void for_each_chunk(const Side& side, const Team* team, const Work& work) {
  if (side.size() == 0) return;
  const int width = std::is_same_v<typename Side::Vector, PackedVec3> ? lane_width() : 0;
  side.order.for_each_chunk(team, [&](std::size_t k, const ContactOrder::Chunk& chunk) {
    in_registers(
        width, [&]() __attribute__((always_inline)) { work(k, chunk); });
  });
}

}  // namespace stiction::friction_phase
