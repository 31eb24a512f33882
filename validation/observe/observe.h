// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/engine/engine.h"

namespace stiction {

/// What was seen of a body (and the scene) at one time.
struct Sample {
  double time = 0.0;  ///< s
  BodyMotion motion;
  Energies energies;                    ///< of the whole scene
  std::vector<ContactSample> contacts;  ///< of the body
};

Sample sample_of(const Engine& engine, double time, std::size_t body);

/// For pictures: none where the engine does not tell them.
std::vector<ContactSample> contacts_if_told(const Engine& engine);

/// Slip of the fastest of all contacts, open ones included, m/s; 0 without contacts.
double fastest_slip(const Engine& engine);

/// A quantity that a check of a person's own problem can ask for.
struct Observable {
  std::string name;
  std::string unit;
  std::string meaning;
  bool over_window;   ///< compares the time `from` with the time `at`
  bool in_direction;  ///< needs a direction
  bool of_scene;      ///< not of one body
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
