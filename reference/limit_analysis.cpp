// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit_analysis.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace stiction::reference {

namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Index = Eigen::Index;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- the problem, checked and scaled ------------------------------------------------------------

void demand(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("limit analysis: " + what);
}

void check(const LimitProblem& problem, double friction, double load, const LimitOptions& options) {
  if (const std::string wrong = options.check(); !wrong.empty()) demand(false, wrong);
  demand(friction >= 0.0 && std::isfinite(friction), "μ is negative or not finite");
  demand(std::isfinite(load), "the load factor is not finite");
  const auto bodies = static_cast<int>(problem.bodies.size());
  const auto contacts = static_cast<int>(problem.contacts.size());
  demand(bodies > 0, "no bodies");
  double mass = 0.0;
  for (const RigidBody& body : problem.bodies) {
    demand(body.mass >= 0.0 && std::isfinite(body.mass), "a mass is negative or not finite");
    demand(body.center_of_mass.allFinite(), "a centre of mass is not finite");
    mass += body.mass;
  }
  for (int c = 0; c < contacts; ++c) {
    const ContactPoint& contact = problem.contacts[static_cast<std::size_t>(c)];
    const std::string name = "contact " + std::to_string(c);
    demand(contact.body_a >= 0 && contact.body_a < bodies, name + ": body_a doesn't exist");
    demand(contact.body_b >= kFixed && contact.body_b < bodies, name + ": body_b doesn't exist");
    demand(contact.body_a != contact.body_b, name + ": a body touches itself");
    demand(contact.point.allFinite(), name + ": the point is not finite");
    demand(std::abs(contact.normal.norm() - 1.0) < 1e-9, name + ": the normal is not of length 1");
    demand(contact.friction_scale >= 0.0 && std::isfinite(contact.friction_scale),
           name + ": the friction scale is negative or not finite");
  }
  for (const PrescribedNormalForce& clamp : problem.clamps) {
    demand(clamp.total >= 0.0 && std::isfinite(clamp.total), "a clamp pulls, or is not finite");
    for (const int c : clamp.contacts)
      demand(c >= 0 && c < contacts, "a clamp has no such contact");
  }
  demand(problem.gravity.allFinite() && problem.live_gravity.allFinite(), "gravity is not finite");
  demand(mass * (problem.gravity.norm() + problem.live_gravity.norm()) > 0.0, "there is no load");
}

/// Powers of two, so that scaling is exact.
struct Scale {
  double force;
  double length;
};

double power_of_two_near(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  return std::ldexp(1.0, exponent);
}

Scale scale_of(const LimitProblem& problem) {
  double mass = 0.0;
  Vector3d low = problem.bodies.front().center_of_mass;
  Vector3d high = low;
  const auto include = [&](const Vector3d& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  };
  for (const RigidBody& body : problem.bodies) {
    mass += body.mass;
    include(body.center_of_mass);
  }
  for (const ContactPoint& contact : problem.contacts) include(contact.point);
  const double extent = (high - low).norm();
  const double gravity = std::max(problem.gravity.norm(), problem.live_gravity.norm());
  return {power_of_two_near(mass * gravity), power_of_two_near(extent > 0.0 ? extent : 1.0)};
}

int row_count(const LimitProblem& problem) {
  return static_cast<int>(6 * problem.bodies.size() + problem.clamps.size());
}

/// Row 6b + k: force on body b; 6b + 3 + k: moment about its centre of mass; then one row a clamp.
/// The column of a contact force on body_a, in scaled units. `Number` is double or an exact type.
template <class Number, class Add>
void for_wrench(const LimitProblem& problem, double length, const ContactPoint& contact,
                const std::array<Number, 3>& force, Add add) {
  for (const int side : {0, 1}) {
    const int body = side == 0 ? contact.body_a : contact.body_b;
    if (body == kFixed) continue;
    const Vector3d& center = problem.bodies[static_cast<std::size_t>(body)].center_of_mass;
    std::array<Number, 3> arm;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Index>(k);
      arm[k] = (Number(contact.point[axis]) - Number(center[axis])) / Number(length);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3;
      const std::size_t j = (k + 2) % 3;
      const Number moment = arm[i] * force[j] - arm[j] * force[i];
      const int row = 6 * body + static_cast<int>(k);
      add(row, side == 0 ? force[k] : Number(-force[k]));
      add(row + 3, side == 0 ? moment : Number(-moment));
    }
  }
}

