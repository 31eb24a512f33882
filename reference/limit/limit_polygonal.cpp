// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <cmath>
#include <numbers>

#include "reference/limit/limit_analysis.h"
#include "reference/limit/limit_equations.h"
#include "reference/limit/limit_program.h"

namespace stiction::reference {

LimitBracket polygonal_critical_load(const LimitProblem& problem, double friction,
                                     const LimitOptions& options) {
  check(problem, friction, 0.0, options);
  LimitBracket result;
  const auto largest = [&](double kappa, double start) {
    const SlipDirections directions = regular_polygons(problem, options.facets, start);
    const LimitProgram program = build_program(problem, directions, friction, 0.0, true, kappa);
    const auto rows = static_cast<int>(program.a.rows());
    const auto load = static_cast<int>(program.a.cols()) - 1;
    CGAL::Quadratic_program<double> lp(CGAL::EQUAL, true, 0.0, false, 0.0);
    // Multiples of 2⁻⁴⁰ ≈ 9e-13: pivoting multiplies numerators, so short ones stay shorter.
    const auto rounded = [](double v) {
      return std::ldexp(std::nearbyint(std::ldexp(v, 40)), -40);
    };
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column <= load; ++column) {
        lp.set_a(column, row, rounded(program.a(row, column)));
      }
      lp.set_b(row, rounded(program.b[row]));
      // Two slacks a row, whose sum is bounded by one more row.
      for (const int side : {0, 1}) {
        const int column = load + 1 + 2 * row + side;
        lp.set_a(column, row, side == 0 ? 1.0 : -1.0);
        lp.set_a(column, rows, 1.0);
      }
    }
    lp.set_a(load + 1 + 2 * rows, rows, 1.0);
    lp.set_b(rows, options.residual);
    lp.set_c(load, -1.0);
    const auto solution = CGAL::solve_nonnegative_linear_program(lp, CGAL::Gmpzf());
    result.sizes.rows = lp.get_m();
    result.sizes.columns = lp.get_n();
    result.sizes.programs += 1;
    result.sizes.iterations += solution.number_of_iterations();
    if (solution.is_infeasible()) return -kInfinity;
    if (solution.is_unbounded()) return kInfinity;
    return -CGAL::to_double(solution.objective_value());
  };
  result.lower = largest(1.0, 0.0);
  result.upper = largest(1.0 / std::cos(std::numbers::pi / options.facets), 0.5);
  return result;
}

}  // namespace stiction::reference
