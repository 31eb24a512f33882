// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

namespace stiction {

/// Threads that do parts of a step side by side (oneTBB). They compute with the rounding mode of who
/// calls, who sees the exceptions of arithmetic that they raise, as if all had been done by himself.
class Team {
 public:
  /// So many threads, that of the caller among them; with 1 nothing is started. Throws InputError
  /// unless that is between 1 and `most_threads()`.
  explicit Team(int threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int size() const { return size_; }

  /// CPU time that threads other than the caller's have spent on work so far, s.
  double helpers_cpu_seconds() const;

 private:
  struct Arena;
  using Call = void (*)(const void* work, std::size_t k);
  template <class Work>
  friend void for_each(const Team* team, std::size_t count, const Work& work);
  void share(std::size_t count, Call call, const void* work) const;

  int size_;
  std::unique_ptr<Arena> arena_;
};

/// The most threads that a team may have: 256, or 1 where the solver was built without oneTBB.
int most_threads();

/// How many threads a step is to have by the environment's STICTION_THREADS, or 1. Throws InputError
/// unless a team can have so many.
int step_threads();

/// What `step_threads` is where the environment says `wanted`.
int chosen_step_threads(const std::string& wanted);

/// Work that a range of a few microseconds holds: with less of it, to wake a thread costs more than
/// it saves.
inline constexpr std::size_t kVerticesToShare = 4096;  ///< of a few operations on each
inline constexpr std::size_t kContactsToShare = 128;   ///< of their search or memory

/// Calls work(0) … work(count − 1), each once: by the threads of the team, side by side and in any
/// order, or in this order where there is none. Returns when all are done, and throws what one of
/// them threw. Each thread begins with a part of its own, of pieces that follow each other, the same
/// for each work of so many.
template <class Work>
void for_each(const Team* team, std::size_t count, const Work& work) {
  // One copy of the work, never inlined: of two the compiler inlines less into each, and contacts took 1.6
  // times as long.
  const auto call = [](const void* of, std::size_t k) __attribute__((noinline)) {
    (*static_cast<const Work*>(of))(k);
  };
  if (team != nullptr && team->size() > 1 && count > 1) {
    team->share(count, call, &work);
  } else {
    for (std::size_t k = 0; k < count; ++k) call(&work, k);
  }
}

/// Into how many ranges of `grain` numbers or more `count` of them are cut for a team: eight for each
/// thread, so that where another program holds one up the others have the rest; one where there is no
/// team, or nothing to share.
inline std::size_t ranges_of(const Team* team, std::size_t count, std::size_t grain) {
  if (team == nullptr || team->size() == 1 || count < 2 * grain) return 1;
  return std::min(count / grain, 8 * static_cast<std::size_t>(team->size()));
}

/// Where the k-th of the ranges begins; at `ranges` that is `count`.
inline std::size_t range_begin(std::size_t count, std::size_t k, std::size_t ranges) {
  return count * k / ranges;
}

/// Calls work(k, begin, end) for so many ranges, which make up 0 … count.
template <class Work>
void for_each_range(const Team* team, std::size_t count, std::size_t ranges, const Work& work) {
  for_each(team, ranges, [&](std::size_t k) {
    work(k, range_begin(count, k, ranges), range_begin(count, k + 1, ranges));
  });
}

/// Calls work(begin, end) for as many as `ranges_of` says.
template <class Work>
void for_ranges(const Team* team, std::size_t count, std::size_t grain, const Work& work) {
  for_each_range(team, count, ranges_of(team, count, grain),
                 [&](std::size_t, std::size_t begin, std::size_t end) { work(begin, end); });
}

}  // namespace stiction