/// How often contact c is a member of clamp j.
int membership(const LimitProblem& problem, std::size_t j, std::size_t c) {
  const std::vector<int>& members = problem.clamps[j].contacts;
  return static_cast<int>(std::count(members.begin(), members.end(), static_cast<int>(c)));
}

/// A tangent along which friction is expected: down the load's slope, else away from the scene's
/// middle. An edge of the polygon there makes plane problems exact from the start.
Vector3d expected_slip(const LimitProblem& problem, const ContactPoint& contact,
                       const Vector3d& middle) {
  const Vector3d& n = contact.normal;
  const Vector3d outwards = contact.point - middle;
  for (const Vector3d& hint : {problem.live_gravity, problem.gravity, outwards}) {
    const Vector3d tangent = hint - hint.dot(n) * n;
    if (tangent.norm() > 1e-6 * hint.norm()) return tangent.normalized();
  }
  return n.unitOrthogonal();
}

/// The directions, one list a contact, in which the polygonal cones have their edges.
using SlipDirections = std::vector<std::vector<Vector3d>>;

SlipDirections regular_polygons(const LimitProblem& problem, int facets, double start = 0.0) {
  Vector3d middle = Vector3d::Zero();
  for (const ContactPoint& c : problem.contacts) middle += c.point;
  if (!problem.contacts.empty()) middle /= static_cast<double>(problem.contacts.size());
  SlipDirections directions;
  for (const ContactPoint& contact : problem.contacts) {
    const Vector3d t1 = expected_slip(problem, contact, middle);
    const Vector3d t2 = contact.normal.cross(t1);
    std::vector<Vector3d>& list = directions.emplace_back();
    for (int k = 0; k < facets; ++k) {
      const double angle = (k + start) * 2.0 * std::numbers::pi / facets;
      list.push_back(std::cos(angle) * t1 + std::sin(angle) * t2);
    }
  }
  return directions;
}

// ---- the program in doubles ---------------------------------------------------------------------

/// A x (+ λ w) = b,  x ≥ 0,  λ ≥ 0: the load column stands last, if there is one.
struct Program {
  MatrixXd a;
  VectorXd b;
  std::vector<int> contact_of;       ///< one entry a column but λ's
  std::vector<Vector3d> tangent_of;  ///< f_t at f_n = 1, one entry a column but λ's
};

/// Edges of the cones:  n + μ s κ t. κ a little below 1 keeps the forces inside in spite of
/// rounding; κ = 1/cos(π/m) circumscribes.
Program build(const LimitProblem& problem, const SlipDirections& directions, double friction,
              double load_factor, bool with_load, double kappa) {
  const Scale scale = scale_of(problem);
  Program program;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactPoint& contact = problem.contacts[c];
    const double radius = kappa * friction * contact.friction_scale;
    const std::size_t edges = radius > 0.0 ? directions[c].size() : 1;
    for (std::size_t k = 0; k < edges; ++k) {
      program.contact_of.push_back(static_cast<int>(c));
      program.tangent_of.push_back(radius > 0.0 ? Vector3d(radius * directions[c][k])
                                                : Vector3d(Vector3d::Zero()));
    }
  }
  const auto columns = static_cast<Index>(program.contact_of.size());
  program.a.setZero(row_count(problem), columns + (with_load ? 1 : 0));
  program.b.setZero(row_count(problem));
  for (Index column = 0; column < columns; ++column) {
    const auto k = static_cast<std::size_t>(column);
    const auto c = static_cast<std::size_t>(program.contact_of[k]);
    const Vector3d f = problem.contacts[c].normal + program.tangent_of[k];
    for_wrench<double>(problem, scale.length, problem.contacts[c], {f.x(), f.y(), f.z()},
                       [&](int row, double value) { program.a(row, column) += value; });
    for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
      program.a(static_cast<Index>(6 * problem.bodies.size() + j), column) =
          membership(problem, j, c);
    }
  }
  const Vector3d gravity = problem.gravity + load_factor * problem.live_gravity;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const double share = problem.bodies[b].mass / scale.force;
    const auto row = static_cast<Index>(6 * b);
    program.b.segment<3>(row) = -share * gravity;
    if (with_load) program.a.block<3, 1>(row, columns) = share * problem.live_gravity;
  }
  for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
    program.b[static_cast<Index>(6 * problem.bodies.size() + j)] =
        problem.clamps[j].total / scale.force;
  }
  return program;
}

