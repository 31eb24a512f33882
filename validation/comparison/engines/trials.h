// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "validation/comparison/engines/questions.h"
#include "validation/core/runner.h"

namespace stiction {

/// One question to one engine, in one configuration, with one effort.
struct Trial {
  std::size_t question = 0;   ///< among the questions asked
  std::string engine;         ///< its name
  std::string configuration;  ///< "default", "best"
  std::size_t effort = 0;     ///< rung of the engine's ladder; 0: the usual
  Job job{};
  std::string command{};   ///< reruns it
  std::string source{};    ///< where the configuration's values come from
  std::string build_of{};  ///< the engine of which this is another build; mostly empty
};

/// Every question to every engine in each of its configurations with its usual effort, and those
/// with a curve along its ladder. With `quick` up to two rungs above the usual. An engine that is
/// another build of one of ours (EngineKind::builds) is asked in the configurations of that one, right
/// behind it: what disturbs the machine disturbs both.
std::vector<Trial> engine_trials(const std::vector<EngineKind>& engines,
                                 const std::vector<Question>& questions, bool quick);

/// How far an answer is off, by the question's Answer; nothing when the record has none.
std::optional<double> error_of(const Question& question, const Record& record);

/// "Bullet · best": what a row is called.
std::string row_name(const Trial& trial);

/// What `compare engines` found, as records of their own: for each question, engine and
/// configuration its error and CPU time, and the curve of one against the other.
std::vector<Record> engine_records(const std::vector<Question>& questions,
                                   const std::vector<Trial>& trials,
                                   const std::vector<Record>& records);

}  // namespace stiction
