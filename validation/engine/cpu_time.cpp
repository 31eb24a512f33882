// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/cpu_time.h"

#include <ctime>

namespace stiction {

double thread_cpu_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace stiction
