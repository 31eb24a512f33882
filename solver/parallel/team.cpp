// SPDX-License-Identifier: BSD-3-Clause
#include "solver/parallel/team.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <string>
#include <system_error>

#include "solver/demand.h"

#if STICTION_HAS_TBB
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <cfenv>
#include <ctime>
#include <thread>
#endif

namespace stiction {

#if STICTION_HAS_TBB

namespace {

double cpu_seconds_of_this_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

struct Team::Arena {
  // More than the machine has would gain nothing, and oneTBB would say so on standard error.
  explicit Arena(int threads) : arena(std::min(threads, tbb::info::default_concurrency())) {}
  tbb::task_arena arena;
  std::atomic<double> helpers_cpu_seconds = 0.0;
};

int most_threads() { return 256; }

void Team::share(std::size_t count, Call call, const void* work) const {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<int> raised = 0;  // by others, who have flags of their own
  // Made here, it has the caller's rounding mode.
  tbb::task_group_context context(
      tbb::task_group_context::isolated,
      tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  arena_->arena.execute([&] {
    const auto some = [&](const tbb::blocked_range<std::size_t>& range) {
      const auto all = [&] {
        for (std::size_t k = range.begin(); k != range.end(); ++k) call(work, k);
      };
      if (std::this_thread::get_id() == caller) {
        all();
        return;
      }
      const double before = cpu_seconds_of_this_thread();
      std::feclearexcept(FE_ALL_EXCEPT);
      all();
      raised |= std::fetestexcept(FE_ALL_EXCEPT);
      arena_->helpers_cpu_seconds += cpu_seconds_of_this_thread() - before;
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), some, context);
  });
  if (raised != 0) std::feraiseexcept(raised);
}

double Team::helpers_cpu_seconds() const { return arena_ ? arena_->helpers_cpu_seconds.load() : 0; }

#else

struct Team::Arena {
  explicit Arena(int) {}
};

int most_threads() { return 1; }

void Team::share(std::size_t count, Call call, const void* work) const {
  for (std::size_t k = 0; k < count; ++k) call(work, k);
}

double Team::helpers_cpu_seconds() const { return 0.0; }

#endif

namespace {

std::string allowed_threads() {
  if (most_threads() == 1) return "a step has 1 thread, for this solver was built without oneTBB";
  return "a step has 1 to " + std::to_string(most_threads()) + " threads";
}

}  // namespace

Team::Team(int threads) : size_(threads) {
  if (threads < 1 || threads > most_threads()) {
    throw InputError(allowed_threads() + ", not " + std::to_string(threads));
  }
  if (threads > 1) arena_ = std::make_unique<Arena>(threads);
}

Team::~Team() = default;

void Team::run(const Team* team, std::size_t count, Call call, const void* work) {
  if (team != nullptr && team->size() > 1 && count > 1) {
    team->share(count, call, work);
  } else {
    for (std::size_t k = 0; k < count; ++k) call(work, k);
  }
}

int chosen_step_threads(const std::string& wanted) {
  if (wanted.empty()) return 1;
  int threads = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto [at, error] = std::from_chars(wanted.data(), end, threads);
  if (error == std::errc() && at == end && threads >= 1 && threads <= most_threads()) {
    return threads;
  }
  throw InputError("STICTION_THREADS is '" + wanted + "', but " + allowed_threads());
}

int step_threads() {
  const char* const wanted = std::getenv("STICTION_THREADS");
  return chosen_step_threads(wanted == nullptr ? "" : wanted);
}

}  // namespace stiction
