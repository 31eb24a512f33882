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
      } else {
        if (looks % kLooks == 0) {
          cpu_before = cpu_seconds_of_this_thread();
          if (Clock::now() > until && member.go_away()) break;
        }
        wait(looks);
      }
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
  using Clock = std::chrono::steady_clock;

  // A thread that has helped looks out for more for so long before it sleeps. To wake it took some 30 µs
  // on a virtual machine, as long as a phase of a thousand contacts: with 0.2 ms or none such a step took
  // longer with two threads than with one, with 3 ms it does not. With 10⁵ contacts it makes no difference.
  static constexpr auto kPatience = std::chrono::milliseconds(3);
  static constexpr int kLooks = 64;  // at what is to do, between two at the clock

  static double cpu_seconds_of_this_thread() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  static void pause() {
#ifdef __x86_64__
    __builtin_ia32_pause();
#endif
  }
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
