// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "solver/parallel/arithmetic.h"

namespace stiction {

/// One of a team: where he stands, and what is left of his own part of some work. He takes pieces from
/// its front, and who has none left from its end, where he would come last. One line of the cache, so
/// that a helper who is offered work has what he needs when he sees it.
class alignas(64) TeamMember {
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

/// CPU time that a helper spends on work, and for how long he has had none. To ask the system's clock of CPU
/// time takes microseconds: that is done once he has found nothing to do for a while, for all work before,
/// and now and then while he looks out. What it says of that is not work; what the other clock says of being
/// held up is not either.
class HelpersTime {
 public:
  using Clock = std::chrono::steady_clock;

  void begin() { begun_ = Clock::now(); }
  void end() {
    ended_ = Clock::now();
    worked_ += ended_ - begun_;
    counted_ = false;
  }

  Clock::duration idle() const { return Clock::now() - ended_; }
  // Whether there is work to count, or the clock of CPU time is to be asked again.
  bool is_to_count() const { return !counted_ || Clock::now() - asked_ > kAskedAfter; }
  // What he has worked since he was asked last, s.
  double count() {
    const double cpu_now = cpu_seconds();
    const double worked = std::chrono::duration<double>(worked_).count();
    const double spent = std::min(worked, cpu_now - cpu_);
    cpu_ = cpu_now;
    asked_ = Clock::now();
    worked_ = {};
    counted_ = true;
    return spent;
  }

 private:
  static constexpr auto kAskedAfter = std::chrono::microseconds(100);

  static double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  double cpu_ = cpu_seconds();
  Clock::time_point begun_, ended_ = Clock::now(), asked_ = ended_;
  Clock::duration worked_{};
  bool counted_ = true;
};

/// Work that lies open, for its caller and those who help. The caller offers it to each, and closes it to who
/// has not come: so nobody reads what is being written for the next work, and the caller waits for pieces
/// that others have begun, never for who has not come yet.
///
/// Each member has a part of his own, of pieces that follow each other: what they read and write stays in his
/// processor's cache from one work to the next. Where each piece went to who came first, friction of 10⁴
/// contacts, whose vertices went to and fro between the caches, took as long with two threads as with one.
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
    TeamMember& member = member_[m];
    const Arithmetic own = Arithmetic::of_this_thread();
    HelpersTime time;
    for (int looks = 1; !ended_; ++looks) {
      if (member.enter()) {
        time.begin();
        help_once(m);
        time.end();
        member.leave();
        looks = 0;
        continue;
      }
      if (looks % kLooks == 0) {
        // All is counted before he goes away: another one may come in his place at once.
        if (time.is_to_count()) member.add_cpu_seconds(time.count());
        if (time.idle() > kPatience && member.go_away()) break;
      }
      wait(looks);
    }
    own.apply();
  }

  void end() { ended_ = true; }
  double helpers_cpu_seconds() const {
    double sum = 0.0;
    for (const TeamMember& member : member_) sum += member.cpu_seconds(wait);
    return sum;
  }

 private:
  // A thread that has helped looks out for more for so long before it sleeps. To wake it took some 30 µs
  // on a virtual machine, as long as a phase of a thousand contacts: with 0.2 ms or none such a step took
  // longer with two threads than with one, with 3 ms it does not. With 10⁵ contacts it makes no difference.
  static constexpr auto kPatience = std::chrono::milliseconds(3);
  // Looks at what is to do, between two at the clock, and until another program may have the core. To give it
  // away takes a microsecond or more even where nobody wants it, in which nobody looks out: done at every
  // 64th look, a work that was shared took 1.0 µs longer than its half, and takes 0.2 to 0.6 now where a line
  // goes from one cache to the other and back in 54 ns; 1.2 to 1.7 and 0.7 to 1.2 where that takes 480.
  static constexpr int kLooks = 64;
  static constexpr int kLooksAlone = 512;

  static void pause() {
#ifdef __x86_64__
    __builtin_ia32_pause();
#endif
  }
  static void wait(int looks) {
    if (looks % kLooksAlone == 0) {
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
      for (TeamMember& member : member_) member.set_left(0, 0);
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

  std::vector<TeamMember> member_;
  alignas(64) std::atomic<bool> ended_ = false;
  std::atomic<int> raised_ = 0;  // by helpers, who have flags of their own
  std::mutex throwing_;
  std::exception_ptr thrown_;
};

}  // namespace stiction
