// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/screen/progress_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/text/number.h"
#include "reports/text/text.h"

namespace stiction {

namespace {

// Before so much is done, nothing is known of the rest.
constexpr double kSoonest = 2.0;  // s
constexpr std::size_t kFewest = 3;

}  // namespace

std::string progress_text(std::size_t done, std::size_t total, const std::string& running,
                          double seconds_left, std::size_t width) {
  const std::string counts = fmt::format("[{}/{}] ", done, total);
  const std::string what = one_line(running);
  const std::string left =
      seconds_left > 0.0 ? fmt::format(" · {} left", duration_text(seconds_left)) : "";
  if (display_width(counts + what + left) <= width) return counts + what + left;
  const std::size_t room = width > display_width(counts) ? width - display_width(counts) : 0;
  return counts + shortened(what, room);
}

void ProgressLine::show(std::size_t done, const std::string& running, std::optional<double> share) {
  if (!line_.is_seen()) return;
  const double passed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  const double part =
      share.value_or(static_cast<double>(std::min(done, total_)) / static_cast<double>(total_));
  const bool known = done >= kFewest && passed >= kSoonest && part > 0.0;
  const double left = known ? passed * (1.0 - part) / part : 0.0;
  line_.show(progress_text(done, total_, running, left, StatusLine::width()));
}

}  // namespace stiction
