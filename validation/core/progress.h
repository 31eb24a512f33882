// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace stiction {

/// Time that is left, from the work that is done: `seconds` have gone by while pieces of work of
/// `done` of `total` were finished. Negative while nothing can be said.
double seconds_left(double seconds, double done, double total);

/// A line at the bottom of a terminal while jobs run: how many are done, one that is running, the
/// time left. Nothing where stderr is no terminal, or a dumb one.
class Progress {
 public:
  /// `names` of the jobs, and what each is expected to cost, in any unit, > 0.
  Progress(std::vector<std::string> names, std::vector<double> weights);
  ~Progress() { hide(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void finished(std::size_t index);
  void show();  ///< draws the line
  void hide();  ///< before anything else is printed

 private:
  std::string line() const;

  std::vector<std::string> names_;
  std::vector<double> weights_;
  std::vector<bool> done_;
  double total_ = 0.0;
  double work_done_ = 0.0;
  std::size_t count_done_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool wanted_;
  bool shown_ = false;
};

/// Whether stderr is a terminal that can draw a line anew.
bool can_redraw_stderr();

}  // namespace stiction
