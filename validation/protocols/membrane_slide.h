// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/problems/slopes/membrane_problem.h"

namespace stiction {

/// A box that slides down the membrane, over time.
struct MembraneSlide {
  std::vector<double> time;     ///< s
  std::vector<double> place;    ///< of the box along the chord, m
  std::vector<double> kinetic;  ///< J
  std::vector<double> slip;     ///< fastest loaded contact, m/s
  std::size_t from = 0;         ///< first sample that the string model is held against
};

/// `time`: what lasts so long is resolved, s.
MembraneSlide slide_down_membrane(CaseRun& run, const MembraneSetup& setup, double time = 8e-5);

/// What the checks compare, from the moment on at which the string model starts.
struct SlideCurve {
  std::vector<double> time, place, kinetic;  ///< s, m, J
  double peak() const { return *std::max_element(kinetic.begin(), kinetic.end()); }
  /// Where the kinetic energy is, m: vibrations of the strip don't shift it as they do the place of
  /// the highest value.
  double mean_place() const;
};

/// The box on the strip beside the string model, each from its own start.
struct BesideString {
  SlideCurve box, model;
  double length = 0.0;  ///< of the stretched strip, m
  /// How far the string model is from the mesh. Its tension is the same all along, where the
  /// strip's own weight makes it T (1 ± ε): that moves the lowest point by ε ℓ/6.
  double epsilon = 0.0;
  double lowest() const { return epsilon / 6.0; }  ///< of ℓ
};
BesideString beside_string(const MembraneSlide& found, const MembraneSetup& setup);

}  // namespace stiction
