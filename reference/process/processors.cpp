// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/processors.h"

#include <sched.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
#include <numeric>
#include <thread>

namespace stiction::reference {

namespace {

// Rounds of arithmetic a second, found in some milliseconds. Of independent chains, so that what a neighbour takes of a
// core shows.
double arithmetic_rate() {
  constexpr double kSeconds = 2e-3;
  constexpr int kRounds = 2000;  // between two looks at the clock, some microseconds
  const auto begun = std::chrono::steady_clock::now();
  std::array<std::uint64_t, 8> x{1, 2, 3, 4, 5, 6, 7, 8};
  double done = 0.0, seconds = 0.0;
  while (seconds < kSeconds) {
    for (int round = 0; round < kRounds; ++round) {
      for (std::uint64_t& value : x) value = value * 6364136223846793005U + 1442695040888963407U;
    }
    done += kRounds;
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t value : x) sum += value;
  [[maybe_unused]] const volatile std::uint64_t seen = sum;  // it must be reckoned
  return done / seconds;
}

struct Processor {
  int number;
  double rate;  // of arithmetic, alone
};

// The fastest first.
std::vector<Processor> by_rate(const std::vector<int>& numbers) {
  std::vector<Processor> all;
  for (const int one : numbers) {
    stay_on({one});
    all.push_back({one, arithmetic_rate()});
  }
  stay_on(numbers);
  std::sort(all.begin(), all.end(),
            [](const Processor& a, const Processor& b) { return a.rate > b.rate; });
  return all;
}

// Of all of these at once.
double rate_together(const std::vector<Processor>& processors) {
  std::atomic<std::size_t> ready = 0;
  std::vector<double> rates(processors.size());
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < processors.size(); ++k) {
    threads.emplace_back([&, k] {
      stay_on({processors[k].number});
      ++ready;
      while (ready < processors.size()) std::this_thread::yield();
      rates[k] = arithmetic_rate();
    });
  }
  for (std::thread& thread : threads) thread.join();
  return std::accumulate(rates.begin(), rates.end(), 0.0);
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
  return by_rate(all).front().number;
}

double answer_seconds() {
  const std::vector<int> all = own_processors();
  if (all.size() < 2) return 0.0;
  // Few a round, so that some are not interrupted however busy the machine is, and those find an end.
  constexpr int kAnswers = 32, kRounds = 200, kEnough = -1;
  constexpr std::chrono::milliseconds kLongest(300);
  alignas(64) std::atomic<int> asked = 0;
  alignas(64) std::atomic<int> answered = 0;
  // Who waits for one that isn't running lets others run.
  const auto wait_while = [](const std::atomic<int>& line, int what) {
    for (int looks = 1;; ++looks) {
      const int now = line.load(std::memory_order_acquire);
      if (now != what) return now;
      if (looks % 10'000 == 0) std::this_thread::yield();
    }
  };
  std::thread other([&] {
    stay_on({all[1]});
    for (int k = 0; k != kEnough;) {
      k = wait_while(asked, k);
      answered.store(k, std::memory_order_release);
    }
  });
  stay_on({all[0]});
  double least = std::numeric_limits<double>::infinity();
  const auto first = std::chrono::steady_clock::now();
  auto begun = first;
  for (int round = 0; round < kRounds && begun < first + kLongest; ++round) {
    for (int k = 0; k < kAnswers; ++k) {
      const int before = asked.load(std::memory_order_relaxed);
      asked.store(before + 1, std::memory_order_release);
      wait_while(answered, before);
    }
    const auto ended = std::chrono::steady_clock::now();
    least = std::min(least, std::chrono::duration<double>(ended - begun).count() / kAnswers);
    begun = ended;
  }
  asked.store(kEnough, std::memory_order_release);
  other.join();
  stay_on(all);
  return least;
}

Together measure_together(int threads) {
  const std::vector<int> all = own_processors();
  if (all.size() < 2 || threads < 2) return {};
  std::vector<Processor> fastest = by_rate(all);
  fastest.resize(std::min(fastest.size(), static_cast<std::size_t>(threads)));
  return {answer_seconds(), rate_together(fastest) / fastest.front().rate};
}

OnFastestProcessor::OnFastestProcessor() : before_(own_processors()) {
  const int fastest = fastest_processor();
  if (fastest >= 0) stay_on({fastest});
}

OnFastestProcessor::~OnFastestProcessor() { stay_on(before_); }

}  // namespace stiction::reference
