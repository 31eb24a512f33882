// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  std::vector<int> cells{};  ///< refinements: elements along the longest edge of the body asked about
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

/// The answer for Δt → 0 and h → 0, from simulations alone. Answers of first order in Δt; of an order
/// between the first and the second in h (linear tetrahedra: bending and contact at vertices of the
/// first, deflections of the second). f[m][k]: with h[m] and Δt/2ᵏ, k = 0, 1, 2; h falls.
///
///   g[m] = 2 f[m][2] − f[m][1],   value = g[1] + ½ (r₁ + r₂),   r_p = (g[1] − g[0])/((h₀/h₁)ᵖ − 1)
///
/// Its uncertainty: ½ |r₁ − r₂| between the two orders in h, and what the last halving of Δt changed
/// in its extrapolation, |g[1] − (2 f[1][1] − f[1][0])|.
PrecisionReference extrapolated(const std::vector<std::vector<double>>& f,
                                const std::vector<double>& h);

}  // namespace stiction
