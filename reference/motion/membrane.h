// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

/// A box that slides down an inclined, taut membrane (the paper's Fig. 4): the membrane sags under
/// it, so that it goes downhill before the middle and uphill behind it.
///
/// The membrane is a string in the plane of slope and gravity: x ∈ [0, ℓ] along the chord,
/// downhill, w(x) its deflection across the chord, H its tension along the chord. With P = m g cos
/// θ the box's load across the chord, at x = s, and q the membrane's own:
///
///   H w″ = −q beside the box,  w(0) = w(ℓ) = 0,  H_l w_l′ − H_r w_r′ = P,  H_l − H_r = F
///
/// where F is the pull of the box on the membrane, downhill, and l, r mark the two sides of the
/// box. Both laws below then read  s̈ = g sin θ − F/m.
///
/// **Linear law** (small slopes, F ≪ T). The box sees the mean slope φ of both sides, and
///   F = P tan(arctan μ − φ) ≈ P (μ − (1 + μ²) φ),   φ = (P/(T ℓ) + q/T)(ℓ − 2s)/2:
///   s̈ = κ (c − s),  κ = g cos θ (1 + μ²)(P/(T ℓ) + q/T),  c = ℓ/2 + g (sin θ − μ cos θ)/κ,
/// an oscillator up to its first rest, at s = c + √((c − s₀)² + v₀²/κ). At tan θ = μ, c = ℓ/2.
///
/// **Full law** (finite slopes, tension changed by friction). Three more equations:
/// 1. The membrane is linearly elastic with fixed ends, so that the pull F stretches the part above
///    the box and slackens the part below by the same length:
///    H_l = T + F (ℓ − s)/ℓ,  H_r = T − F s/ℓ.  Hence
///    w(s) = (P + qℓ/2) s (ℓ − s)/(T ℓ + F (ℓ − 2s)),
///    w_l′ = w/s − q s/(2 H_l),  w_r′ = −w/(ℓ − s) + q (ℓ − s)/(2 H_r).
/// 2. Coulomb friction at full slip, whatever the shape of the box's underside: along the contact
/// the
///    membrane turns from α_l = arctan w_l′ to α_r = arctan w_r′ and its tension falls as a rope's
///    on a bollard,   H_l/cos α_l = e^{μ (α_l − α_r)} H_r/cos α_r.
/// 3. That is one equation for F at each s.
/// Expanded to first order in slopes and in P/T it is the linear law.
///
/// Valid where
/// - the box is short against ℓ, and stays on the span;
/// - v ≪ √(T/ρ_A), so that the membrane keeps its static shape, and v² |d²w/ds²| ≪ g cos θ, so that
///   the box's own acceleration across the chord doesn't count;
/// - T is the tension at work: what the deflection adds to it (EA (w/ℓ)² and the like) is not
///   modelled, nor is the membrane's own weight along the chord (q ℓ tan θ ≪ T).
/// Once the box has come to rest it stays: friction would have to turn it back, and what stopped it
/// exceeds its weight's pull (for μ ≥ 0 and motion downhill).
namespace stiction::reference {

enum class MembraneLaw { linear, full };

/// Forces are totals over the membrane's width.
struct MembraneProblem {
  double tension = 0.0;   ///< T, N
  double length = 0.0;    ///< ℓ, m
  double own_load = 0.0;  ///< q, N/m, the membrane's own weight across the chord
  double box_load = 0.0;  ///< P = m g cos θ, N
  double gravity = 9.81;  ///< g, m/s²
  double slope = 0.0;     ///< θ, rad, in [0, π/2)
  double friction = 0.0;  ///< μ
  double start = 0.0;     ///< s₀, m, in (0, ℓ)
  double speed = 0.0;     ///< v₀ ≥ 0, m/s

  /// Empty if usable, else what is wrong in words.
  [[nodiscard]] std::string check() const;
};

enum class MembraneEnd {
  stops,   ///< comes to rest on the span, and sticks
  leaves,  ///< reaches the lower end
  moves,   ///< still under way at the end of the duration
};

struct MembraneSample {
  double time = 0.0;            ///< s
  double position = 0.0;        ///< s, m
  double velocity = 0.0;        ///< v, m/s
  double kinetic_energy = 0.0;  ///< ½ m v², J
};

struct MembraneMotion {
  std::vector<MembraneSample> samples;  ///< at equal times; the box stays where it stops
  MembraneEnd end = MembraneEnd::moves;
  double end_time = 0.0;      ///< of rest or of leaving, or the duration, s
  double end_position = 0.0;  ///< m
};

/// Acceleration s̈ of the box while it slides downhill at `position`, m/s². Throws
/// std::invalid_argument for a bad problem or a position off the span, std::domain_error where the
/// full law has no solution (friction would slacken the membrane).
double membrane_acceleration(const MembraneProblem& problem, MembraneLaw law, double position);

/// By GSL's Runge–Kutta–Prince–Dormand 8(9), relative tolerance 1e-12. `intervals` ≥ 1 equal parts
/// of `duration`, s. Throws as above.
MembraneMotion membrane_motion(const MembraneProblem& problem, MembraneLaw law, double duration,
                               int intervals);

/// κ, 1/s², and the place of rest of the linear law in closed form, m (which may lie off the span).
double membrane_stiffness(const MembraneProblem& problem);
double membrane_stop(const MembraneProblem& problem);

}  // namespace stiction::reference
