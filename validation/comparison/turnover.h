// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "validation/engine/engine.h"

namespace stiction {

/// What becomes of the contacts that carry a load, from step to step.
class Turnover {
 public:
  void add(const std::vector<ContactSample>& contacts);  ///< those after one more step

  std::uint64_t facet_changes() const { return facet_changes_; }  ///< of those loaded twice running
  std::uint64_t losses() const { return losses_; }  ///< times that one carried no load any more
  double mean_loaded() const;  ///< contacts with a load, a step; 0 before the first

 private:
  using Touch = std::array<std::int64_t, 4>;  // touched, its kind, point, facet
  std::vector<Touch> last_;                   // sorted
  std::uint64_t facet_changes_ = 0, losses_ = 0, loaded_ = 0, steps_ = 0;
};

}  // namespace stiction
