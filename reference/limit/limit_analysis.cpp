// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/limit_analysis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/limit/limit_equations.h"
#include "reference/limit/limit_program.h"
#include "reference/limit/limit_proofs.h"
#include "reference/limit/limit_simplex.h"

namespace stiction::reference {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Index = Eigen::Index;

void count(const Simplex& simplex, const LimitProgram& program, LimitSizes& sizes) {
  sizes.rows = std::max(sizes.rows, static_cast<int>(program.a.rows()));
  sizes.columns = std::max(sizes.columns, static_cast<int>(program.a.cols()));
  sizes.programs += 1;
  sizes.iterations += simplex.iterations();
}

void add(LimitSizes& sum, const LimitSizes& more) {
  sum.rows = std::max(sum.rows, more.rows);
  sum.columns = std::max(sum.columns, more.columns);
  sum.programs += more.programs;
  sum.iterations += more.iterations;
}

/// Question A with polygons that carry over from one call to the next.
LimitFeasibility decide(const LimitProblem& problem, double friction, double load_factor,
                        const LimitOptions& options, SlipDirections& directions) {
  const double unit = scale_of(problem).force;
  LimitFeasibility result;
  const auto proves_none = [&](const VectorXd& y) {
    if (!mechanism_refutes(problem, friction, load_factor, y, options)) return false;
    const auto bodies = static_cast<Index>(problem.bodies.size());
    result.answer = Equilibrium::none;
    result.mechanism =
        -Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>>(y.data(), 6, bodies);
    result.mechanism.bottomRows<3>() /= scale_of(problem).length;
    return true;
  };
  for (int round = 0; round < options.rounds_max; ++round) {
    const LimitProgram program =
        build_program(problem, directions, friction, load_factor, false, kInside);
    Simplex simplex(program.a, program.b);
    simplex.minimise_residual();
    count(simplex, program, result.sizes);
    const ContactForces forces = contact_forces(problem, program, simplex.solution());
    if (forces_prove(problem, friction, load_factor, forces, options.residual)) {
      result.answer = Equilibrium::exists;
      result.forces = unit * forces.bottomRows<3>();
      for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        const auto column = static_cast<Index>(c);
        result.forces.col(column) += unit * forces(0, column) * problem.contacts[c].normal;
      }
      return result;
    }
    const VectorXd y = simplex.multipliers();
    if (proves_none(y)) return result;
    if (round == 0) {
      const OutsidePolygons outside(problem, options.facets);
      const LimitProgram wider =
          build_program(problem, outside.directions, friction, load_factor, false, outside.kappa);
      Simplex outer(wider.a, wider.b);
      outer.minimise_residual();
      count(outer, wider, result.sizes);
      if (proves_none(outer.multipliers())) return result;
    }
    if (!refine(problem, friction, y, directions)) return result;
  }
  return result;
}

/// max λ  subject to  A x + λ w = b,  λ ≤ load_max; solved on construction.
struct LoadProgram {
  LimitProgram program;
  VectorXd x, y;
  double load = 0.0;

  LoadProgram(LimitProgram unbounded, const LimitOptions& options, LimitSizes& sizes)
      : program(std::move(unbounded)) {
    const Index rows = program.a.rows();
    const Index column = program.a.cols() - 1;
    program.a.conservativeResizeLike(MatrixXd::Zero(rows + 1, column + 2));
    program.b.conservativeResize(rows + 1);
    program.a(rows, column) = program.a(rows, column + 1) = 1.0;
    program.b[rows] = options.load_max;
    Simplex simplex(program.a, program.b);
    simplex.minimise_residual();
    x = simplex.solution();
    if ((program.a * x - program.b).lpNorm<1>() <= options.residual) {
      simplex.maximise(column);
      x = simplex.solution();
    }
    y = simplex.multipliers().head(rows);
    load = x[column];
    count(simplex, program, sizes);
  }
};

}  // namespace

