// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "validation/core/runner.h"
#include "validation/sweep/study.h"

namespace stiction {

/// The points of a study: engine by engine, in each case by case, and in each the designs with the last
/// axis running fastest. Each is made when it is asked for, so that a million take no room, but for
/// the numbers of those that are sampled.
class Points {
 public:
  /// `study` must outlive it. Reads the files that its problem names.
  explicit Points(const Study& study);

  std::size_t size() const { return study_.size(); }

  const StudyEngine& engine(std::size_t point) const;
  /// Of each axis, in its unit.
  std::vector<double> values(std::size_t point) const;
  /// What it is called: "user/ramp/ramp.slope_deg=20/ramp.friction=0.3".
  std::string name(std::size_t point) const;
  /// 16 hex digits, a hash of what is run: the problem with its values and the files that it names,
  /// the engine with the files that its command names and its settings, the suite's revision (of a
  /// changed tree the program itself). The same point has the same in every study.
  std::string hash(std::size_t point) const;
  /// 16 hex digits, a hash of the whole study: of its file, its problem, its engines, the revision.
  std::string plan() const;
  /// For run_job. A value that the problem refuses is the error of its record.
  Job job(std::size_t point) const;
  /// With the point's name, place and axes in this study, and no more than it keeps.
  Record finished(std::size_t point, Record record) const;
  /// The problem with the point's values; of studies of a problem alone. Throws InputError.
  UserProblem problem(std::size_t point) const;

 private:
  struct Place {
    std::size_t engine, which, design;
  };
  Place place(std::size_t point) const;
  toml::table root(std::size_t point) const;

  const Study& study_;
  std::vector<std::vector<double>> samples_{};
  std::string alike_{};                 // of all points: the revision, the files
  std::vector<std::string> engines_{};  // what each is
};

}  // namespace stiction