/// Revised simplex in doubles:  min cᵀx,  A x = b,  x ≥ 0, with the inverse of the basis kept
/// dense. It only proposes, so it may stop anywhere: the certificates decide.
class Simplex {
 public:
  /// Rows are extended by ± slacks, which are the first basis. b is perturbed (deterministically,
  /// ≤ 1e-11) against cycling: equilibrium of moments makes most of it zero.
  Simplex(const MatrixXd& a, const VectorXd& b) : rows_(a.rows()), columns_(a.cols()), b_(b) {
    a_.resize(rows_, columns_ + 2 * rows_);
    a_ << a, MatrixXd::Identity(rows_, rows_), -MatrixXd::Identity(rows_, rows_);
    perturbed_ = b;
    unsigned state = 1;
    for (Index r = 0; r < rows_; ++r) {
      state = state * 1664525U + 1013904223U;
      const double amount = 1e-11 * (0.5 + static_cast<double>(state >> 8U) / 33554432.0);
      perturbed_[r] += b[r] < 0.0 ? -amount : amount;
      basis_.push_back(columns_ + r + (b[r] < 0.0 ? rows_ : 0));
    }
    refactor();
  }

  /// Smallest Σ slacks: how far from feasible, and the mechanism that proves it.
  void minimise_residual() {
    cost_ = VectorXd::Zero(a_.cols());
    cost_.tail(2 * rows_).setOnes();
    run(a_.cols());
  }

  /// Largest x of `column`, from a feasible basis, slacks kept out.
  void maximise(Index column) {
    expel_slacks();
    cost_ = VectorXd::Zero(a_.cols());
    cost_[column] = -1.0;
    run(columns_);
  }

  /// Basic solution of the unperturbed right side, negative round-off clipped.
  [[nodiscard]] VectorXd solution() const {
    const VectorXd basic = inverse_ * b_;
    VectorXd x = VectorXd::Zero(columns_);
    for (std::size_t r = 0; r < basis_.size(); ++r) {
      if (basis_[r] < columns_) x[basis_[r]] = std::max(basic[static_cast<Index>(r)], 0.0);
    }
    return x;
  }
  [[nodiscard]] VectorXd multipliers() const { return inverse_.transpose() * basic_cost(); }
  [[nodiscard]] int iterations() const { return iterations_; }

 private:
  static constexpr double kPivot = 1e-7;

  [[nodiscard]] VectorXd basic_cost() const {
    VectorXd c(rows_);
    for (std::size_t r = 0; r < basis_.size(); ++r) c[static_cast<Index>(r)] = cost_[basis_[r]];
    return c;
  }

  /// Fresh inverse. A basis that turned out singular is given up for the last good one: false.
  bool refactor() {
    MatrixXd basis(rows_, rows_);
    for (std::size_t r = 0; r < basis_.size(); ++r) {
      basis.col(static_cast<Index>(r)) = a_.col(basis_[r]);
    }
    const MatrixXd inverse = basis.partialPivLu().inverse();
    since_refactor_ = 0;
    if (!inverse.allFinite() || inverse.cwiseAbs().maxCoeff() > 1e10) {
      basis_ = good_basis_;
      inverse_ = good_inverse_;
      x_ = inverse_ * perturbed_;
      return false;
    }
    good_basis_ = basis_;
    good_inverse_ = inverse_ = inverse;
    x_ = inverse_ * perturbed_;
    return true;
  }

  bool pivot(Index row, Index column, const VectorXd& direction) {
    basis_[static_cast<std::size_t>(row)] = column;
    inverse_.row(row) /= direction[row];
    const Eigen::RowVectorXd pivot_row = inverse_.row(row);
    VectorXd factors = direction;
    factors[row] = 0.0;
    inverse_.noalias() -= factors * pivot_row;
    x_ = inverse_ * perturbed_;
    ++iterations_;
    return ++since_refactor_ < 50 || refactor();
  }

