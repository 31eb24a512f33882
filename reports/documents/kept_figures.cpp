// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/documents/kept_figures.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace stiction {

namespace {

using Json = nlohmann::ordered_json;

// JSON has neither NaN nor infinities (reports/record/schema.md).
Json number_json(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  return value;
}

double number_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  const auto word = json.get<std::string>();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (word == "nan") return std::nan("");
  if (word == "inf") return kInfinity;
  if (word == "-inf") return -kInfinity;
  throw std::runtime_error(fmt::format("'{}' is no number", word));
}

}  // namespace

std::vector<Record> records_of(const std::vector<std::vector<Record>>& runs) {
  std::vector<Record> all;
  for (const std::vector<Record>& run : runs) {
    for (const Record& record : run) {
      std::erase_if(all, [&](const Record& before) {
        return before.case_name == record.case_name && before.settings == record.settings;
      });
    }
    all.insert(all.end(), run.begin(), run.end());
  }
  return all;
}

KeptFigures figures_of(const FigureRules& rules, const std::vector<std::vector<Record>>& runs) {
  const std::vector<Record> records = records_of(runs);
  KeptFigures kept;
  std::set<std::string> revisions;
  for (const Record& record : records) revisions.insert(record.environment.revision);
  if (!records.empty()) kept.environment = records.front().environment;
  kept.environment.revision = fmt::format("{}", fmt::join(revisions, ", "));
  for (const FigureRule& rule : rules.figures) kept.figures[rule.name] = value_of(rule, records);
  for (const SampleRule& rule : rules.samples) kept.samples[rule.name] = sample_of(rule, runs);
  return kept;
}

KeptFigures read_kept_figures(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) {
    throw std::runtime_error(fmt::format(
        "{} is missing: ./stiction readme --update RUN makes it from a run", file.string()));
  }
  try {
    const Json json = Json::parse(stream);
    KeptFigures kept;
    const Json& run = json.at("run");
    kept.environment = {run.at("revision"), run.at("toolchain"), run.at("machine"), run.at("date")};
    for (const auto& [name, one] : json.at("figures").items()) {
      FigureValue value;
      const Json& ends = one.at(0);
      value.low = number_of(ends.is_array() ? ends.at(0) : ends);
      value.high = number_of(ends.is_array() ? ends.at(1) : ends);
      const auto verdict = parse_verdict(one.at(1).get<std::string>());
      if (!verdict) throw std::runtime_error(fmt::format("'{}' has an unknown verdict", name));
      value.verdict = *verdict;
      kept.figures[name] = value;
    }
    for (const auto& [name, lines] : json.at("samples").items()) {
      for (const Json& line : lines) kept.samples[name] += line.get<std::string>() + "\n";
    }
    return kept;
  } catch (const std::exception& error) {
    throw std::runtime_error(
        fmt::format("{} is no file of figures: {}", file.string(), error.what()));
  }
}

std::string to_json(const KeptFigures& kept) {
  const Environment& run = kept.environment;
  const Json head{{"revision", run.revision},
                  {"toolchain", run.toolchain},
                  {"machine", run.machine},
                  {"date", run.date}};
  // A figure a line, so that a change is seen in a diff.
  std::string text = "{\n  \"run\": " + head.dump() + ",\n  \"figures\": {";
  const char* before = "\n";
  for (const auto& [name, value] : kept.figures) {
    const Json low = number_json(value.low), high = number_json(value.high);
    const Json ends = low == high ? low : Json::array({low, high});
    text += fmt::format("{}    {}: {}", before, Json(name).dump(),
                        Json::array({ends, to_string(value.verdict)}).dump());
    before = ",\n";
  }
  text += "\n  },\n  \"samples\": {";
  before = "\n";
  for (const auto& [name, lines] : kept.samples) {
    text += fmt::format("{}    {}: [", before, Json(name).dump());
    before = "\n";
    std::size_t from = 0;
    for (std::size_t end; (end = lines.find('\n', from)) != std::string::npos; from = end + 1) {
      text += before + std::string("      ") + Json(lines.substr(from, end - from)).dump();
      before = ",\n";
    }
    text += "\n    ]";
    before = ",\n";
  }
  return text + "\n  }\n}\n";
}

std::vector<std::string> disagreements(const FigureRules& rules, const KeptFigures& kept,
                                       const KeptFigures& fresh) {
  std::vector<std::string> sentences;
  for (const FigureRule& rule : rules.figures) {
    const auto found = kept.figures.find(rule.name);
    std::string sentence = found == kept.figures.end()
                               ? fmt::format("'{}' has no kept figure", rule.name)
                               : disagreement(rule, found->second, fresh.figures.at(rule.name));
    if (!sentence.empty()) sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace stiction
