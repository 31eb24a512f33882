// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace stiction {

/// How the programs of this project end.
enum ExitCode {
  kHolds = 0,        ///< what was asked holds: every check, every document, nothing got worse
  kDoesNotHold = 1,  ///< something doesn't
  kCouldNotRun = 2,  ///< bad input, or a fault of the system: nothing is known
  kBetter = 3        ///< track: it holds, and something got better (with --report-improvement)
};

}  // namespace stiction
