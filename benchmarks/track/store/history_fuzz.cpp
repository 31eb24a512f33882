// SPDX-License-Identifier: GPL-3.0-or-later
// A history's file, damaged: what is asked of it has an answer or one sentence. A file that cannot be
// opened is left as it is, to the bit, and so is one that was only read.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "benchmarks/track/measure/google_json.h"
#include "benchmarks/track/store/history.h"
#include "benchmarks/track/store/scratch.h"
#include "fuzz/property.h"

using namespace stiction;

namespace {

constexpr std::size_t kMostRuns = 20;

template <class Read>
auto answer(Read read) {
  return fuzz::value_or_sentence<track::TrackError>(read);
}

void ask(const track::History& history) {
  answer([&] { return history.metrics(); });
  answer([&] { return history.trends("*", std::nullopt); });
  const auto runs = answer([&] { return history.runs(std::nullopt); });
  for (std::size_t k = 0; runs && k < std::min(kMostRuns, runs->size()); ++k) {
    const auto run = answer([&] { return history.run((*runs)[k].id); });
    if (run) answer([&] { return track::run_from_google_json(track::to_google_json(*run), "a"); });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const track::Scratch scratch;
  const std::filesystem::path file = scratch.folder() / "history.sqlite";
  const std::string bytes(data, data + size);
  for (const track::Access access : {track::Access::kRead, track::Access::kWrite}) {
    std::ofstream(file, std::ios::binary) << bytes;
    const bool opened = answer([&] {
                          const track::History history(file, access);
                          ask(history);
                          return true;
                        }).has_value();
    const bool makes = access == track::Access::kWrite && (bytes.empty() || opened);
    fuzz::hold(makes || track::content_of(file) == bytes,
               "a file that was read, or could not be, is left as it was");
    if (opened && access == track::Access::kWrite) {
      track::StoredRun run{.date = "2026-01-01", .revision = "0123456789ab", .label = "new"};
      run.measurements.add({"a", "time", "s", track::Kind::kTime}, 1e-8);
      answer([&] { return track::History(file).add(run); });
      answer([&] {
        ask(track::History(file, track::Access::kRead));
        return true;
      });
    }
    fuzz::hold(!std::filesystem::exists(file.string() + "-journal"), "no journal is left");
    std::filesystem::remove(file);
  }
  return 0;
}
