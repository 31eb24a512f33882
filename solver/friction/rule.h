// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/contact/contacts.h"
#include "solver/friction/parameter.h"

namespace stiction {

/// What a rule says of itself.
struct RuleCard {
  const char* memory;      ///< what it keeps of a contact from step to step
  const char* guarantees;  ///< what holds whatever the scene, and what doesn't
  int sweeps = 1;          ///< of a step, that it is meant to have
};

/// One contact's friction problem within a step, after its normal force is known. `Vector` is Vec3,
/// or PackedVec3 for a rule whose `solve` is a template that takes either.
template <class Vector>
struct SlipProblemOf {
  Vector free_slip;                         ///< ũ, tangential, m/s
  Vector start_slip;                        ///< u, tangential, at the start of the step, m/s
  Real inverse_mass = 0;                    ///< w > 0, m/s/N
  Real bound = 0;                           ///< μ fⁿ ≥ 0, N
  ContactStatus was = ContactStatus::kNew;  ///< status at the end of the last step
  Vector normal = Vec3(Vec3::UnitZ());      ///< n of the contact, unit
  bool first_sweep = true;  ///< of this step: rules that learn from step to step learn now
  Vector force =
      Vector::Zero();  ///< friction applied so far in this step, N; ũ does not contain it
};
using SlipProblem = SlipProblemOf<Vec3>;

/// A rule's answer: friction force on the vertex (tangential, |force| ≤ bound) and what the contact
/// did.
template <class Vector>
struct SlipSolutionOf {
  Vector force;
  ContactStatus status;
};
using SlipSolution = SlipSolutionOf<Vec3>;

/// −bound · ũ/|ũ|, Coulomb's sliding friction [(7)]; zero when the bound is.
/// Precondition: |ũ| > 0, which a slipping contact has since |ũ| > w · bound ≥ 0.
inline SlipSolution sliding(const SlipProblem& problem) {
  return {-problem.bound / problem.free_slip.norm() * problem.free_slip, ContactStatus::kSlip};
}

/// Friction at its full bound would end the slip within the step [(11)]: u* = ũ − w μfⁿ ũ/|ũ| does
/// not keep the sign of ũ.
inline bool can_stick(const SlipProblem& problem) {
  const Real reach = problem.inverse_mass * problem.bound;
  return problem.free_slip.squaredNorm() <= reach * reach;
}

// A rule is a struct in a header of its own in rules/, named after the file (fixed_point.h →
// FixedPoint; `rule = "fixed-point"` in settings). The build lists them. It has
//   static constexpr int kValues            memory per contact, in doubles
//   explicit Rule(const RuleSettings&)      takes the values of its parameters by value_of()
//   static constexpr std::array kParameters the parameters that it can be given (parameter.h), its
//                                           own and shared ones; may be left out without any
//   void reset(Real* memory) const        a new contact, or one whose memory is forgotten
//   static constexpr RuleCard kCard         what it remembers and guarantees, for people
//   static constexpr bool kWarmStart        whether the memory holds a force to start from:
//   Vec3 start(const Real* memory) const  that force, N (projected and clamped by the caller);
//                                           may be left out without a warm start
//   SlipSolution solve(const SlipProblem&, Real* memory) const
//   static constexpr bool kConjugate        may be left out; see conjugate_vector.h
// `solve` is called once a contact and sweep, of contacts that share a vertex in the order of their keys,
// perhaps by several threads at once: it keeps nothing but the memory. As a template that takes
// SlipProblemOf<Vector> it is faster (stored_vector.h).

}  // namespace stiction
