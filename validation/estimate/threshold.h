// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace stiction {

/// A critical value lies between the largest value seen to hold and the smallest seen to fail.
struct Bracket {
  double holds = 0.0;
  double fails = 0.0;
  int evaluations = 0;

  double width() const;
  double middle() const { return 0.5 * (holds + fails); }
  bool contains(double value) const;
};

/// Bisects until the bracket is no wider than `width`, or no number lies between its ends.
/// `holds_at(first)` must be true and `holds_at(last)` false (either may be the larger); both are
/// evaluated, and when the answer is another the bracket returned is the whole interval turned into
/// NaN, so that no check can pass on it.
Bracket find_threshold(double first, double last, double width,
                       const std::function<bool(double)>& holds_at);

/// The same where theory says about where the critical value lies. `step` leads from what holds
/// towards what fails. From `guess` it goes outwards, at first by one step, then four times as far
/// each time, until the answer changes, and bisects what lies between: a guess that is a few widths
/// off costs a few runs, one that is far off a few more, and no answer is taken from theory. When
/// nothing has changed `reach` away from the guess it gives up: NaN as above.
Bracket find_threshold_near(double guess, double step, double reach, double width,
                            const std::function<bool(double)>& holds_at);

/// Goes on bisecting a bracket that was found, with its count of runs; one of NaN stays as it is.
Bracket narrow(Bracket bracket, double width, const std::function<bool(double)>& holds_at);

}  // namespace stiction
