// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/shard.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <optional>
#include <queue>
#include <random>
#include <string_view>
#include <utility>

#include "reports/text/text.h"
#include "solver/demand.h"

namespace stiction {

namespace {

std::optional<std::size_t> whole(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

Shard checked(std::optional<std::size_t> number, std::optional<std::size_t> count,
              const std::string& words) {
  if (!number || !count || *number < 1 || *number > *count || *count > kMostShards) {
    throw InputError(
        fmt::format("a shard is I/N with 1 ≤ I ≤ N ≤ {}, not '{}'", kMostShards, one_line(words)));
  }
  return {*number, *count};
}

// Where a variable names the shard, counted from `base`.
std::optional<Shard> shard_of(const char* number_name, const char* count_name, std::size_t base) {
  const char* const number = std::getenv(number_name);
  const char* const count = std::getenv(count_name);
  if (number == nullptr || count == nullptr) return std::nullopt;
  std::optional<std::size_t> from_one = whole(number);
  if (from_one) from_one = *from_one >= base ? *from_one - base + 1 : 0;
  return checked(from_one, whole(count),
                 fmt::format("{}={}, {}={}", number_name, number, count_name, count));
}

}  // namespace

Shard shard_from(const std::string& words) {
  if (!words.empty()) {
    const std::size_t slash = words.find('/');
    if (slash == std::string::npos) return checked({}, {}, words);
    return checked(whole(std::string_view(words).substr(0, slash)),
                   whole(std::string_view(words).substr(slash + 1)), words);
  }
  if (const auto shard = shard_of("GTEST_SHARD_INDEX", "GTEST_TOTAL_SHARDS", 0)) return *shard;
  const char* const first = std::getenv("SLURM_ARRAY_TASK_MIN");
  const std::optional<std::size_t> base = whole(first != nullptr ? first : "0");
  if (!base)
    throw InputError(fmt::format("SLURM_ARRAY_TASK_MIN is no number: '{}'", one_line(first)));
  if (const auto shard = shard_of("SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", *base)) {
    return *shard;
  }
  return {};
}

std::vector<std::size_t> jobs_of(const Shard& shard, const std::vector<double>& costs) {
  std::vector<std::size_t> dearest(costs.size());
  std::iota(dearest.begin(), dearest.end(), std::size_t{0});
  std::stable_sort(dearest.begin(), dearest.end(),
                   [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
  using ShardLoad = std::pair<double, std::size_t>;  // and the shard that has it, from 1 on
  std::priority_queue<ShardLoad, std::vector<ShardLoad>, std::greater<>> least;
  // More shards than jobs are empty.
  const std::size_t filled = std::min(shard.count, costs.size());
  for (std::size_t number = 1; number <= filled; ++number) least.emplace(0.0, number);
  std::vector<std::size_t> own;
  for (const std::size_t job : dearest) {
    const auto [load, number] = least.top();
    least.pop();
    least.emplace(load + costs[job], number);
    if (number == shard.number) own.push_back(job);
  }
  std::sort(own.begin(), own.end());
  return own;
}

std::vector<std::size_t> shuffled_share(const Shard& shard, std::size_t jobs) {
  std::vector<std::size_t> order(jobs);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (shard.count == 1) return order;
  std::mt19937_64 draw(1);  // std::shuffle may differ from library to library; this may not
  for (std::size_t k = jobs; k > 1; --k) std::swap(order[k - 1], order[draw() % k]);
  std::vector<std::size_t> own;
  for (std::size_t k = shard.number - 1; k < jobs; k += shard.count) own.push_back(order[k]);
  std::sort(own.begin(), own.end());
  return own;
}

}  // namespace stiction
