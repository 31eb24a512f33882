// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/exact/overlap.h"
#include "validation/engine/engine.h"

namespace stiction {

/// Watches from outside whether bodies lie in each other deeper than contact explains: by their
/// surfaces alone, whatever the engine's contacts say. Its cost is not the engine's.
///
/// Up to half the thickness T of the body that is entered the nearest side is the one by which
/// something came in, and a penalty pushes it back; from there on it pushes on, and the bodies have
/// passed through each other. An edge that goes in by one side and out by the other has its middle
/// at T/2. So while a scene moves
///
///   d ≤ 0.4 T
///
/// is allowed, whatever the speed: an engine that steps over a tenth of the thickness from there
/// cannot tell the sides apart. At the end of a simulation
///
///   d ≤ min(T/4 + 2 |v_a − v_b| Δt, 0.4 T)
///
/// is: what stands has half of T/2 and what two steps travel, one to arrive and one to be stopped.
/// A penalty that closes κ of a depth in a step stands by g Δt² n (1 − κ)/κ under n times the
/// contact's own weight, 1e-6 m n at κ = 2/7 and Δt = 0.2 ms: on a sheet of 2 mm a quarter carries
/// 500 n. Depths are of the penalty alone, as elastic bodies give way by changing their surfaces.
///
/// Against half-spaces: the centre of mass of a body has no business beneath one.
class PassageWatch {
 public:
  explicit PassageWatch(const Problem& problem);

  /// The step at whose end it wants to look next: half the time in which two bodies would pass
  /// wholly through each other at their present speeds, at most `kLongest`.
  std::uint64_t due_step() const { return due_step_; }

  /// Looks at the state now; what it finds first of each pair is kept. Costs the comparison of
  /// boxes where nothing lies deep in another's.
  /// `at_end`: no step follows.
  void look(const Engine& engine, bool at_end = false);

  /// What was found, in words: "'bar b' passes through 'bar a', 12 mm deep, at t = 0.3 s".
  const std::vector<std::string>& found() const { return found_; }

 private:
  static constexpr double kLongest = 0.05;  // s: gravity adds 0.5 m/s in that time

  void tell_of_flight(double time, std::size_t body);
  void look_at_pair(double time, std::size_t a, std::size_t b, double allowed);
  void look_at_obstacles(double time, const std::vector<BodyMotion>& motion);

  const Problem problem_;
  std::vector<reference::Skin> skins_;  // none for an engine that shows no surface
  std::vector<double> thickness_;
  std::vector<bool> told_;  // of each pair, and then of each body and obstacle
  bool flown_ = false;      // one of them, too far for the rest to be looked at
  std::vector<std::string> found_;
  std::uint64_t due_step_ = 0;
};

}  // namespace stiction
