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

#ifdef __x86_64__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

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

// How a thread does arithmetic, its rounding mode and the like; which exceptions arithmetic has raised in it.
#ifdef __x86_64__
void pause() { __builtin_ia32_pause(); }

// Of the unit that all numbers here go through. A tenth of a microsecond at either end of a piece of work is
// less than half of what <cfenv> takes, which looks after another unit too.
class Arithmetic {
 public:
  static Arithmetic of_this_thread() { return Arithmetic(_mm_getcsr() & ~kRaised); }
  void apply() const { _mm_setcsr(value_); }  // nothing has been raised
  static int raised() { return static_cast<int>(_mm_getcsr() & kRaised); }
  static void raise(int which) { _mm_setcsr(_mm_getcsr() | static_cast<unsigned>(which)); }

 private:
  static constexpr unsigned kRaised = _MM_EXCEPT_MASK;
  explicit Arithmetic(unsigned value) : value_(value) {}
  unsigned value_;
};
#else
void pause() {}

class Arithmetic {
 public:
  static Arithmetic of_this_thread() {
    Arithmetic arithmetic;
    std::fegetenv(&arithmetic.value_);
    return arithmetic;
  }
  void apply() const {
    std::fesetenv(&value_);
    std::feclearexcept(FE_ALL_EXCEPT);
  }
  static int raised() { return std::fetestexcept(FE_ALL_EXCEPT); }
  static void raise(int which) { std::feraiseexcept(which); }

 private:
  std::fenv_t value_;
};
#endif

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

// One of a team: where he stands, and what is left of his own part of some work. He takes pieces from its
// front, and who has none left from its end, where he would come last. One line of the cache, so that a
// helper who is offered work has what he needs when he sees it.
class alignas(64) Member {
 public:
  // By the caller. Returns whether the helper is away, and is to be called.
  bool offer() { return state_.exchange(State::kOffered) == State::kAway; }
  // By the caller, who has done all that was left: nobody comes any more. Who has come is waited for.
  template <class Wait>
  void close(const Wait& wait) {
    State offered = State::kOffered;
    if (state_.compare_exchange_strong(offered, State::kLooking)) return;
    for (int looks = 1; state_.load(std::memory_order_acquire) == State::kInside; ++looks) {
      wait(looks);
    }
  }

  // By the helper: whether he has come in time.
  bool enter() {
    State offered = State::kOffered;
    return state_.load(std::memory_order_relaxed) == State::kOffered &&
           state_.compare_exchange_strong(offered, State::kInside);
  }
  void leave() {
    counted_.store(false, std::memory_order_relaxed);
    state_.store(State::kLooking, std::memory_order_release);
  }
  // For the work that he has left.
  void add_cpu_seconds(double more) {
    cpu_seconds_.store(cpu_seconds_.load(std::memory_order_relaxed) + more,
                       std::memory_order_relaxed);
    counted_.store(true, std::memory_order_release);
  }
  // Whether he may, as nothing is offered.
  bool go_away() {
    State looking = State::kLooking;
    return state_.compare_exchange_strong(looking, State::kAway);
  }

  // By the caller, between works: what the helper has spent on all of them.
  template <class Wait>
  double cpu_seconds(const Wait& wait) const {
    for (int looks = 1; !counted_.load(std::memory_order_acquire); ++looks) wait(looks);
    return cpu_seconds_.load(std::memory_order_relaxed);
  }

  void set_left(std::uint32_t begin, std::uint32_t end) {
    left_.store(joined(begin, end), std::memory_order_relaxed);
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
  // Nobody; somebody who looks out for work, or was called to; as he would with work for him; who does some.
  enum class State : int { kAway, kLooking, kOffered, kInside };

  static std::uint64_t joined(std::uint32_t begin, std::uint32_t end) {
    return std::uint64_t{end} << 32 | begin;
  }
  template <class Rest>
  bool take(const Rest& rest) {
    std::uint64_t left = left_.load(std::memory_order_relaxed);
    for (;;) {
      const auto begin = static_cast<std::uint32_t>(left);
      const auto end = static_cast<std::uint32_t>(left >> 32);
      if (begin >= end) return false;
      if (left_.compare_exchange_weak(left, rest(begin, end))) return true;
    }
  }

  std::atomic<State> state_ = State::kAway;
  std::atomic<bool> counted_ = true;
  std::atomic<double> cpu_seconds_ = 0.0;
  std::atomic<std::uint64_t> left_ = 0;
};

// Work that lies open, for its caller and those who help. The caller offers it to each, and closes it to who
// has not come: so nobody reads what is being written for the next work, and the caller waits for pieces
// that others have begun, never for who has not come yet.
//
// Each member has a part of his own, of pieces that follow each other: what they read and write stays in his
// processor's cache from one work to the next. Where each piece went to who came first, friction of 10⁴
// contacts, whose vertices went to and fro between the caches, took as long with two threads as with one.
class OpenWork {
 public:
  using Call = void (*)(const void* work, std::size_t k);

