// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "reports/text/check_text.h"
#include "solver/demand.h"
#include "validation/comparison/engines/answers.h"

namespace stiction {

namespace {

constexpr std::size_t kQuickRungs = 3;

Case find_case(const std::string& name) {
  for (Case& one : case_catalog()) {
    if (one.name == name) return one;
  }
  throw std::logic_error("no case is called " + name);
}

// Of a configuration with a name, and what a rung of the ladder lays over it.
std::string command_of(const EngineKind& engine, const std::string& case_name,
                       const Configuration& configuration, const Settings& over) {
  std::string text = fmt::format("./stiction validate --engine '{}' --case '{}'",
                                 engine.program.empty() ? engine.name : engine.program, case_name);
  if (engine.configurations && !engine.program.empty()) {
    text += fmt::format(" --configuration '{}'", configuration.name);
  } else {
    for (const auto& [name, value] : configuration.settings) {
      text += fmt::format(" --set {}={}", name, value);
    }
  }
  for (const auto& [name, value] : over) text += fmt::format(" --set {}={}", name, value);
  return text;
}

std::vector<Configuration> configurations_of_case(const EngineKind& engine,
                                                  const std::string& case_name) {
  if (!engine.configurations) return {{.name = "default"}};
  std::vector<Configuration> all;
  for (Configuration& one : engine.configurations(case_name)) {
    if (one.contrast || one.only_full) continue;
    if (one.name.empty()) one.name = all.empty() ? "default" : settings_text(one.settings);
    all.push_back(std::move(one));
  }
  return all;
}

// The engine of the build's of which this is another build.
std::optional<EngineKind> original_of(const EngineKind& engine) {
  for (EngineKind& one : engine_catalog()) {
    for (const auto& [build, name] : one.builds) {
      if (name == engine.name) return std::move(one);
    }
  }
  return std::nullopt;
}

// An engine, and of which it is another build.
struct Asked {
  const EngineKind* engine;
  std::optional<EngineKind> original;
};

// Other builds right behind the engine of which they are.
std::vector<Asked> in_order(const std::vector<EngineKind>& engines) {
  std::vector<Asked> asked, builds;
  for (const EngineKind& one : engines) {
    Asked next{&one, original_of(one)};
    (next.original ? builds : asked).push_back(std::move(next));
  }
  for (auto one = builds.rbegin(); one != builds.rend(); ++one) {
    const auto behind = std::find_if(asked.begin(), asked.end(), [&](const Asked& other) {
      return other.engine->name == one->original->name;
    });
    asked.insert(behind == asked.end() ? behind : behind + 1, std::move(*one));
  }
  return asked;
}

// A build's own of those names; what it tells of single cases is nothing.
std::vector<Configuration> configurations_asked(const Asked& asked, const std::string& case_name) {
  std::vector<Configuration> all = configurations_of_case(*asked.engine, case_name);
  if (!asked.original) return all;
  const std::vector<Configuration> wanted = configurations_of_case(*asked.original, case_name);
  std::erase_if(all, [&](const Configuration& one) {
    return std::none_of(wanted.begin(), wanted.end(),
                        [&](const Configuration& other) { return other.name == one.name; });
  });
  return all;
}

const Judgement* answer_in(const Question& question, const Record& record) {
  for (const Judgement& check : record.checks) {
    if (check.claim.quantity == question.quantity) return &check;
  }
  return nullptr;
}

std::string unit_of(const Question& question, const Record& record) {
  if (question.answer == Answer::kRelative) return "1";
  const Judgement* const check = answer_in(question, record);
  return check ? check->claim.unit : "1";
}

// Of the same question, engine and configuration.
using Row = std::tuple<std::size_t, std::string, std::string>;

Record summary(const Question& question, const Trial& usual, const Record& record) {
  Record out;
  out.case_name = "engines/" + question.id;
  out.title = question.words;
  out.engine = usual.engine;
  out.settings = record.settings;
  out.settings["configuration"] = usual.configuration;
  out.settings["engine"] = usual.engine;
  if (!usual.build_of.empty()) out.settings[kBuildOf] = usual.build_of;
  out.variant = "configuration=" + usual.configuration;
  out.configuration = usual.configuration;
  out.simulations = record.simulations;
  out.problem = record.problem;
  out.environment = record.environment;
  out.verdict = Verdict::kForInformation;
  out.notes.push_back("again: " + usual.command);
  if (!usual.source.empty()) out.notes.push_back("its configuration: " + usual.source);
  if (record.verdict == Verdict::kError) out.failures.push_back({.reason = record.error});
  if (record.verdict == Verdict::kNotApplicable) {
    out.verdict = Verdict::kNotApplicable;
    out.notes.insert(out.notes.end(), record.notes.begin(), record.notes.end());
  }
  return out;
}

}  // namespace

std::vector<Trial> engine_trials(const std::vector<EngineKind>& engines,
                                 const std::vector<Question>& questions, bool quick) {
  const std::vector<Asked> in_turn = in_order(engines);
  std::size_t most = 1;
  for (const EngineKind& engine : engines) most = std::max(most, engine.ladder.size());
  std::vector<Trial> trials;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    const Case which = find_case(questions[q].case_name);
    std::size_t rungs = questions[q].curve ? most : 1;
    if (quick) rungs = std::min(rungs, kQuickRungs);
    for (std::size_t rung = 0; rung < rungs; ++rung) {
      for (const Asked& asked : in_turn) {
        const EngineKind& engine = *asked.engine;
        if (rung > 0 && rung >= engine.ladder.size()) continue;
        for (const Configuration& one : configurations_asked(asked, which.name)) {
          const Settings over = rung > 0 ? engine.ladder[rung] : Settings{};
          Settings settings = one.settings;
          for (const auto& [name, value] : over) settings[name] = value;
          trials.push_back({.question = q,
                            .engine = engine.name,
                            .configuration = one.name,
                            .effort = rung,
                            .job = {which, engine, settings},
                            .command = command_of(engine, which.name, one, over),
                            .source = one.source,
                            .build_of = asked.original ? asked.original->name : ""});
        }
      }
    }
  }
  return trials;
}

