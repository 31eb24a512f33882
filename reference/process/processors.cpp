// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/processors.h"

#include <sched.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
#include <thread>

namespace stiction::reference {

namespace {

// Of independent chains, so that what a neighbour takes of a core shows: some 2 ms.
double seconds_of_arithmetic() {
  const auto begun = std::chrono::steady_clock::now();
  std::array<std::uint64_t, 8> x{1, 2, 3, 4, 5, 6, 7, 8};
  for (int round = 0; round < 500'000; ++round) {
    for (std::uint64_t& value : x) value = value * 6364136223846793005U + 1442695040888963407U;
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t value : x) sum += value;
  [[maybe_unused]] const volatile std::uint64_t seen = sum;  // it must be reckoned
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace

std::vector<int> own_processors() {
  std::vector<int> processors;
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) != 0) return processors;  // more than it has room for
  for (int k = 0; k < CPU_SETSIZE; ++k) {
    if (CPU_ISSET(k, &set)) processors.push_back(k);
  }
  return processors;
}

void stay_on(const std::vector<int>& processors) {
  if (processors.empty()) return;
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int k : processors) CPU_SET(k, &set);
  sched_setaffinity(0, sizeof set, &set);
}

int fastest_processor() {
  const std::vector<int> all = own_processors();
  if (all.size() < 2) return all.empty() ? -1 : all.front();
  int fastest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int one : all) {
    stay_on({one});
    const double seconds = seconds_of_arithmetic();
    if (seconds < least) {
      least = seconds;
      fastest = one;
    }
  }
  stay_on(all);
  return fastest;
}

double answer_seconds() {
  const std::vector<int> all = own_processors();
  if (all.size() < 2) return 0.0;
  constexpr int kAnswers = 2000, kRounds = 5;
  alignas(64) std::atomic<int> asked = 0;
  alignas(64) std::atomic<int> answered = 0;
  // Who waits for one that isn't running lets others run.
  const auto wait_for = [](const std::atomic<int>& line, int what) {
    for (int looks = 1; line.load(std::memory_order_acquire) != what; ++looks) {
      if (looks % 10'000 == 0) std::this_thread::yield();
    }
  };
  std::thread other([&] {
    stay_on({all[1]});
    for (int k = 1; k <= kAnswers * kRounds; ++k) {
      wait_for(asked, k);
      answered.store(k, std::memory_order_release);
    }
  });
  stay_on({all[0]});
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0, k = 0; round < kRounds; ++round) {
    const auto begun = std::chrono::steady_clock::now();
    for (int answer = 0; answer < kAnswers; ++answer) {
      asked.store(++k, std::memory_order_release);
      wait_for(answered, k);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    least = std::min(least, took.count() / kAnswers);
  }
  other.join();
  stay_on(all);
  return least;
}

OnFastestProcessor::OnFastestProcessor() : before_(own_processors()) {
  const int fastest = fastest_processor();
  if (fastest >= 0) stay_on({fastest});
}

OnFastestProcessor::~OnFastestProcessor() { stay_on(before_); }

}  // namespace stiction::reference