  /// A slack that is basic at zero must not grow later: it leaves for any structural column.
  void expel_slacks() {
    for (Index row = 0; row < rows_; ++row) {
      if (basis_[static_cast<std::size_t>(row)] < columns_) continue;
      const Eigen::RowVectorXd entries = inverse_.row(row) * a_.leftCols(columns_);
      Index column = 0;
      if (entries.cwiseAbs().maxCoeff(&column) < kPivot) continue;  // a redundant equation
      if (!pivot(row, column, inverse_ * a_.col(column))) return;
    }
    refactor();
  }

  void run(Index allowed) {
    const int limit = iterations_ + 40 * static_cast<int>(rows_ + 50);
    while (iterations_ < limit) {
      const VectorXd y = multipliers();
      const VectorXd reduced = cost_.head(allowed) - a_.leftCols(allowed).transpose() * y;
      Index column = 0;
      if (reduced.minCoeff(&column) > -1e-11) {
        if (since_refactor_ == 0 || !refactor()) return;
        continue;
      }
      const VectorXd direction = inverse_ * a_.col(column);
      // Two passes: the smallest ratio with a little slack, then the safest pivot within it.
      double bound = kInfinity;
      for (Index r = 0; r < rows_; ++r) {
        if (direction[r] > kPivot) bound = std::min(bound, (x_[r] + 1e-13) / direction[r]);
      }
      if (bound == kInfinity) return;
      Index leaving = -1;
      for (Index r = 0; r < rows_; ++r) {
        if (direction[r] <= kPivot || x_[r] / direction[r] > bound) continue;
        if (leaving < 0 || direction[r] > direction[leaving]) leaving = r;
      }
      if (!pivot(leaving, column, direction)) return;
    }
  }

  Index rows_;
  Index columns_;
  MatrixXd a_;
  VectorXd b_, perturbed_, cost_, x_;
  MatrixXd inverse_, good_inverse_;
  std::vector<Index> basis_, good_basis_;
  int since_refactor_ = 0;
  int iterations_ = 0;
};

// ---- the proofs in rationals --------------------------------------------------------------------

using Exact = CGAL::Gmpq;
using ExactVector = std::array<Exact, 3>;

ExactVector exact(const Vector3d& v) { return {Exact(v.x()), Exact(v.y()), Exact(v.z())}; }

Exact dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// v − n (n · v)/(n · n): the normal is taken as it is, not as if its length were 1.
ExactVector tangential(const ExactVector& v, const ExactVector& n) {
  const Exact along = dot(v, n) / dot(n, n);
  return {v[0] - along * n[0], v[1] - along * n[1], v[2] - along * n[2]};
}

/// A double that is not below √q.
double root_from_above(const Exact& q) {
  double root = std::sqrt(CGAL::to_double(q)) * (1.0 + 1e-15);
  while (Exact(root) * Exact(root) < q) root = std::nextafter(root, kInfinity);
  return root;
}

/// The right side b − λ w, exactly, in scaled units; without the load's part if λ isn't wanted.
std::vector<Exact> exact_load(const LimitProblem& problem, const Vector3d& gravity, bool clamps) {
  const Scale scale = scale_of(problem);
  std::vector<Exact> load(static_cast<std::size_t>(row_count(problem)), Exact(0));
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const Exact share = Exact(problem.bodies[b].mass) / Exact(scale.force);
    for (std::size_t k = 0; k < 3; ++k) {
      load[6 * b + k] = -share * Exact(gravity[static_cast<Index>(k)]);
    }
  }
  for (std::size_t j = 0; clamps && j < problem.clamps.size(); ++j) {
    load[6 * problem.bodies.size() + j] = Exact(problem.clamps[j].total) / Exact(scale.force);
  }
  return load;
}

/// One column a contact, scaled: normal force f_n, then a vector whose part across n is f_t.
using ContactForces = Eigen::Matrix4Xd;