std::string LimitOptions::check() const {
  if (facets < 4 || facets % 2 != 0) return "facets must be even and at least 4";
  if (!(residual >= 1e-10 && residual < 1e-3)) return "residual must lie in [1e-10, 1e-3)";
  if (!(force_max >= 1.0)) return "force_max must be at least 1";
  if (!(friction_tolerance > 0.0)) return "friction_tolerance must be positive";
  if (!(friction_max > friction_tolerance)) return "friction_max must exceed friction_tolerance";
  if (!(load_tolerance > 0.0)) return "load_tolerance must be positive";
  if (!(load_max > 0.0)) return "load_max must be positive";
  if (rounds_max < 1) return "rounds_max must be at least 1";
  return {};
}

LimitFeasibility equilibrium(const LimitProblem& problem, double friction, double load_factor,
                             const LimitOptions& options) {
  check(problem, friction, load_factor, options);
  SlipDirections directions = regular_polygons(problem, options.facets);
  return decide(problem, friction, load_factor, options, directions);
}

LimitBracket critical_friction(const LimitProblem& problem, double load_factor,
                               const LimitOptions& options) {
  check(problem, 0.0, load_factor, options);
  SlipDirections directions = regular_polygons(problem, options.facets);
  LimitBracket result;
  const auto ask = [&](double friction) {
    const LimitFeasibility answer = decide(problem, friction, load_factor, options, directions);
    add(result.sizes, answer.sizes);
    return answer.answer;
  };
  if (ask(0.0) == Equilibrium::exists) return result;
  if (ask(options.friction_max) != Equilibrium::exists) {
    result.lower = result.upper = kInfinity;
    return result;
  }
  result.upper = options.friction_max;
  // An undecided point is closer to the threshold than the proofs reach: the bracket stays open
  // around it, and each end is moved towards it as far as it can be.
  double low = 0.0;
  while (result.upper - low > options.friction_tolerance) {
    const double middle = 0.5 * (low + result.upper);
    const Equilibrium answer = ask(middle);
    (answer == Equilibrium::exists ? result.upper : low) = middle;
    if (answer == Equilibrium::none) result.lower = middle;
  }
  if (result.lower == low) return result;
  double high = result.upper;
  while (high - result.lower > options.friction_tolerance) {
    const double middle = 0.5 * (result.lower + high);
    (ask(middle) == Equilibrium::none ? result.lower : high) = middle;
  }
  return result;
}

LimitBracket critical_load(const LimitProblem& problem, double friction,
                           const LimitOptions& options) {
  check(problem, friction, 0.0, options);
  LimitBracket result{-kInfinity, kInfinity, {}};
  // Improves both ends by what the program's solution and its mechanism prove.
  const auto learn = [&](const SlipDirections& directions, double kappa) {
    const LoadProgram program(build_program(problem, directions, friction, 0.0, true, kappa),
                              options, result.sizes);
    if (program.load > result.lower &&
        forces_prove(problem, friction, program.load,
                     contact_forces(problem, program.program, program.x), options.residual)) {
      result.lower = program.load;
    }
    if (result.lower >= options.load_max * (1.0 - 1e-9)) {
      result.lower = result.upper = kInfinity;
      return program.y;
    }
    result.upper = std::min(result.upper, load_bound(problem, friction, program.y, options));
    if (result.upper == -kInfinity) result.lower = -kInfinity;
    return program.y;
  };
  const auto done = [&] {
    return result.upper == result.lower || result.upper - result.lower <= options.load_tolerance;
  };
  SlipDirections directions = regular_polygons(problem, options.facets);
  for (int round = 0; round < options.rounds_max; ++round) {
    const VectorXd y = learn(directions, kInside);
    if (done()) break;
    if (round == 0) {
      const OutsidePolygons outside(problem, options.facets);
      learn(outside.directions, outside.kappa);
      if (done()) break;
    }
    if (!refine(problem, friction, y, directions)) break;
  }
  return result;
}

double in_nine_digits(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, 8.0 - std::floor(std::log10(std::abs(value))));
  return std::round(value * unit) / unit;
}

}  // namespace stiction::reference
