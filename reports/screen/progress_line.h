// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace stiction {

/// "[12/183] rules/slab, secant · 1 min 20 s left", of at most `width` columns: the time goes first,
/// then the middle of what runs.
std::string progress_text(std::size_t done, std::size_t total, const std::string& running,
                          double seconds_left, std::size_t width);

/// The last line of a terminal's standard error, written over as the work goes on; on a pipe, in a
/// file and on a dumb terminal nothing. It takes no escape sequence: spaces wipe out what stood there.
class ProgressLine {
 public:
  explicit ProgressLine(std::size_t total);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `share`: how much of the work is done, from 0 to 1, where jobs are not alike.
  void show(std::size_t done, const std::string& running, std::optional<double> share = {});
  void clear();  ///< before anything else is written

 private:
  void draw(const std::string& line);

  std::size_t total_;
  bool moving_;
  std::size_t shown_ = 0;  // columns that it takes now
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace stiction