/// True if the forces lie in the round cones and leave at most `residual` of the load
/// gravity + λ live gravity unbalanced. This proves that an equilibrium exists.
bool forces_prove(const LimitProblem& problem, double friction, double load_factor,
                  const ContactForces& forces, double residual) {
  const double length = scale_of(problem).length;
  std::vector<Exact> left = exact_load(problem, problem.gravity, true);
  const std::vector<Exact> live = exact_load(problem, problem.live_gravity, false);
  for (std::size_t row = 0; row < left.size(); ++row) left[row] += Exact(load_factor) * live[row];
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactPoint& contact = problem.contacts[c];
    const auto column = static_cast<Index>(c);
    const ExactVector n = exact(contact.normal);
    const Exact normal_force(forces(0, column));
    ExactVector force = tangential(exact(forces.col(column).tail<3>()), n);
    const Exact bound = Exact(friction) * Exact(contact.friction_scale) * normal_force;
    if (normal_force < 0 || dot(force, force) > bound * bound) return false;
    for (std::size_t k = 0; k < 3; ++k) force[k] += normal_force * n[k];
    for_wrench<Exact>(problem, length, contact, force, [&](int row, const Exact& value) {
      left[static_cast<std::size_t>(row)] -= value;
    });
    for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
      left[6 * problem.bodies.size() + j] -= Exact(membership(problem, j, c)) * normal_force;
    }
  }
  Exact sum(0);
  for (const Exact& row : left) sum += CGAL::abs(row);
  return sum <= Exact(residual);
}

/// What a mechanism y proves. For forces in the cones with Σ f_n ≤ force_max and a residual within
/// bounds,
///   yᵀb − λ yᵀw = yᵀA x + yᵀ(residual) ≤ force_max · max_c (v_n + μ s ‖v_t‖)₊ + residual ‖y‖∞,
/// v the virtual velocity at contact c (with a clamp's multiplier on its normal part), w the live
/// column. Returns  dead = yᵀb − (right side)  and  live = yᵀw:  an equilibrium needs
/// dead ≤ λ live.
struct Proof {
  Exact dead;
  Exact live;
};

Proof mechanism_proves(const LimitProblem& problem, double friction, const VectorXd& y,
                       const LimitOptions& options) {
  const double length = scale_of(problem).length;
  Exact worst(0);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactPoint& contact = problem.contacts[c];
    ExactVector velocity{Exact(0), Exact(0), Exact(0)};
    for (std::size_t k = 0; k < 3; ++k) {
      ExactVector unit{Exact(0), Exact(0), Exact(0)};
      unit[k] = Exact(1);
      for_wrench<Exact>(problem, length, contact, unit,
                        [&](int row, const Exact& value) { velocity[k] += value * Exact(y[row]); });
    }
    const ExactVector n = exact(contact.normal);
    const ExactVector sliding = tangential(velocity, n);
    Exact work = dot(velocity, n) + Exact(friction) * Exact(contact.friction_scale) *
                                        Exact(root_from_above(dot(sliding, sliding)));
    for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
      const auto row = static_cast<Index>(6 * problem.bodies.size() + j);
      work += Exact(membership(problem, j, c)) * Exact(y[row]);
    }
    worst = std::max(worst, work);
  }
  const std::vector<Exact> dead = exact_load(problem, problem.gravity, true);
  const std::vector<Exact> live = exact_load(problem, problem.live_gravity, false);
  Proof proof{Exact(0), Exact(0)};
  for (std::size_t row = 0; row < dead.size(); ++row) {
    const Exact multiplier(y[static_cast<Index>(row)]);
    proof.dead += multiplier * dead[row];
    proof.live -= multiplier * live[row];
  }
  proof.dead -=
      Exact(options.force_max) * worst + Exact(options.residual) * Exact(y.cwiseAbs().maxCoeff());
  return proof;
}

// ---- question by question -----------------------------------------------------------------------

/// The circumscribed polygons, a facet across the expected slip. What proves that they can't carry
/// the load proves it for the round cones, and where the slip is as expected nothing is lost.
struct Outside {
  SlipDirections directions;
  double kappa;

  Outside(const LimitProblem& problem, int facets)
      : directions(regular_polygons(problem, facets, 0.5)),
        kappa((1.0 + 1e-12) / std::cos(std::numbers::pi / facets)) {}
};

// Keeps proposed forces inside the round cone in spite of rounding (1e-16) in their directions.
constexpr double kInside = 1.0 - 1e-12;

