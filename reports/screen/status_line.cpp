// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/screen/status_line.h"

#include <unistd.h>

#include <cstdio>

#include "reports/screen/screen.h"
#include "reports/text/text.h"

namespace stiction {

StatusLine::StatusLine() : moving_(screen_of(STDERR_FILENO).moving) {}

std::size_t StatusLine::width() { return screen_of(STDERR_FILENO).width - 1; }

void StatusLine::show(const std::string& text) {
  if (moving_) draw(shortened(one_line(text), width()));
}

void StatusLine::clear() {
  if (shown_ > 0) draw("");
}

// A terminal that has gone is no reason to stop.
void StatusLine::draw(const std::string& line) {
  const std::size_t width = display_width(line);
  std::string all = "\r" + padded_right(line, shown_);
  if (width == 0) all += '\r';
  std::fwrite(all.data(), 1, all.size(), stderr);
  std::fflush(stderr);
  shown_ = width;
}

}  // namespace stiction
