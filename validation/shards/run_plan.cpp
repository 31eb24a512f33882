// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/run_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "reports/record/environment.h"
#include "reports/record/json_field.h"
#include "reports/text/text.h"
#include "validation/core/digest.h"

namespace stiction {

namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 1;

template <std::size_t kCount>
bool is_one_of(std::string_view option, const std::string_view (&all)[kCount]) {
  return std::find(std::begin(all), std::end(all), option) != std::end(all);
}

// Of how it runs, without a value and with one.
bool is_flag_of_how(std::string_view option) {
  return is_one_of(option, {"--no-page", "--lines", "--verbose", "--fresh", "--retry"});
}
bool is_of_how(std::string_view option) {
  return is_one_of(option, {"--shard", "--out", "--jobs", "--parts", "--share"});
}

Shard read_shard(const JsonField& field) {
  const Shard shard{field["number"].count(), field["count"].count()};
  if (shard.number < 1 || shard.number > shard.count || shard.count > kMostShards) {
    field.fail(fmt::format("number is not from 1 to count, or that not to {}", kMostShards));
  }
  return shard;
}

std::size_t read_jobs(const JsonField& field) {
  constexpr std::size_t kMost = 1'000'000'000;
  const std::size_t jobs = field.count();
  if (jobs < 1 || jobs > kMost) field.fail(fmt::format("not from 1 to {}", kMost));
  return jobs;
}

}  // namespace

void write_plan(RecordStore& store, const RunPlan& plan) {
  const nlohmann::ordered_json json = {
      {"schema_version", kVersion},
      {"program", plan.program},
      {"words", plan.words},
      {"plan", plan.plan},
      {"jobs", plan.jobs},
      {"shard", {{"number", plan.shard.number}, {"count", plan.shard.count}}}};
  store.write_file(
      kRunFile, json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
}

RunPlan read_plan(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
  if (json.is_discarded()) throw std::runtime_error(one_line(file.string()) + ": not valid JSON");
  const JsonField field(json, file.string(), "");
  if (field["schema_version"].count() != kVersion) {
    field["schema_version"].fail(fmt::format("this program reads version {} alone", kVersion));
  }
  RunPlan plan;
  plan.program = field["program"].text();
  plan.words = field["words"].list([](const JsonField& word) { return word.text(); });
  plan.plan = field["plan"].text();
  plan.jobs = read_jobs(field["jobs"]);
  plan.shard = read_shard(field["shard"]);
  return plan;
}

std::vector<std::string> words_of(int argc, const char* const* argv) {
  std::vector<std::string> words;
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    const std::string_view option = word.substr(0, word.find('='));
    if (is_flag_of_how(option)) continue;
    if (!is_of_how(option)) {
      words.emplace_back(word);
    } else if (option == word) {
      ++k;  // and its value
    }
  }
  return words;
}

std::string revision_words() {
  std::string words = current_environment().revision;
  if (words.ends_with('+')) words += hash_of_file("/proc/self/exe");
  return words;
}

std::string engine_words(const EngineKind& engine) {
  std::string told = engine.name + "\n" + engine.description + "\n";
  std::istringstream words(engine.program);
  for (std::string word; words >> word;) {
    std::error_code none;
    // Wherever it lies: parts may be of several checkouts.
    const bool is_file = fs::is_regular_file(word, none);
    told += is_file ? fs::path(word).filename().string() + " " + hash_of_file(word) : word;
    told += '\n';
  }
  return told;
}

std::string plan_of(const std::vector<Job>& jobs, const std::string& more) {
  std::string words = "run 1\n" + revision_words() + "\n" + more + "\n", last;
  std::string engine;  // of the last job; they are many, and their engines few
  for (const Job& job : jobs) {
    if (job.engine.name + job.engine.program != last || engine.empty()) {
      last = job.engine.name + job.engine.program;
      engine = hash_of_words(engine_words(job.engine));
    }
    words += job.which.name + "\n" + engine + "\n";
    for (const auto& [name, value] : job.settings) words += name + "=" + value + "\n";
    words += fmt::format("{} {}\n", job.cpu_limit, job.finer);
  }
  return hash_of_words(words);
}

}  // namespace stiction
