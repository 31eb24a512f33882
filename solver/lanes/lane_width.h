// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace stiction {

/// Widths of registers, in doubles, that this processor has, narrowest first: 2, with AVX2 4, with
/// AVX-512 8.
std::vector<int> lane_widths();

/// The width that kernels take: the widest, or what the environment's STICTION_WIDTH says. Results
/// are the same to the bit at each. Throws InputError unless it is one of `lane_widths`.
int lane_width();

/// What `lane_width` is where the environment says `wanted`.
int chosen_lane_width(const std::string& wanted);

}  // namespace stiction

/// Compiles a function for a wider register than each processor has.
#if defined(__x86_64__)
#define STICTION_TARGET_4 [[gnu::target("avx2")]]
#define STICTION_TARGET_8 [[gnu::target("avx2,avx512f,avx512dq,avx512vl")]]
#else
#define STICTION_TARGET_4
#define STICTION_TARGET_8
#endif
