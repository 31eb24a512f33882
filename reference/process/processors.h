// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace stiction::reference {

/// The processors, by the system's numbers, that the calling thread may run on, increasing; none where
/// the system doesn't tell.
std::vector<int> own_processors();

/// Keeps the calling thread, and what it starts from now on, on some processors. Without any, or where the
/// system doesn't let it, nothing changes.
void stay_on(const std::vector<int>& processors);

/// The one of `own_processors` that does most now, found by some milliseconds of arithmetic on each; −1
/// where there is none. They differ: on a machine shared with others, one whose core has a neighbour at
/// work did 0.55 of what the other did.
int fastest_processor();

/// How long a thread on one processor waits for an answer of another thread on another one, through lines of the
/// cache that one writes and the other reads, s, now: the least of several rounds; 0 where there is one alone.
/// It says how near each other they are: of two of a machine shared with others it was 55 ns in one minute and
/// 480 in the next.
double answer_seconds();

/// What the processors of a machine are to threads that share a work, now.
struct Together {
  double answer_seconds = 0.0;  ///< as above
  /// The arithmetic that as many processors as there are threads, the fastest, do at once, over that of the
  /// fastest alone. 1 where there is one alone, 2 of two that take nothing from each other, less of halves of one
  /// core, or where one has a neighbour at work; dimensionless. What waits for memory may gain more, as each has
  /// caches of its own.
  double arithmetic = 1.0;
};
Together measure_together(int threads);

/// While it lives, the thread that made it, and what that starts, stay on the processor that was the
/// fastest then: what is timed in turn is timed on the same one.
class OnFastestProcessor {
 public:
  OnFastestProcessor();
  ~OnFastestProcessor();
  OnFastestProcessor(const OnFastestProcessor&) = delete;
  OnFastestProcessor& operator=(const OnFastestProcessor&) = delete;

 private:
  std::vector<int> before_;
};

}  // namespace stiction::reference
