// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string_view>
#include <utility>

#include "reports/text/text.h"
#include "solver/demand.h"

namespace stiction {

namespace {

constexpr double kSoonest = 2.0;  // s: before that nothing is said of the time left

std::size_t stderr_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

// Never more exact than it can be.
std::string rough(double seconds) {
  if (seconds < 10.0) return "a few s";
  if (seconds < 55.0) return fmt::format("{:.0f} s", 10.0 * std::ceil(seconds / 10.0));
  if (seconds < 5400.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

double seconds_left(double seconds, double done, double total) {
  if (seconds < kSoonest || !(done > 0.0)) return -1.0;
  return std::max(0.0, seconds * (total - done) / done);
}

bool can_redraw_stderr() {
  const char* const terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) && terminal && std::string_view(terminal) != "dumb";
}

Progress::Progress(std::vector<std::string> names, std::vector<double> weights)
    : names_(std::move(names)),
      weights_(std::move(weights)),
      done_(names_.size(), false),
      total_(std::accumulate(weights_.begin(), weights_.end(), 0.0)),
      wanted_(can_redraw_stderr()) {
  demand(names_.size() == weights_.size(), "each job has a weight");
}

void Progress::finished(std::size_t index) {
  done_[index] = true;
  work_done_ += weights_[index];
  ++count_done_;
}

std::string Progress::line() const {
  const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start_;
  const double left = seconds_left(gone.count(), work_done_, total_);
  const auto running = std::find(done_.begin(), done_.end(), false) - done_.begin();
  const std::string end = left >= 0.0 ? fmt::format("  {} left", rough(left)) : "";
  const std::string start = fmt::format("[{}/{}] ", count_done_, names_.size());
  const std::size_t room = stderr_width() - 1;
  const std::size_t used = display_width(start) + display_width(end);
  return start +
         shortened(one_line(names_[static_cast<std::size_t>(running)]),
                   room > used ? room - used : 1) +
         end;
}

void Progress::show() {
  if (!wanted_ || count_done_ == names_.size()) return;
  fmt::print(stderr, "\r\033[K{}", line());
  std::fflush(stderr);
  shown_ = true;
}

void Progress::hide() {
  if (!shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace stiction
