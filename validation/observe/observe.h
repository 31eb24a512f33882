// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "validation/engine/engine.h"
#include "validation/engine/problem.h"

namespace stiction {

/// An obstacle of the problem, or another body with `is_body`.
struct Partner {
  std::size_t index = 0;
  bool is_body = false;
};

/// What is looked at.
struct Watched {
  std::size_t body = 0;
  std::optional<Partner> against{};      ///< of its contacts those with this one alone
  std::optional<Partner> relative_to{};  ///< its centre's motion is that over this one
  bool contacts = false;                 ///< are asked for: not every engine tells them
  bool energies = false;                 ///< are asked for: they cost as much as a step
};

/// What was seen of a body, or the scene, at one time: what was asked for.
struct Sample {
  double time = 0.0;  ///< s
  BodyMotion motion{Vec3::Zero(), Vec3::Zero()};
  Energies energies{};  ///< of the whole scene
  /// Of the body, each as the body feels it, whichever of two bodies an engine counts it for; those
  /// with itself once.
  std::vector<ContactSample> contacts;
};

/// A time at which an engine is looked at: what several samples share is asked for once.
class Moment {
 public:
  /// `problem` is what the engine was given; time in s. Both must outlive it, and the engine stay as it
  /// is.
  Moment(const Engine& engine, const Problem& problem, double time)
      : engine_(engine), problem_(problem), time_(time) {}
  Sample sample(const Watched& watched);

 private:
  const Engine& engine_;
  const Problem& problem_;
  double time_;
  std::optional<std::vector<ContactSample>> contacts_{};
  std::optional<Energies> energies_{};
};

/// For pictures: none where the engine does not tell them.
std::vector<ContactSample> contacts_if_told(const Engine& engine);

/// Slip of the fastest of all contacts, open ones included, m/s; 0 without contacts.
double fastest_slip(const Engine& engine);

/// What an observable is of.
enum class Subject { kCentre, kTurn, kContacts, kScene };

/// A quantity that a check of a person's own problem can ask for.
struct Observable {
  std::string name;
  std::string unit;
  std::string meaning;
  Subject subject;
  bool over_window;   ///< compares the time `from` with the time `at`
  bool in_direction;  ///< needs a direction
  double (*measure)(const Sample& from, const Sample& at, const Vec3& direction);
  double period = 0.0;         ///< values that far apart are the same; 0: none are
  bool needs_contact = false;  ///< NaN, which holds no claim, without contacts
};

/// All of them, in the order of the help text.
const std::vector<Observable>& observables();

/// The contacts that carry a load, at one time.
struct ContactSlips {
  double mean = 0.0;     ///< slip, m/s
  double fastest = 0.0;  ///< m/s
  int contacts = 0;
  int sliding = 0;  ///< of which the engine says that they slip
};
ContactSlips slips_of(const std::vector<ContactSample>& contacts);

}  // namespace stiction
