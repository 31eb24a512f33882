// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "reports/record/judgement.h"
#include "solver/demand.h"
#include "validation/engine/engine.h"
#include "validation/engine/problem.h"
#include "validation/observe/observe.h"

namespace stiction {

/// The mesher failed, not the file: costs this problem, not those beside it.
class NotMeshed : public InputError {
 public:
  using InputError::InputError;
};

/// What is observed of which body.
struct UserWatch : Watched {
  const Observable* observable = nullptr;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< unit, of observables along one
};

/// Of the values at all steps of a window, in place of the one at a time.
enum class Extreme { kNone, kLargest, kSmallest };

/// A claim of a person's problem, and when it is observed.
struct UserCheck {
  Claim claim{};
  UserWatch watch{};
  Extreme extreme = Extreme::kNone;
  /// In the observable's unit: then the value is how long it takes from `from` on until |value| stays at
  /// most this, s.
  std::optional<double> settles_below{};
  double from = 0.0;  ///< s; of observables and extremes over a window
  double at = 0.0;    ///< s
  std::string place;  ///< "FILE:LINE", for messages
  /// Looked at in every step of the window.
  bool at_each_step() const { return extreme != Extreme::kNone || settles_below; }
  bool over_window() const { return watch.observable->over_window || at_each_step(); }
};

/// A curve over time.
struct UserSeries {
  UserWatch watch{};
  std::string name;
};

struct UserProblem;

/// A number of the file that takes other values: "ramp.slope_deg".
struct UserVariation {
  std::string what;
  std::string unit;                         ///< "": it has none
  std::function<UserProblem(double)> with;  ///< the problem with that value; throws InputError
};

/// Where some check begins to fail, found by bisection.
struct UserThreshold {
  UserVariation vary{};
  double holds_at = 0.0, fails_at = 0.0, within = 0.0;  ///< in the unit of what varies
  Claim claim{};
  std::string place;  ///< "FILE:LINE"
};

/// The whole problem at each of some values.
struct UserSweep {
  UserVariation vary{};
  std::vector<double> values{};
};

/// What a body stands on.
struct UserSupport {
  std::optional<std::size_t> obstacle{};  ///< none: the body was placed by hand
  std::optional<std::size_t> body{};      ///< it stands on another
};

/// A problem of one's own as it was read.
struct UserProblem {
  Problem problem{};
  std::vector<Eigen::Vector3d> downhill{};  ///< one an obstacle, unit
  std::vector<bool> level{};                ///< one an obstacle: its downhill is a convention alone
  std::vector<UserSupport> supports{};      ///< one a body
  Settings settings{};                      ///< of the engine
  std::vector<UserCheck> checks{};
  std::vector<UserSeries> series{};
  std::optional<UserThreshold> threshold{};
  std::optional<UserSweep> sweep{};
  std::string title{};
  std::string file{};  ///< as messages call it
};

/// " against ramp", " relative to table", or nothing.
std::string partner_words(const Watched& watched, const Problem& problem);

/// "ramp.slope_deg = 20 deg".
std::string value_text(const std::string& what, const std::string& unit, double value);

/// "largest ", "smallest ", or nothing.
std::string extreme_word(Extreme extreme);

/// The problem that a text describes (TOML; `stiction validate --help-problem` explains each key);
/// `file` is what messages call it, and where its relative paths start. Throws InputError with one
/// sentence that names the file, and the line of a mistake in it: not TOML, a missing, unknown or
/// repeated name, a key without effect, a wrong type or unit, a number that is not finite, bodies
/// that begin inside each other.
UserProblem user_problem(std::istream& text, const std::filesystem::path& file);

}  // namespace stiction
