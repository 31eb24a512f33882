// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace stiction {

/// Kinetic energy of a scene at rest, the second half of a window against the first: what rests may
/// lose energy or keep it, never gain it.
class EnergyWatch {
 public:
  /// Samples that a case takes of each half, evenly spread.
  static constexpr int kSamples = 1000;

  /// The speed below which everything counts as at rest, m/s: the slip that the cases of rest
  /// allow. Round-off keeps a scene moving at less.
  static constexpr double kRestSpeed = 1e-12;

  /// `begin` and `end` of the window, s; `mass` of all that moves, kg; `rest_speed`, m/s, where
  /// coordinates that round keep a scene moving faster than kRestSpeed.
  EnergyWatch(double begin, double end, double mass, double rest_speed = kRestSpeed);

  /// Kinetic energy (J) at a time (s); samples outside the window are left out.
  void add(double time, double kinetic);

  double first_half() const;   ///< mean, J
  double second_half() const;  ///< mean, J

  /// (mean of the second half − mean of the first) / mean of the first; 0 where the second is below
  /// the energy of `kRestSpeed`. Infinite where a sample is no number or a half has none.
  double growth() const;

  /// By how much two means of n = kSamples samples of an undamped vibration differ: sin² has the
  /// mean ½ and the standard deviation 1/√8, so the halves' ratio scatters by 1/√n; three times
  /// that.
  static double allowance();

 private:
  double begin_, middle_, end_, floor_;
  double sum_[2] = {0.0, 0.0};
  std::size_t count_[2] = {0, 0};
};

}  // namespace stiction
