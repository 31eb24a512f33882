// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/google_json.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {

namespace {

using nlohmann::json;

double unit_seconds(const std::string& unit, const std::string& what) {
  static const std::map<std::string, double> units = {
      {"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1.0}};
  const auto found = units.find(unit);
  if (found == units.end()) {
    throw TrackError(fmt::format("{}: unknown time unit '{}'", what, unit));
  }
  return found->second;
}

json parsed(const std::string& text, const std::string& what) {
  json file = json::parse(text, nullptr, false);
  if (!file.is_object() || !file.contains("benchmarks") || !file["benchmarks"].is_array()) {
    throw TrackError(fmt::format("{}: this is not Google Benchmark's JSON", what));
  }
  return file;
}

GoogleResult result_of(const json& entry, const std::string& what) {
  const std::string name = entry.value("run_name", entry.value("name", ""));
  if (entry.value("error_occurred", false)) {
    throw TrackError(
        fmt::format("{}: {}: {}", what, name, entry.value("error_message", "an error")));
  }
  if (entry.contains("time_per_contact")) return {name, entry["time_per_contact"].get<double>()};
  return {name,
          entry.at("cpu_time").get<double>() * unit_seconds(entry.value("time_unit", "ns"), what)};
}

// JSON's numbers have fractions and no end.
std::int64_t whole_number(const json& number, const char* name, const std::string& what) {
  const bool fits = number.is_number_integer() &&
                    (!number.is_number_unsigned() ||
                     number.get<std::uint64_t>() <= std::numeric_limits<std::int64_t>::max());
  if (!fits) throw TrackError(fmt::format("{}: '{}' is no whole number", what, name));
  return number.get<std::int64_t>();
}

// What the context of a file tells of the machine; other programs leave most of it out.
Machine machine_of(const json& context, const std::string& what) {
  return {.processor = context.value("processor", context.value("host_name", "unknown")),
          .cores = whole_number(context.value("num_cpus", json(0)), "num_cpus", what),
          .compiler = context.value("compiler", "unknown"),
          .flags = context.value("flags", context.value("library_build_type", "unknown"))};
}

constexpr std::int64_t kVersion = 1;  // of our own part

// All of a run, to the last bit: what Google Benchmark has no place for stands here too.
json part_of(const StoredRun& run) {
  json metrics = json::array();
  for (const auto& [name, measurement] : run.measurements.all()) {
    const Metric& metric = measurement.metric;
    metrics.push_back({{"subject", metric.subject},
                       {"what", metric.what},
                       {"unit", metric.unit},
                       {"kind", to_string(metric.kind)},
                       {"samples", measurement.samples}});
  }
  return {{"version", kVersion},
          {"date", run.date},
          {"revision", run.revision},
          {"label", run.label},
          {"machine",
           {{"processor", run.machine.processor},
            {"cores", run.machine.cores},
            {"compiler", run.machine.compiler},
            {"flags", run.machine.flags}}},
          {"metrics", std::move(metrics)}};
}

Metric metric_of(const json& told, const std::string& what) {
  const std::string kind = told.at("kind");
  Metric metric{.subject = told.at("subject"), .what = told.at("what"), .unit = told.at("unit")};
  const std::optional<Kind> known = parse_kind(kind);
  if (!known) {
    throw TrackError(
        fmt::format("{}: '{}' is of an unknown kind, '{}'", what, metric.name(), kind));
  }
  metric.kind = *known;
  return metric;
}

[[noreturn]] void refuse_second(const Metric& metric, const std::string& what) {
  throw TrackError(fmt::format("{}: there are two metrics '{}'", what, metric.name()));
}

// One more sample of what may have some.
void add_sample(StoredRun& run, const Metric& metric, double sample, const std::string& what) {
  const Measurement* const known = run.measurements.find(metric.name());
  if (known != nullptr && !(known->metric == metric)) refuse_second(metric, what);
  run.measurements.add(metric, sample);
}

StoredRun run_from_part(const json& part, const std::string& what) {
  if (whole_number(part.at("version"), "version", what) != kVersion) {
    throw TrackError(fmt::format("{} was written by a newer version of stiction", what));
  }
  const json& machine = part.at("machine");
  StoredRun run{
      .date = part.at("date"),
      .revision = part.at("revision"),
      .label = part.at("label"),
      .machine = {machine.at("processor"), whole_number(machine.at("cores"), "cores", what),
                  machine.at("compiler"), machine.at("flags")}};
  for (const json& told : part.at("metrics")) {
    const Metric metric = metric_of(told, what);
    if (run.measurements.find(metric.name()) != nullptr) refuse_second(metric, what);
    const auto samples = told.at("samples").get<std::vector<double>>();
    if (samples.empty()) {
      throw TrackError(fmt::format("{}: '{}' has no samples", what, metric.name()));
    }
    for (const double sample : samples) run.measurements.add(metric, sample);
  }
  if (run.measurements.all().empty()) throw TrackError(what + ": there is no result in it");
  return run;
}

// For other readers: each sample of a time as a repetition, the first with what else was measured of its
// subject as counters. Google Benchmark knows no result without a time.
json google_entries(const StoredRun& run) {
  std::map<std::string, json> counters;  // by subject
  for (const auto& [name, one] : run.measurements.all()) {
    if (one.metric.what != "time") {
      counters[one.metric.subject][one.metric.what] = one.samples.front();
    }
  }
  json entries = json::array();
  for (const auto& [name, one] : run.measurements.all()) {
    const std::string& subject = one.metric.subject;
    if (one.metric.what != "time") continue;
    for (std::size_t k = 0; k < one.samples.size(); ++k) {
      json entry = {{"name", subject},
                    {"run_name", subject},
                    {"run_type", "iteration"},
                    {"repetitions", one.samples.size()},
                    {"repetition_index", k},
                    {"threads", 1},
                    {"iterations", 1},
                    {"real_time", one.samples[k] * 1e9},
                    {"cpu_time", one.samples[k] * 1e9},
                    {"time_unit", "ns"}};
      // What is called as one of these fields is, stands in our own part alone.
      if (k == 0 && counters.contains(subject)) {
        for (const auto& [what, value] : counters[subject].items()) entry.emplace(what, value);
      }
      entries.push_back(std::move(entry));
    }
  }
  return entries;
}

}  // namespace

std::vector<GoogleResult> read_google_results(const std::string& text, const std::string& what) {
  try {
    std::vector<GoogleResult> results;
    const json file = parsed(text, what);
    for (const json& entry : file["benchmarks"]) {
      if (entry.value("run_type", "iteration") != "iteration") continue;
      results.push_back(result_of(entry, what));
    }
    return results;
  } catch (const json::exception& error) {
    throw TrackError(fmt::format("{}: {}", what, error.what()));
  }
}

StoredRun run_from_google_json(const std::string& text, const std::string& what) {
  try {
    const json file = parsed(text, what);
    if (file.contains("stiction")) return run_from_part(file["stiction"], what);
    const json context = file.value("context", json::object());
    StoredRun run{.date = context.value("date", ""),
                  .revision = context.value("revision", ""),
                  .label = what,
                  .machine = machine_of(context, what)};
    for (const json& entry : file["benchmarks"]) {
      if (entry.value("run_type", "iteration") != "iteration") continue;
      const GoogleResult result = result_of(entry, what);
      add_sample(run, {result.name, "time", "s", Kind::kTime}, result.seconds, what);
      // Exports from before our own part carried other metrics so.
      const json others = entry.value("stiction", json::object());
      for (const auto& [name, told] : others.items()) {
        const json named = {{"subject", result.name},
                            {"what", name},
                            {"unit", told.at("unit")},
                            {"kind", told.at("kind")}};
        add_sample(run, metric_of(named, what), told.at("value").get<double>(), what);
      }
    }
    if (run.measurements.all().empty()) throw TrackError(what + ": there is no result in it");
    return run;
  } catch (const json::exception& error) {
    throw TrackError(fmt::format("{}: {}", what, error.what()));
  }
}

std::string to_google_json(const StoredRun& run) {
  const json file = {{"context",
                      {{"date", run.date},
                       {"revision", run.revision},
                       {"executable", "stiction track"},
                       {"processor", run.machine.processor},
                       {"num_cpus", run.machine.cores},
                       {"compiler", run.machine.compiler},
                       {"flags", run.machine.flags}}},
                     {"benchmarks", google_entries(run)},
                     {"stiction", part_of(run)}};
  // JSON knows no bytes that are not UTF-8: a name with such has U+FFFD in their place.
  return file.dump(1, ' ', true, json::error_handler_t::replace) + "\n";
}

}  // namespace stiction::track
