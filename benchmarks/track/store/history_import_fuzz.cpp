// SPDX-License-Identifier: GPL-3.0-or-later
// What `track import` is given: a run or one sentence. A run is exported, imported and exported as the
// same bytes, by way of the history too; one that the history refuses leaves it as it was.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "benchmarks/track/measure/google_json.h"
#include "benchmarks/track/store/history.h"
#include "benchmarks/track/store/scratch.h"
#include "fuzz/property.h"

using namespace stiction;

namespace {

// A history that knows "known#time" in seconds, and what it holds.
struct Known {
  track::Scratch scratch;
  std::filesystem::path file = scratch.folder() / "history.sqlite";
  std::string content;

  Known() {
    track::StoredRun run{.date = "2026-01-01", .revision = "0123456789ab", .label = "known"};
    run.measurements.add({"known", "time", "s", track::Kind::kTime}, 1e-8);
    track::History(file).add(run);
    content = track::content_of(file);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Known known;
  const std::string text(data, data + size);
  const auto run = fuzz::value_or_sentence<track::TrackError>(
      [&] { return track::run_from_google_json(text, "a.json"); });
  if (!run) return 0;
  const std::string written = track::to_google_json(*run);
  const auto read_again = [](const std::string& json) {
    return track::to_google_json(track::run_from_google_json(json, "again.json"));
  };
  fuzz::hold(read_again(written) == written, "a run is exported as it was imported");

  std::ofstream(known.file, std::ios::binary) << known.content;
  track::History history(known.file);
  const auto id = fuzz::value_or_sentence<track::TrackError>([&] { return history.add(*run); });
  if (id) {
    fuzz::hold(track::to_google_json(history.run(*id)) == written,
               "the history keeps a run as it was imported");
  } else {
    fuzz::hold(track::content_of(known.file) == known.content,
               "an import that is refused leaves the history as it was");
  }
  fuzz::hold(!std::filesystem::exists(known.file.string() + "-journal"), "no journal is left");
  return 0;
}