std::optional<double> error_of(const Question& question, const Record& record) {
  const Judgement* const check = answer_in(question, record);
  if (!check || record.verdict == Verdict::kError) return std::nullopt;
  const double off = check->value - check->claim.expected;
  switch (question.answer) {
    case Answer::kMagnitude:
      return std::abs(off);
    case Answer::kRelative:
      return off / std::abs(check->claim.expected);
    case Answer::kDegrees:
    case Answer::kCount:
    case Answer::kValue:
      return off;
  }
  return std::nullopt;
}

std::string row_name(const Trial& trial) { return trial.engine + " · " + trial.configuration; }

std::vector<Record> engine_records(const std::vector<Question>& questions,
                                   const std::vector<Trial>& trials,
                                   const std::vector<Record>& records) {
  std::map<Row, Record> rows;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const Trial& trial = trials[k];
    const Question& question = questions[trial.question];
    const Row row{trial.question, trial.engine, trial.configuration};
    auto [at, is_new] = rows.try_emplace(row);
    Record& out = at->second;
    if (is_new) out = summary(question, trial, records[k]);
    const std::optional<double> error = error_of(question, records[k]);
    const double seconds = records[k].cost.cpu_seconds;
    if (trial.effort == 0) {
      out.cost = records[k].cost;
      if (error) {
        out.figures.push_back({"error", unit_of(question, records[k]),
                               fmt::format("how far the answer is from the right one{}: {}",
                                           question.answer == Answer::kRelative ? ", relative" : "",
                                           question.quantity),
                               *error});
        out.figures.push_back({"CPU time", "s", "of the engine's steps in this case", seconds});
      }
    }
    if (!question.curve) continue;
    if (!error && records[k].verdict == Verdict::kNotApplicable) continue;
    if (!error) {
      out.failures.push_back({.reason = records[k].error,
                              .parameter = "effort",
                              .values = {static_cast<double>(trial.effort)}});
      continue;
    }
    if (out.series.empty()) {
      out.series.push_back({"error", unit_of(question, records[k]), "CPU time", "s", {}, {}});
    }
    out.series[0].x.push_back(seconds);
    out.series[0].y.push_back(std::abs(*error));
  }
  std::vector<Record> all;
  for (auto& [row, record] : rows) all.push_back(std::move(record));
  return all;
}

}  // namespace stiction