  // For so many, the caller among them, who is member 0.
  explicit OpenWork(int members) : member_(static_cast<std::size_t>(members)) {}

  // By the caller, who has whatever the helpers leave; throws what a piece threw. Calls those who are away,
  // call_helper(m).
  template <class CallHelper>
  void share(std::size_t count, Call call, const void* work, const CallHelper& call_helper) {
    if (in_piece_) {  // of work that shares in turn: that part is this thread's own
      for (std::size_t k = 0; k < count; ++k) call(work, k);
      return;
    }
    call_ = call;
    work_ = work;
    arithmetic_ = Arithmetic::of_this_thread();
    const std::size_t members = member_.size();
    for (std::size_t m = 0; m < members; ++m) {
      member_[m].set_left(static_cast<std::uint32_t>(count * m / members),
                          static_cast<std::uint32_t>(count * (m + 1) / members));
    }
    for (std::size_t m = 1; m < members; ++m) {
      if (member_[m].offer()) call_helper(m);
    }
    pieces(0);
    for (std::size_t m = 1; m < members; ++m) member_[m].close(wait);
    if (raised_ != 0) Arithmetic::raise(raised_.exchange(0));
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

  // By the member m, who was called, until nothing has come for a while, or will.
  void help(std::size_t m) {
    Member& member = member_[m];
    const Arithmetic own = Arithmetic::of_this_thread();
    double cpu_before = cpu_seconds_of_this_thread();
    auto until = Clock::now() + kPatience;
    for (int looks = 1; !ended_; ++looks) {
      if (member.enter()) {
        const auto begun = Clock::now();
        help_once(m);
        const std::chrono::duration<double> took = Clock::now() - begun;
        member.leave();
        // The clock of CPU time is slow: it is asked while nobody waits. What it says of looking out before is
        // not work; what the other says of being held up is not either.
        const double cpu_now = cpu_seconds_of_this_thread();
        member.add_cpu_seconds(std::min(took.count(), cpu_now - cpu_before));
        cpu_before = cpu_now;
        until = Clock::now() + kPatience;
        looks = 0;
      } else if (looks % kLooks == 0) {
        cpu_before = cpu_seconds_of_this_thread();
        if (Clock::now() > until && member.go_away()) break;
        wait(looks);
      } else {
        wait(looks);
      }
    }
    own.apply();
  }

  void end() { ended_ = true; }
  double helpers_cpu_seconds() const {
    double sum = 0.0;
    for (const Member& member : member_) sum += member.cpu_seconds(wait);
    return sum;
  }

 private:
  static void wait(int looks) {
    if (looks % kLooks == 0) {
      std::this_thread::yield();  // to who else may want this core
    } else {
      pause();
    }
  }

  // The next piece for the member m.
  bool take(std::size_t m, std::size_t& k) {
    if (member_[m].take_first(k)) return true;
    for (std::size_t other = 1; other < member_.size(); ++other) {
      if (member_[(m + other) % member_.size()].take_last(k)) return true;
    }
    return false;
  }

  void pieces(std::size_t m) {
    in_piece_ = true;
    try {
      for (std::size_t k = 0; take(m, k);) call_(work_, k);
    } catch (...) {
      const std::lock_guard lock(throwing_);
      if (!thrown_) thrown_ = std::current_exception();
      for (Member& member : member_) member.set_left(0, 0);
    }
    in_piece_ = false;
  }

  void help_once(std::size_t m) {
    arithmetic_.apply();
    pieces(m);
    if (const int raised = Arithmetic::raised()) raised_ |= raised;
  }

  static inline thread_local bool in_piece_ = false;

  // Of the work that lies open: written while nobody is inside, and read together.
  alignas(64) Call call_ = nullptr;
  const void* work_ = nullptr;
  Arithmetic arithmetic_ = Arithmetic::of_this_thread();

  std::vector<Member> member_;
  alignas(64) std::atomic<bool> ended_ = false;
  std::atomic<int> raised_ = 0;  // by helpers, who have flags of their own
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