ContactForces contact_forces(const LimitProblem& problem, const Program& program,
                             const VectorXd& x) {
  ContactForces forces = ContactForces::Zero(4, static_cast<Index>(problem.contacts.size()));
  for (std::size_t k = 0; k < program.contact_of.size(); ++k) {
    const double share = x[static_cast<Index>(k)];
    forces(0, program.contact_of[k]) += share;
    forces.col(program.contact_of[k]).tail<3>() += share * program.tangent_of[k];
  }
  return forces;
}

/// Gives each cone that the mechanism y pulls through its polygon an edge where it does. False if
/// there is none, so that the polygons are as good as round.
bool refine(const LimitProblem& problem, double friction, const VectorXd& y,
            SlipDirections& directions) {
  const double length = scale_of(problem).length;
  bool refined = false;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactPoint& contact = problem.contacts[c];
    const double radius = friction * contact.friction_scale;
    Vector3d velocity = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const Vector3d unit = Vector3d::Unit(k);
      for_wrench<double>(problem, length, contact, {unit.x(), unit.y(), unit.z()},
                         [&](int row, double value) { velocity[k] += value * y[row]; });
    }
    double work = velocity.dot(contact.normal);
    for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
      work += membership(problem, j, c) * y[static_cast<Index>(6 * problem.bodies.size() + j)];
    }
    const Vector3d sliding = velocity - velocity.dot(contact.normal) * contact.normal;
    if (radius == 0.0 || work + radius * sliding.norm() < 1e-13) continue;
    const Vector3d direction = sliding.normalized();
    const auto known = [&](const Vector3d& d) { return (d - direction).norm() < 1e-9; };
    if (std::any_of(directions[c].begin(), directions[c].end(), known)) continue;
    directions[c].push_back(direction);
    refined = true;
  }
  return refined;
}

void count(const Simplex& simplex, const Program& program, LimitSizes& sizes) {
  sizes.rows = std::max(sizes.rows, static_cast<int>(program.a.rows()));
  sizes.columns = std::max(sizes.columns, static_cast<int>(program.a.cols()));
  sizes.programs += 1;
  sizes.iterations += simplex.iterations();
}

/// Question A with polygons that carry over from one call to the next.
LimitFeasibility decide(const LimitProblem& problem, double friction, double load_factor,
                        const LimitOptions& options, SlipDirections& directions) {
  const double unit = scale_of(problem).force;
  LimitFeasibility result;
  const auto proves_none = [&](const VectorXd& y) {
    const Proof proof = mechanism_proves(problem, friction, y, options);
    if (proof.dead <= Exact(load_factor) * proof.live) return false;
    const auto bodies = static_cast<Index>(problem.bodies.size());
    result.answer = Equilibrium::none;
    result.mechanism =
        -Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>>(y.data(), 6, bodies);
    result.mechanism.bottomRows<3>() /= scale_of(problem).length;
    return true;
  };
  for (int round = 0; round < options.rounds_max; ++round) {
    const Program program = build(problem, directions, friction, load_factor, false, kInside);
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
      const Outside outside(problem, options.facets);
      const Program wider =
          build(problem, outside.directions, friction, load_factor, false, outside.kappa);
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
  Program program;
  VectorXd x, y;
  double load = 0.0;

  LoadProgram(Program unbounded, const LimitOptions& options, LimitSizes& sizes)
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

void add(LimitSizes& sum, const LimitSizes& more) {
  sum.rows = std::max(sum.rows, more.rows);
  sum.columns = std::max(sum.columns, more.columns);
  sum.programs += more.programs;
  sum.iterations += more.iterations;
}

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
    const LoadProgram program(build(problem, directions, friction, 0.0, true, kappa), options,
                              result.sizes);
    if (program.load > result.lower &&
        forces_prove(problem, friction, program.load,
                     contact_forces(problem, program.program, program.x), options.residual)) {
      result.lower = program.load;
    }
    if (result.lower >= options.load_max * (1.0 - 1e-9)) {
      result.lower = result.upper = kInfinity;
      return program.y;
    }
    const Proof proof = mechanism_proves(problem, friction, program.y, options);
    if (proof.live < 0) {
      const double bound = std::nextafter(CGAL::to_double(proof.dead / proof.live), kInfinity);
      result.upper = std::min(result.upper, bound < 0.0 ? -kInfinity : bound);
    } else if (proof.dead > Exact(options.load_max) * proof.live) {
      result.upper = -kInfinity;
    }
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
      const Outside outside(problem, options.facets);
      learn(outside.directions, outside.kappa);
      if (done()) break;
    }
    if (!refine(problem, friction, y, directions)) break;
  }
  return result;
}

