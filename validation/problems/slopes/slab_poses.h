// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "validation/problems/slopes/slab_problem.h"

namespace stiction {

/// How a box lies on the slab of slab_problem.h.
enum class SlabPose {
  kAnywhere,  ///< any yaw, about the middle
  kFlush,     ///< a side face in one plane with a side of the slab
  kCorner,  ///< a lower corner on a corner of the slab, two side faces in one plane with its sides
  kCovering,  ///< as wide as the slab: all four lower edges on its edges
  kHanging    ///< 40 % of it over an edge of the slab
};
inline constexpr int kPoses = 5;

struct PosedSlab {
  SlabPose pose = SlabPose::kAnywhere;
  SlabSetup setup;
};

/// `count` seeded poses, the kinds in turn: slope up to 26° (atan μ = 26.6°), but at most 80 % of
/// what limit analysis allows the rigid box; any azimuth; 2 or 3 cells on 3 or 4.
std::vector<PosedSlab> posed_slabs(int count, std::uint32_t seed);

/// "hanging, slope 12.0°, …".
std::string pose_words(const PosedSlab& posed);

/// Critical tan θ of the rigid box in the direction of the setup's azimuth: the lower bound of the
/// limit analysis. Only for boxes without yaw. −∞ where it does not even rest on level ground.
double critical_tan(const SlabSetup& setup);

}  // namespace stiction
