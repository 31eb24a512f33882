// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace stiction {

/// The last line of a terminal's standard error, written over as the work goes on; on a pipe, in a
/// file and on a dumb terminal nothing. It takes no escape sequence: spaces wipe out what stood there.
class StatusLine {
 public:
  StatusLine();
  ~StatusLine() { clear(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  bool is_seen() const { return moving_; }
  /// Columns of a line, one fewer than there are, so that no terminal breaks it.
  static std::size_t width();
  /// One line, cut to that width.
  void show(const std::string& text);
  void clear();  ///< before anything else is written

 private:
  void draw(const std::string& line);

  bool moving_;
  std::size_t shown_ = 0;  // columns that it takes now
};

}  // namespace stiction
