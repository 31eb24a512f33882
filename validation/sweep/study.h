// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/statistics/samples.h"
#include "reports/record/judgement.h"
#include "validation/core/case.h"
#include "validation/user/vary.h"

namespace stiction {

/// One thing that a study varies.
struct Axis {
  std::string vary;              ///< as of a problem's sweep: "ramp.slope_deg", "engine.dt"
  std::string unit;              ///< "1" when dimensionless
  std::vector<double> values{};  ///< on a grid; empty where the study samples
  double from = 0.0, to = 0.0;   ///< where it samples
  bool log = false;              ///< spaced by factors
};

/// From 0, where the axis begins, to 1, where it ends.
double at_share(const Axis& axis, double share);

/// How a study chooses points where it does not take all combinations.
struct Samples {
  reference::Sampling method = reference::Sampling::kSobol;
  std::size_t count = 0;
  std::uint64_t seed = 0;
};

/// An engine in one of the ways in which a study runs it.
struct StudyEngine {
  EngineKind kind;
  Settings settings{};          ///< of the configuration
  std::string configuration{};  ///< its name; empty: what the engine does by default
};

/// "stiction, quiet"; the engine's name alone where it runs as it does by default.
std::string name_of(const StudyEngine& engine);

/// Where a study's points are expected to turn from holding to failing.
struct Boundary {
  std::size_t along = 0;              ///< the axis on which it lies
  std::optional<std::size_t> axis{};  ///< it lies where this axis's value is …
  double value = 0.0;                 ///< … or else at this one, in the unit of `along`
  bool holds_above = false;           ///< else below
  Claim claim{};                      ///< of the farthest wrong outcome
};

/// What a study runs, over what.
struct Study {
  std::string title{};
  std::filesystem::path file{};
  std::string name{};  ///< the file's, without its ending
  /// A person's own problem, or cases.
  std::shared_ptr<const ParsedFile> problem{};
  std::string problem_name{};  ///< the file's, without its ending
  std::vector<Case> cases{};
  std::vector<StudyEngine> engines{};
  std::vector<Axis> axes{};
  std::optional<Samples> samples{};
  std::optional<Boundary> boundary{};
  bool keeps_series = false;  ///< records keep curves over time

  /// How many combinations of the axes' values.
  std::size_t designs() const;
  std::size_t size() const;  ///< points: designs × engines × cases
};

/// The study that a file describes (TOML; `./stiction sweep --help-study` explains each key), its
/// problem parsed and its engines found. Throws InputError with one sentence that names the file,
/// and the line of a mistake in it.
Study read_study(const std::filesystem::path& file);

/// The engines that a study's file names, found or not; none for a file that is no study.
std::vector<std::string> engines_named(const std::filesystem::path& file);

/// What --help-study prints, in lines of at most `width` columns where a word allows it.
std::string study_help(std::size_t width);

}  // namespace stiction
