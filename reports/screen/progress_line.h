// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "reports/screen/status_line.h"

namespace stiction {

/// "[12/183] rules/slab, secant · 1 min 20 s left", of at most `width` columns: the time goes first,
/// then the middle of what runs.
std::string progress_text(std::size_t done, std::size_t total, const std::string& running,
                          double seconds_left, std::size_t width);

/// A status line with what is done of so many jobs, what runs and the time that is left.
class ProgressLine {
 public:
  explicit ProgressLine(std::size_t total) : total_(total) {}

  /// `share`: how much of the work is done, from 0 to 1, where jobs are not alike.
  void show(std::size_t done, const std::string& running, std::optional<double> share = {});
  void clear() { line_.clear(); }  ///< before anything else is written

 private:
  std::size_t total_;
  StatusLine line_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace stiction
