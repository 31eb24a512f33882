// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "validation/core/case_run.h"

namespace stiction {

/// What an answer is held against, and how far that itself can be trusted.
struct PrecisionReference {
  double value = 0.0;        ///< in the answer's unit
  double uncertainty = 0.0;  ///< ≥ 0, in the answer's unit; 0: exact
  std::string words{};       ///< "g(sin θ − μ cos θ), exact"
};

/// A person's question to a solver, with one number as its answer.
struct PrecisionQuestion {
  std::string name{};   ///< "threshold"
  std::string title{};  ///< "the slope at which a box begins to slide"
  std::string unit{};   ///< of the answer, SI
  /// What errors are divided by, in the answer's unit; they are then dimensionless. 0: they are told
  /// in the answer's unit.
  double scale = 0.0;
  /// From this error on a run did not hold, or threw the scene away: it is told as broken, however
  /// little it cost. In the unit of errors.
  double lost = 1.0;
  std::vector<int>
      cells{};           ///< refinements: elements along the longest edge of the body asked about
  int fineness = 0;      ///< of bodies that bring no mesh of their own; 0: as the refinement says
  double seconds = 0.0;  ///< simulated for one answer, about, s
  std::function<Problem(int cells)> problem{};
  /// Throws InputError where the engine refuses or diverges; NaN where there is no answer.
  std::function<double(CaseRun&, int cells)> answer{};
  /// What the way of measuring can't tell from no error at all, with a time step (s), in the
  /// answer's unit.
  std::function<double(double dt)> resolution{};
  /// `part` is a run of the engine with other settings, whose cost nobody pays.
  std::function<PrecisionReference(const std::function<CaseRun(const Settings&)>& part)>
      reference{};
};

/// All of them; one function a question in precision_questions.cpp.
std::vector<PrecisionQuestion> precision_questions();

/// How far the solver can go with the problem in this refinement, and how large it is then.
struct StableStep {
  double limit = 0.0;  ///< largest stable time step, s
  double vertices = 0.0;
};
StableStep stable_step(const PrecisionQuestion& question, int cells);

/// Time steps to try, s, largest first: the next of 1, 2, 5 × 10ⁿ above the limit, which the engine
/// must refuse; the limit itself, rounded down to three digits; and 1, 2, 5 × 10ⁿ below it, down to
/// `finest`, one at least.
std::vector<double> time_steps_about(double limit, double finest);

/// "2e-4", "3.14e-4": three digits at most, as a setting and in a case's name.
std::string step_text(double dt);

/// The answer for Δt → 0 and h → 0, from simulations alone: f[m] = {with Δt, with Δt/2} on three
/// meshes whose cells h[m] fall. First order in Δt:
///
///   g[m] = 2 f[m][1] − f[m][0]
///
/// Where the g[m] differ as an order p of 1 to 2 in h would have it (linear tetrahedra: bending and
/// contact at vertices of the first, deflections of the second),
///
///   value = g[2] + ½ (r₁ + r₂),   r_p = (g[2] − g[1])/((h₁/h₂)ᵖ − 1),   uncertain by ½ |r₁ − r₂|;
///
/// else the value is g[2], uncertain by the largest |g[m] − g[2]|. And by all that Δt → 0 has
/// changed, |g[2] − f[2][1]|.
PrecisionReference extrapolated(const std::vector<std::array<double, 2>>& f,
                                const std::vector<double>& h);

}  // namespace stiction
