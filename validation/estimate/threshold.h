// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>

namespace stiction {

/// What a run at one value tells.
struct Holding {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  bool holds = false;
  /// How far beyond the critical value it is, in any unit: about 0 there and, where it fails, nearly in
  /// proportion to the distance from it, as the acceleration of what slides is. Where it holds, below 0,
  /// in proportion or not. A search only takes from it where to look next.
  double excess = kUnknown;

  Holding(bool does_hold, double how_far_beyond = kUnknown)  // NOLINT(google-explicit-constructor)
      : holds(does_hold), excess(how_far_beyond) {}
};
using HoldingAt = std::function<Holding(double)>;

/// A critical value lies between the largest value seen to hold and the smallest seen to fail.
struct Bracket {
  /// A value, and the excess there.
  struct Tried {
    double at = Holding::kUnknown, excess = Holding::kUnknown;
  };

  double holds = 0.0;
  double fails = 0.0;
  int evaluations = 0;
  Tried held{}, nearest{}, next{};   ///< the last that held; of those that fail, the nearest two
  double slope = Holding::kUnknown;  ///< excess for each unit beyond the critical value, by theory

  double width() const;
  double middle() const { return 0.5 * (holds + fails); }
  bool contains(double value) const;
};

/// Narrows the bracket until it is no wider than `width`, or no number lies between its ends. Bisects;
/// where the excess tells about where the critical value lies, looks first just before and just behind
/// that. A promise that was wrong costs its run and nothing else, and the more of them there were, the
/// longer it only bisects.
/// `holds_at(first)` must hold and `holds_at(last)` fail (either may be the larger); both are
/// evaluated, and when the answer is another the bracket returned is the whole interval turned into
/// NaN, so that no check can pass on it.
Bracket find_threshold(double first, double last, double width, const HoldingAt& holds_at);

/// The same where theory says about where the critical value lies. `step` leads from what holds
/// towards what fails. From `guess` it goes outwards, at first by one step, then four times as far
/// each time, or from what fails to where its excess leads, until the answer changes, and narrows what
/// lies between: a guess that is a few widths off costs a few runs, one that is far off a few more, and
/// no answer is taken from theory, nor from `slope`, the excess for each unit beyond the critical
/// value, if it is known. When nothing has changed `reach` away from the guess it gives up: NaN as
/// above.
Bracket find_threshold_near(double guess, double step, double reach, double width,
                            const HoldingAt& holds_at, double slope = Holding::kUnknown);

/// Goes on narrowing a bracket that was found, with its count of runs; one of NaN stays as it is.
Bracket narrow(Bracket bracket, double width, const HoldingAt& holds_at);

}  // namespace stiction
