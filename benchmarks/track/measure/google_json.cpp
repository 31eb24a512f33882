// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/google_json.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "benchmarks/track/measure/child.h"
#include "reports/text/text.h"

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

// The same, its texts and names on one line: another program wrote them.
json of_plain_text(const json& value) {
  if (value.is_string()) return one_line(value.get<std::string>());
  if (!value.is_structured()) return value;
  json plain = value.is_array() ? json::array() : json::object();
  for (const auto& [name, one] : value.items()) {
    if (value.is_array()) {
      plain.push_back(of_plain_text(one));
    } else {
      plain[one_line(name)] = of_plain_text(one);
    }
  }
  return plain;
}

json parsed(const std::string& text, const std::string& what) {
  json file = json::parse(text, nullptr, false);
  if (!file.is_object() || !file.contains("benchmarks") || !file["benchmarks"].is_array()) {
    throw TrackError(fmt::format("{}: this is not Google Benchmark's JSON", what));
  }
  return of_plain_text(file);
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

// What the context of a file tells of the machine; other programs leave most of it out.
Machine machine_of(const json& context) {
  return {.processor = context.value("processor", context.value("host_name", "unknown")),
          .cores = context.value("num_cpus", std::int64_t{0}),
          .compiler = context.value("compiler", "unknown"),
          .flags = context.value("flags", context.value("library_build_type", "unknown"))};
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
    const json context = file.value("context", json::object());
    StoredRun run{.date = context.value("date", ""),
                  .revision = context.value("revision", ""),
                  .label = what,
                  .machine = machine_of(context)};
    for (const json& entry : file["benchmarks"]) {
      if (entry.value("run_type", "iteration") != "iteration") continue;
      const GoogleResult result = result_of(entry, what);
      run.measurements.add({result.name, "time", "s", Kind::kTime}, result.seconds);
      if (entry.value("repetition_index", 0) != 0) continue;
      // Our own exports carry the other metrics as {"what": {unit, kind, value}}.
      const json others = entry.value("stiction", json::object());
      for (const auto& [name, metric] : others.items()) {
        const std::string kind = metric.at("kind");
        run.measurements.add(
            {result.name, name, metric.at("unit"), parse_kind(kind).value_or(Kind::kOther)},
            metric.at("value").get<double>());
      }
    }
    if (run.measurements.all().empty()) throw TrackError(what + ": there is no result in it");
    return run;
  } catch (const json::exception& error) {
    throw TrackError(fmt::format("{}: {}", what, error.what()));
  }
}

std::string to_google_json(const StoredRun& run) {
  std::map<std::string, std::vector<const Measurement*>> by_subject;
  for (const auto& [name, measurement] : run.measurements.all()) {
    by_subject[measurement.metric.subject].push_back(&measurement);
  }
  json benchmarks = json::array();
  for (const auto& [subject, measurements] : by_subject) {
    json counters = json::object();
    const Measurement* times = nullptr;
    for (const Measurement* one : measurements) {
      if (one->metric.what == "time") {
        times = one;
      } else {
        counters[one->metric.what] = {{"unit", one->metric.unit},
                                      {"kind", to_string(one->metric.kind)},
                                      {"value", one->samples.front()}};
      }
    }
    if (times == nullptr) continue;  // Google Benchmark knows no result without a time
    for (std::size_t k = 0; k < times->samples.size(); ++k) {
      json entry = {{"name", subject},
                    {"run_name", subject},
                    {"run_type", "iteration"},
                    {"repetitions", times->samples.size()},
                    {"repetition_index", k},
                    {"threads", 1},
                    {"iterations", 1},
                    {"real_time", times->samples[k] * 1e9},
                    {"cpu_time", times->samples[k] * 1e9},
                    {"time_unit", "ns"}};
      if (k == 0 && !counters.empty()) {
        entry["stiction"] = counters;
        for (const auto& [what, metric] : counters.items()) entry[what] = metric["value"];
      }
      benchmarks.push_back(std::move(entry));
    }
  }
  const json file = {{"context",
                      {{"date", run.date},
                       {"revision", run.revision},
                       {"executable", "stiction track"},
                       {"processor", run.machine.processor},
                       {"num_cpus", run.machine.cores},
                       {"compiler", run.machine.compiler},
                       {"flags", run.machine.flags}}},
                     {"benchmarks", std::move(benchmarks)}};
  return file.dump(1) + "\n";
}

}  // namespace stiction::track
