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
#include <vector>
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

// What is left of a member's own part of some work: he takes pieces from the front, and who has none left
// from the end, where the owner would come last.
class alignas(64) OwnPieces {
 public:
  void set(std::uint32_t begin, std::uint32_t end) { left_ = joined(begin, end); }
  bool any() const {
    const std::uint64_t left = left_;
    return begin_of(left) < end_of(left);
  }
  bool take_first(std::size_t& k) {
    return take([&](std::uint32_t begin, std::uint32_t end) {
      k = begin;
      return joined(begin + 1, end);
    });
  }
  bool take_last(std::size_t& k) {
    return take([&](std::uint32_t begin, std::uint32_t end) {
      k = end - 1;
      return joined(begin, end - 1);
    });
  }

 private:
  static std::uint64_t joined(std::uint32_t begin, std::uint32_t end) {
    return std::uint64_t{end} << 32 | begin;
  }
  static std::uint32_t begin_of(std::uint64_t left) { return static_cast<std::uint32_t>(left); }
  static std::uint32_t end_of(std::uint64_t left) { return static_cast<std::uint32_t>(left >> 32); }

  template <class Rest>
  bool take(const Rest& rest) {
    std::uint64_t left = left_;
    while (begin_of(left) < end_of(left)) {
      if (left_.compare_exchange_weak(left, rest(begin_of(left), end_of(left)))) return true;
    }
    return false;
  }

  std::atomic<std::uint64_t> left_ = 0;
};

// Work that lies open, for its caller and those who help. A helper enters before he looks whether it
// is open, and the caller closes it before he looks whether somebody is inside: so nobody reads what
// is being written for the next work. The caller waits for pieces that others have begun, never for
// who has not come yet.
//
// Each member has a part of his own, of pieces that follow each other: what they read and write stays in his
// processor's cache from one work to the next. Where each piece went to who came first, friction of 10⁴
// contacts, whose vertices went to and fro between the caches, took as long with two threads as with one.
class OpenWork {
 public:
  using Call = void (*)(const void* work, std::size_t k);

  // For so many, the caller among them.
  explicit OpenWork(int members)
      : members_(static_cast<std::size_t>(members)), own_(members_), called_(members_) {}

  // By the caller, who has whatever the helpers leave; throws what a piece threw.
  void share(std::size_t count, Call call, const void* work) {
    if (in_piece_) {  // of work that shares in turn: that part is this thread's own
      for (std::size_t k = 0; k < count; ++k) call(work, k);
      return;
    }
    call_ = call;
    work_ = work;
    std::fegetenv(&environment_);
    for (std::size_t m = 0; m < members_; ++m) {
      own_[m].set(static_cast<std::uint32_t>(count * m / members_),
                  static_cast<std::uint32_t>(count * (m + 1) / members_));
    }
    open_ = true;
    pieces(0);
    open_ = false;
    for (int looks = 1; inside_ > 0; ++looks) wait(looks);
    if (const int raised = raised_.exchange(0)) std::feraiseexcept(raised);
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

  // By the caller: calls each member who isn't there.
  template <class Enqueue>
  void call_helpers(const Enqueue& enqueue) {
    for (std::size_t m = 1; m < members_; ++m) {
      if (!called_[m].exchange(true)) enqueue(m);
    }
  }

  // By the member m, who was called, until nothing has come for a while, or will.
  void help(std::size_t m) {
    auto until = Clock::now() + kPatience;
    for (int looks = 1; !ended_; ++looks) {
      if (open_ && help_once(m)) {
        until = Clock::now() + kPatience;
      } else if (looks % kLooks == 0 && Clock::now() > until) {
        break;
      } else {
        wait(looks);
      }
    }
    called_[m] = false;
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

  bool any_left() const {
    return std::any_of(own_.begin(), own_.end(), [](const OwnPieces& own) { return own.any(); });
  }

  // The next piece for the member m.
  bool take(std::size_t m, std::size_t& k) {
    if (own_[m].take_first(k)) return true;
    for (std::size_t other = 1; other < members_; ++other) {
      if (own_[(m + other) % members_].take_last(k)) return true;
    }
    return false;
  }

  bool pieces(std::size_t m) {
    bool any = false;
    in_piece_ = true;
    try {
      for (std::size_t k = 0; take(m, k); any = true) call_(work_, k);
    } catch (...) {
      const std::lock_guard lock(throwing_);
      if (!thrown_) thrown_ = std::current_exception();
      for (OwnPieces& own : own_) own.set(0, 0);
      any = true;
    }
    in_piece_ = false;
    return any;
  }

  bool help_once(std::size_t m) {
    if (!any_left()) return false;
    ++inside_;
    bool helped = false;
    if (open_) {
      const double before = cpu_seconds_of_this_thread();
      std::fenv_t own;
      std::fegetenv(&own);
      std::fesetenv(&environment_);
      std::feclearexcept(FE_ALL_EXCEPT);
      helped = pieces(m);
      raised_ |= std::fetestexcept(FE_ALL_EXCEPT);
      std::fesetenv(&own);
      helpers_cpu_seconds_ += cpu_seconds_of_this_thread() - before;
    }
    --inside_;
    return helped;
  }

  static inline thread_local bool in_piece_ = false;

  std::size_t members_;

  // Of the work that lies open, written while nobody is inside.
  Call call_ = nullptr;
  const void* work_ = nullptr;
  std::fenv_t environment_{};
  std::vector<OwnPieces> own_;  // of each member

  std::vector<std::atomic<bool>> called_;  // each member, who has not gone yet
  alignas(64) std::atomic<bool> open_ = false;
  std::atomic<bool> ended_ = false;
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
  std::shared_ptr<OpenWork> work =
      std::make_shared<OpenWork>(threads);  // of helpers too, while they help
  std::uint64_t number = OpenWorks::all().add(work);
};

int most_threads() { return 256; }

void Team::share(std::size_t count, Call call, const void* work) const {
  arena_->work->call_helpers([&](std::size_t member) {
    arena_->arena.enqueue([number = arena_->number, member] {
      if (const auto open = OpenWorks::all().find(number)) open->help(member);
    });
  });
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