LimitBracket polygonal_critical_load(const LimitProblem& problem, double friction,
                                     const LimitOptions& options) {
  check(problem, friction, 0.0, options);
  LimitBracket result;
  const auto largest = [&](double kappa, double start) {
    const SlipDirections directions = regular_polygons(problem, options.facets, start);
    const Program program = build(problem, directions, friction, 0.0, true, kappa);
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

LimitProblem box_on_incline(const Vector3d& size, double mass) {
  LimitProblem problem;
  problem.bodies = {{mass, Vector3d(0.0, 0.0, 0.5 * size.z())}};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      ContactPoint& contact = problem.contacts.emplace_back();
      contact.point = Vector3d(x * size.x(), y * size.y(), 0.0);
    }
  }
  problem.live_gravity = Vector3d(9.81, 0.0, 0.0);
  return problem;
}

LimitProblem box_pyramid(int rows, double gap, bool touching) {
  LimitProblem problem;
  problem.live_gravity = Vector3d(9.81, 0.0, 0.0);
  const double pitch = 1.0 + gap;
  // The corners of a unit-deep patch: across x (top of a box) or across z (side of a box).
  const auto touch = [&](int a, int b, const Vector3d& low, const Vector3d& high,
                         const Vector3d& normal) {
    for (const double y : {-0.5, 0.5}) {
      for (const Vector3d& end : {low, high}) {
        problem.contacts.push_back({a, b, Vector3d(end.x(), y, end.z()), normal, 1.0});
      }
    }
  };
  int first_below = 0;
  for (int row = 0; row < rows; ++row) {
    const auto first = static_cast<int>(problem.bodies.size());
    const double z = row;
    for (int k = 0; k < rows - row; ++k) {
      const double x = pitch * (k + 0.5 * row);
      problem.bodies.push_back({1.0, Vector3d(x, 0.0, z + 0.5)});
      const Vector3d left(x - 0.5, 0.0, z);
      const Vector3d right(x + 0.5, 0.0, z);
      if (row == 0) {
        touch(first + k, kFixed, left, right, Vector3d::UnitZ());
      } else {
        const double inner_left = x - 0.5 * pitch + 0.5;
        const double inner_right = x + 0.5 * pitch - 0.5;
        touch(first + k, first_below + k, left, Vector3d(inner_left, 0.0, z), Vector3d::UnitZ());
        touch(first + k, first_below + k + 1, Vector3d(inner_right, 0.0, z), right,
              Vector3d::UnitZ());
      }
      if (touching && gap == 0.0 && k > 0) {
        touch(first + k, first + k - 1, left, left + Vector3d::UnitZ(), Vector3d::UnitX());
      }
    }
    first_below = first;
  }
  return problem;
}

LimitProblem four_ball_pyramid(double ratio, double ground_scale) {
  LimitProblem problem;
  const double ring = 2.0 / std::sqrt(3.0);
  const double rise = std::sqrt((1.0 + ratio) * (1.0 + ratio) - ring * ring);
  const Vector3d top(0.0, 0.0, 1.0 + rise);
  problem.bodies.push_back({ratio * ratio * ratio, top});
  for (int k = 0; k < 3; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 3.0;
    const Vector3d center(ring * std::cos(angle), ring * std::sin(angle), 1.0);
    problem.bodies.push_back({1.0, center});
    const Vector3d normal = (top - center).normalized();
    problem.contacts.push_back({0, k + 1, center + normal, normal, 1.0});
  }
  for (int k = 0; k < 3; ++k) {
    const Vector3d& center = problem.bodies[static_cast<std::size_t>(k + 1)].center_of_mass;
    problem.contacts.push_back(
        {k + 1, kFixed, center - Vector3d::UnitZ(), Vector3d::UnitZ(), ground_scale});
  }
  return problem;
}

FourBallThresholds four_ball_thresholds(double ratio) {
  const double half = 0.5 * std::asin(2.0 / std::sqrt(3.0) / (1.0 + ratio));
  const double friction = std::tan(half);
  return {friction, friction / (1.0 + 3.0 / (ratio * ratio * ratio))};
}

}  // namespace stiction::reference
