// SPDX-License-Identifier: BSD-3-Clause
#include "solver/parallel/team.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <system_error>

#include "solver/demand.h"

#if STICTION_HAS_TBB
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <map>
#include <mutex>
#include <utility>

#include "solver/parallel/open_work.h"
#endif

namespace stiction {

#if STICTION_HAS_TBB

namespace {

// The work of the teams there are, by number. A helper who was called knows the number alone: oneTBB may let
// him begin after his team has gone, or never, where the program ends before.
class OpenWorks {
 public:
  static OpenWorks& all() {
    // For ever: for who comes while the program ends, too.
    static auto* const works = new OpenWorks;
    return *works;
  }
  std::uint64_t add(const std::shared_ptr<OpenWork>& work) {
    const std::lock_guard lock(changing_);
    work_[++last_] = work;
    return last_;
  }
  void remove(std::uint64_t number) {
    const std::lock_guard lock(changing_);
    work_.erase(number);
  }
  std::shared_ptr<OpenWork> find(std::uint64_t number) {
    const std::lock_guard lock(changing_);
    const auto found = work_.find(number);
    return found == work_.end() ? nullptr : found->second;
  }

 private:
  std::mutex changing_;
  std::map<std::uint64_t, std::shared_ptr<OpenWork>> work_;
  std::uint64_t last_ = 0;
};

}  // namespace

struct Team::Arena {
  // More than the machine has would gain nothing, and oneTBB would say so on standard error.
  explicit Arena(int wanted) : threads(std::min(wanted, tbb::info::default_concurrency())) {}
  ~Arena() {
    work->end();
    OpenWorks::all().remove(number);
  }

  int threads;
  tbb::task_arena arena{threads};
  std::shared_ptr<OpenWork> work =
      std::make_shared<OpenWork>(threads);  // of helpers too, while they help
  std::uint64_t number = OpenWorks::all().add(work);
};

int most_threads() { return 256; }

void Team::share(std::size_t count, Call call, const void* work) const {
  arena_->work->share(count, call, work, [&](std::size_t member) {
    arena_->arena.enqueue([number = arena_->number, member] {
      if (const auto open = OpenWorks::all().find(number)) open->help(member);
    });
  });
}

double Team::helpers_cpu_seconds() const {
  return arena_ ? arena_->work->helpers_cpu_seconds() : 0;
}

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
