// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/fixed_runs.h"

#include <fmt/format.h>
#include <fnmatch.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <nlohmann/json.hpp>
#include <sstream>

#include "benchmarks/track/measure/callgrind.h"
#include "benchmarks/track/measure/child.h"
#include "benchmarks/track/store/remembered.h"

namespace stiction::track {

namespace {

using nlohmann::json;

// An error of 0 has as many digits as a double.
constexpr double kMostDigits = 16.0;

std::vector<std::string> fixed_words(const Tree& tree, const std::string& name, int batches) {
  return {tree.program("bench").string(), "--fixed", name, "--batches", std::to_string(batches)};
}

// The JSON line that `bench --fixed` prints.
json fixed_run(const Tree& tree, const std::string& name, int batches) {
  const std::string what = fmt::format("{} of {} cannot be run", name, tree.label);
  const std::string line = last_line(demand_run(what, fixed_words(tree, name, batches)));
  json result = json::parse(line, nullptr, false);
  for (const char* key : {"contacts", "contact_updates", "allocations", "error"}) {
    if (!result.is_object() || !result.contains(key) || !result[key].is_number()) {
      throw TrackError(fmt::format("{}: its line lacks the number '{}'", what, key));
    }
  }
  return result;
}

json counts_of(const Tree& tree, const std::string& name) {
  const json one = fixed_run(tree, name, 1), three = fixed_run(tree, name, 3);
  const auto a_batch = [&](const char* key) {
    return 0.5 * (three[key].get<double>() - one[key].get<double>());
  };
  const double contacts = std::max(1.0, one["contacts"].get<double>());
  json counts = {{"contact updates", a_batch("contact_updates")},
                 {"allocations", a_batch("allocations")},
                 {"error", one["error"]}};
  if (one.contains("sweeps") && three.contains("sweeps")) counts["sweeps"] = a_batch("sweeps");
  if (has_program("valgrind")) {
    // Side by side: nothing is timed here.
    const std::string what = fmt::format("{} of {} cannot be counted", name, tree.label);
    const auto instructions = [&](int batches) {
      return count_instructions(what, fixed_words(tree, name, batches));
    };
    std::future<double> of_one = std::async(std::launch::async, instructions, 1);
    const double of_three = instructions(3);
    counts["instructions"] = 0.5 * (of_three - of_one.get()) / contacts;
  }
  return counts;
}

}  // namespace

std::vector<std::string> fixed_benchmarks(const Tree& tree, const std::vector<std::string>& globs) {
  const Ended ended = run({tree.program("bench").string(), "--list-fixed"});
  if (ended.code != 0) {
    throw TrackError(fmt::format("{} ({}) cannot be measured: its bench has no --list-fixed",
                                 tree.label, tree.revision));
  }
  std::vector<std::string> names;
  std::istringstream stream(ended.output);
  for (std::string name; std::getline(stream, name);) {
    const bool wanted =
        globs.empty() || std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) {
          return fnmatch(glob.c_str(), name.c_str(), 0) == 0;
        });
    if (wanted && !name.empty()) names.push_back(name);
  }
  return names;
}

Measurements count_fixed(const Tree& tree, const std::string& name, const Project& project,
                         bool fresh) {
  const std::string key = fmt::format("{} {} valgrind={}", content_hash(tree.program("bench")),
                                      name, has_program("valgrind"));
  const json counts = json::parse(remembered(project.work / "counts", key, fresh,
                                             [&] { return counts_of(tree, name).dump(); }));
  Measurements measured;
  for (const char* what : {"instructions", "contact updates", "sweeps", "allocations"}) {
    if (counts.contains(what)) measured.add({name, what, "1", Kind::kCount}, counts[what]);
  }
  const double error = std::abs(counts["error"].get<double>());
  const double digits = error > 0.0 ? std::min(kMostDigits, -std::log10(error)) : kMostDigits;
  measured.add({name, "digits: error", "1", Kind::kDigits}, digits);
  return measured;
}

}  // namespace stiction::track
