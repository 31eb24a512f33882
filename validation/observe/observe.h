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
};

/// What was seen of a body (and the scene) at one time.
struct Sample {
  double time = 0.0;  ///< s
  BodyMotion motion{Vec3::Zero(), Vec3::Zero()};
  Energies energies;  ///< of the whole scene
  /// Of the body, each as the body feels it, whichever of two bodies an engine counts it for; those
  /// with itself once.
  std::vector<ContactSample> contacts;
};

/// `problem` is what the engine was given; time in s.
Sample sample_of(const Engine& engine, const Problem& problem, double time, const Watched& watched);

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
