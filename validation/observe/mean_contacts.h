// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "validation/engine/engine.h"

namespace stiction {

/// Contacts averaged over looks at different times. What swings about its place of rest is out of
/// balance at any moment, by its mass times its acceleration, but only by Δv/T on the average over
/// a time T: mean forces at mean places are those of the equilibrium.
class MeanContacts {
 public:
  void add(const std::vector<ContactSample>& contacts);

  /// One for each that carried a load at some look: mean normal force (none where it was absent),
  /// place and unit normal weighted by force. The rest of the sample is of no meaning.
  std::vector<ContactSample> mean() const;

 private:
  // Body, what it touches, whether that is a body, point.
  using Key = std::tuple<std::size_t, std::size_t, bool, std::int64_t>;
  struct Sum {
    double force = 0.0;          // N
    Vec3 moment = Vec3::Zero();  // force times place, N m
    Vec3 normal = Vec3::Zero();  // N
  };
  std::map<Key, Sum> sums_;
  std::size_t looks_ = 0;
};

}  // namespace stiction
