// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "reference/limit/limit_equations.h"

/// Internal to limit analysis: the program in doubles. Polygons stand in for the round cones, and
/// get finer where a mechanism slides through them.
namespace stiction::reference {

/// The directions, one list of tangents t (unit vectors) a contact, in which the polygonal cones
/// have their edges.
using SlipDirections = std::vector<std::vector<Eigen::Vector3d>>;

/// `facets` edges a contact, the first of them `start` spacings from the slip that is expected.
SlipDirections regular_polygons(const LimitProblem& problem, int facets, double start = 0.0);

/// The circumscribed polygons, a facet across the expected slip. What proves that they can't carry
/// the load proves it for the round cones, and where the slip is as expected nothing is lost.
struct OutsidePolygons {
  SlipDirections directions;
  double kappa;  ///< 1/cos(π/facets), a rounding larger, dimensionless

  OutsidePolygons(const LimitProblem& problem, int facets);
};

/// κ of polygons whose forces stay inside the round cone in spite of rounding (1e-16) in them,
/// dimensionless.
inline constexpr double kInside = 1.0 - 1e-12;

/// A x (+ λ w) = b,  x ≥ 0,  λ ≥ 0: the load column stands last, if there is one. All in the scaled
/// units of limit_equations.h.
struct LimitProgram {
  Eigen::MatrixXd a;                        ///< rows × columns; row_count rows
  Eigen::VectorXd b;                        ///< one entry a row
  std::vector<int> contact_of;              ///< one entry a column but λ's
  std::vector<Eigen::Vector3d> tangent_of;  ///< f_t at f_n = 1, one entry a column but λ's
};

/// Edges of the cones:  n + μ s κ t, with μ = `friction`, λ = `load_factor` and `kappa`
/// dimensionless. κ = 1 inscribes the polygons, 1/cos(π/m) circumscribes.
LimitProgram build_program(const LimitProblem& problem, const SlipDirections& directions,
                           double friction, double load_factor, bool with_load, double kappa);

/// The contact forces that the solution x of a program (one entry a column, scaled units) stands
/// for.
ContactForces contact_forces(const LimitProblem& problem, const LimitProgram& program,
                             const Eigen::VectorXd& x);

/// Gives each cone that the mechanism y (one entry a row: virtual velocities, dimensionless) pulls
/// through its polygon an edge where it does. False if there is none, so that the polygons are as
/// good as round.
bool refine(const LimitProblem& problem, double friction, const Eigen::VectorXd& y,
            SlipDirections& directions);

}  // namespace stiction::reference
