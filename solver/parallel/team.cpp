// SPDX-License-Identifier: BSD-3-Clause
#include "solver/parallel/team.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <system_error>

#include "solver/demand.h"

#if STICTION_HAS_TBB
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <cfenv>
#include <chrono>
#include <ctime>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#endif

namespace stiction {

#if STICTION_HAS_TBB

namespace {

void pause() {
#ifdef __SSE2__
  __builtin_ia32_pause();
#endif
}

using Clock = std::chrono::steady_clock;

// A thread that has helped looks out for more for so long before it sleeps. To wake it took some 30 µs
// on a virtual machine, as long as a phase of a thousand contacts: with 0.2 ms or none such a step took
// longer with two threads than with one, with 3 ms it does not. With 10⁵ contacts it makes no difference.
constexpr auto kPatience = std::chrono::milliseconds(3);
constexpr int kLooks = 64;  // at what is to do, between two at the clock

double cpu_seconds_of_this_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Work that lies open, for its caller and those who help. A helper enters before he looks whether it
// is open, and the caller closes it before he looks whether somebody is inside: so nobody reads what
// is being written for the next work. The caller waits for pieces that others have begun, never for
// who has not come yet.
class OpenWork {
 public:
  using Call = void (*)(const void* work, std::size_t k);

  // By the caller, who has whatever the helpers leave; throws what a piece threw.
  void share(std::size_t count, Call call, const void* work) {
    if (in_piece_) {  // of work that shares in turn: that part is this thread's own
      for (std::size_t k = 0; k < count; ++k) call(work, k);
      return;
    }
    count_ = count;
    call_ = call;
    work_ = work;
    std::fegetenv(&environment_);
    next_ = 0;
    open_ = true;
    pieces();
    open_ = false;
    for (int looks = 1; inside_ > 0; ++looks) wait(looks);
    if (const int raised = raised_.exchange(0)) std::feraiseexcept(raised);
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

  // By the caller: whether one more is to be called, as there are fewer helpers than `most`.
  bool calls_helper(int most) {
    if (helpers_ >= most) return false;
    ++helpers_;
    return true;
  }

  // By a helper who was called, until nothing has come for a while, or will.
  void help() {
    auto until = Clock::now() + kPatience;
    for (int looks = 1; !ended_; ++looks) {
      if (open_ && help_once()) {
        until = Clock::now() + kPatience;
      } else if (looks % kLooks == 0 && Clock::now() > until) {
        break;
      } else {
        wait(looks);
      }
    }
    --helpers_;
  }

  void end() { ended_ = true; }
  double helpers_cpu_seconds() const { return helpers_cpu_seconds_; }

 private:
  static void wait(int looks) {
    if (looks % kLooks == 0) {
      std::this_thread::yield();  // to who else may want this core
    } else {
      pause();
    }
  }

  bool pieces() {
    std::size_t done = 0;
    in_piece_ = true;
    try {
      for (std::size_t k = next_++; k < count_; k = next_++, ++done) call_(work_, k);
    } catch (...) {
      const std::lock_guard lock(throwing_);
      if (!thrown_) thrown_ = std::current_exception();
      next_ = count_;
    }
    in_piece_ = false;
    return done > 0;
  }

  bool help_once() {
    ++inside_;
    bool helped = false;
    if (open_ && next_ < count_) {
      const double before = cpu_seconds_of_this_thread();
      std::fenv_t own;
      std::fegetenv(&own);
      std::fesetenv(&environment_);
      std::feclearexcept(FE_ALL_EXCEPT);
      helped = pieces();
      raised_ |= std::fetestexcept(FE_ALL_EXCEPT);
      std::fesetenv(&own);
      helpers_cpu_seconds_ += cpu_seconds_of_this_thread() - before;
    }
    --inside_;
    return helped;
  }

  static inline thread_local bool in_piece_ = false;

  // Of the work that lies open, written while nobody is inside.
  std::size_t count_ = 0;
  Call call_ = nullptr;
  const void* work_ = nullptr;
  std::fenv_t environment_{};

  alignas(64) std::atomic<bool> open_ = false;
  std::atomic<bool> ended_ = false;
  std::atomic<int> helpers_ = 0;  // called and not gone yet
  alignas(64) std::atomic<std::size_t> next_ = 0;
  alignas(64) std::atomic<int> inside_ = 0;
  std::atomic<int> raised_ = 0;  // by helpers, who have flags of their own
  std::atomic<double> helpers_cpu_seconds_ = 0.0;
  std::mutex throwing_;
  std::exception_ptr thrown_;
};

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
  std::shared_ptr<OpenWork> work = std::make_shared<OpenWork>();  // of helpers too, while they help
  std::uint64_t number = OpenWorks::all().add(work);
};

int most_threads() { return 256; }

void Team::share(std::size_t count, Call call, const void* work) const {
  while (arena_->work->calls_helper(arena_->threads - 1)) {
    arena_->arena.enqueue([number = arena_->number] {
      if (const auto open = OpenWorks::all().find(number)) open->help();
    });
  }
  arena_->work->share(count, call, work);
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
