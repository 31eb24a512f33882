// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

/// Limit analysis of rigid bodies with frictional point contacts: linear programming whose answers
/// are proved in exact rationals.
///
///   equilibrium of body b   Σ_c ± f_c + m_b (g + λ g_live) = 0,   Σ_c ± (p_c − x_b) × f_c = 0
///   Coulomb's cone          f_c = f_n n + f_t,   f_t · n = 0,   ‖f_t‖ ≤ μ s_c f_n
///
/// A program in doubles over inscribed polygonal cones proposes; two certificates decide, both of
/// them evaluated without any rounding:
/// - contact forces that lie in the *round* cones and balance the load: an equilibrium exists;
/// - a mechanism (virtual velocities v_b, ω_b; the dual variables) for which the load does work
///   while no force in the round cones can do negative work: there is none (Farkas). Its contact
///   condition is v_n ≥ μ s_c ‖v_t‖ for the relative velocity v of a against b.
/// Where neither holds, the polygons get an edge in the direction in which the mechanism slides,
/// and the program is solved again. So answers are brackets for the round cone, with polygons only
/// as fine as needed. `polygonal_critical_load` is the slow, independent check: CGAL's exact
/// simplex.
///
/// Time, measured on one core: a threshold of μ to 1e-6 (about 40 programs) takes 0.01 s for four
/// balls at 6 contacts, 0.15 s at 60, 1.6 s at 600; 0.2 s for 15 boxes at 100 contacts. A critical
/// load (1 or 2 programs) takes 0.02 s for 15 boxes, 0.1 s for 28, 0.3 s for 55.
///
/// What an answer means. Coulomb friction is not associated: that forces in the cone *can* carry
/// the load is necessary for rest, not sufficient. Beyond the threshold no rigid bodies can rest;
/// below it a state of rest exists, but dynamics, elasticity or a history of slip may fail to find
/// it. Contacts are points: give the corners of a flat patch, they span every pressure on it.
/// Scenes with known answers: limit_scenes.h.
namespace stiction::reference {

inline constexpr int kFixed = -1;  ///< `body_b` of a contact with a fixed obstacle

struct RigidBody {
  double mass = 0.0;                                         ///< kg
  Eigen::Vector3d center_of_mass = Eigen::Vector3d::Zero();  ///< m
};

/// One point at which `body_b` (or an obstacle) pushes `body_a`.
struct ContactPoint {
  int body_a = 0;
  int body_b = kFixed;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< m
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< from b to a, dimensionless
  double friction_scale = 1.0;  ///< multiplies the μ of the question, dimensionless
};

/// A clamp: the normal forces of these contacts add up to `total`, N. Without it two fixed jaws
/// could press as hard as they like, and any body between them would hold.
struct PrescribedNormalForce {
  std::vector<int> contacts;
  double total = 0.0;
};

struct LimitProblem {
  std::vector<RigidBody> bodies;
  std::vector<ContactPoint> contacts;
  std::vector<PrescribedNormalForce> clamps;
  Eigen::Vector3d gravity{0.0, 0.0, -9.81};                ///< m/s², the load that stays
  Eigen::Vector3d live_gravity = Eigen::Vector3d::Zero();  ///< m/s², multiplied by λ
};

/// Forces below are in units of the total weight, lengths in units of the scene's extent.
struct LimitOptions {
  int facets = 8;  ///< of the polygonal cones at the start, even, ≥ 4
  /// Residual of the equilibrium equations that still counts as equilibrium, sum over all rows.
  /// Coordinates rounded to double violate redundant equations by about 1e-16, and an exact zero
  /// would make every such scene infeasible. Thresholds move by about this much.
  double residual = 1e-9;
  /// 'None' means: no equilibrium whose normal forces sum to less than this many weights. It
  /// absorbs what rounding in the mechanism leaves at the contacts (about 1e-15 times this).
  double force_max = 1e3;
  double friction_tolerance = 1e-6;  ///< width at which the bisection of μ ends
  double friction_max = 10.0;        ///< a threshold beyond this counts as infinite
  double load_tolerance = 1e-6;      ///< width at which the refinement for λ ends
  double load_max = 100.0;           ///< a load factor that reaches this counts as infinite
  int rounds_max = 20;               ///< refinements of the polygons for one question

  /// Empty if usable, else what is wrong in words.
  [[nodiscard]] std::string check() const;
};

/// The largest program solved, and the effort of all of them together.
struct LimitSizes {
  int rows = 0;
  int columns = 0;
  int programs = 0;
  int iterations = 0;  ///< simplex pivots
};

enum class Equilibrium { exists, none, undecided };

struct LimitFeasibility {
  Equilibrium answer = Equilibrium::undecided;
  Eigen::Matrix3Xd forces;  ///< 3 × contacts, N, on body_a: the proof, if one exists
  /// 6 × bodies, v (m/s) and ω (rad/s) up to one factor: how it fails, the proof that none exists.
  Eigen::Matrix<double, 6, Eigen::Dynamic> mechanism;
  LimitSizes sizes;
};

/// lower ≤ the round cone's value ≤ upper.
struct LimitBracket {
  double lower = 0.0;
  double upper = 0.0;
  LimitSizes sizes;
  double middle() const { return 0.5 * (lower + upper); }
};

/// A value in nine significant digits, for what is begun at a limit or set a little below it: the
/// last bits, which a solver of linear programs is free in, shall not decide what is simulated.
double in_nine_digits(double value);

/// Question A: is there an equilibrium at friction coefficient μ and load factor λ?
/// Throws std::invalid_argument if the problem or the options are malformed (so do the others).
LimitFeasibility equilibrium(const LimitProblem& problem, double friction, double load_factor = 0.0,
                             const LimitOptions& options = {});

/// Question B: the smallest μ that allows equilibrium, by bisection (feasibility is monotone in μ).
/// Infinite if `friction_max` doesn't suffice.
LimitBracket critical_friction(const LimitProblem& problem, double load_factor = 0.0,
                               const LimitOptions& options = {});

/// Question C: the largest λ ≥ 0 that allows equilibrium at friction coefficient μ. Infinite if it
/// reaches `load_max`, −infinite if no λ in [0, load_max] does.
/// With gravity = −g e_n and live_gravity = g e_t, λ is the tangent of the slope.
LimitBracket critical_load(const LimitProblem& problem, double friction,
                           const LimitOptions& options = {});

/// Question C once more, independently: CGAL's exact simplex over inscribed (lower) and
/// circumscribed (upper) cones of `facets` facets. Time grows with about the fifth power of the
/// number of rows (6 a body): for problems of one to three bodies.
LimitBracket polygonal_critical_load(const LimitProblem& problem, double friction,
                                     const LimitOptions& options = {});

}  // namespace stiction::reference
