// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/membrane.h"

#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "reference/statistics/gsl_errors.h"

namespace stiction::reference {

namespace {

constexpr double kRelative = 1e-12;

void demand_of_membrane(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("membrane: " + what);
}

/// The root of f in [low, high] by Brent's method, to the last bits. f(low) f(high) ≤ 0.
template <class F>
double root(F f, double low, double high) {
  if (f(low) == 0.0) return low;
  if (f(high) == 0.0) return high;
  gsl_function function;
  function.function = [](double x, void* self) { return (*static_cast<F*>(self))(x); };
  function.params = &f;
  const std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  gsl_root_fsolver_set(solver.get(), &function, low, high);
  for (int k = 0; k < 200; ++k) {
    gsl_root_fsolver_iterate(solver.get());
    const double a = gsl_root_fsolver_x_lower(solver.get());
    const double b = gsl_root_fsolver_x_upper(solver.get());
    if (gsl_root_test_interval(a, b, 0.0, 1e-15) == GSL_SUCCESS) break;
  }
  return gsl_root_fsolver_root(solver.get());
}

/// How far the tension on the left of the box exceeds what friction can hold, for a trial pull F:
/// H_l/cos α_l − e^{μ (α_l − α_r)} H_r/cos α_r.
double excess_tension(const MembraneProblem& p, double s, double pull) {
  const double rest = p.length - s;
  const double left = p.tension + pull * rest / p.length;
  const double right = p.tension - pull * s / p.length;
  const double sag = (p.box_load + 0.5 * p.own_load * p.length) * s * rest /
                     (p.tension * p.length + pull * (p.length - 2.0 * s));
  const double slope_left = sag / s - 0.5 * p.own_load * s / left;
  const double slope_right = -sag / rest + 0.5 * p.own_load * rest / right;
  const double turn = std::atan(slope_left) - std::atan(slope_right);
  return left * std::hypot(1.0, slope_left) -
         std::exp(p.friction * turn) * right * std::hypot(1.0, slope_right);
}

double full_pull(const MembraneProblem& p, double s) {
  // Between a pull uphill that no slope calls for and the pull at which the lower part goes slack.
  const double low = -0.999 * p.tension * p.length / (p.length - s);
  const double high = 0.999 * p.tension * p.length / s;
  // Outwards from the linear law, so that the bracket holds the root that continues it.
  double reach = p.box_load * (0.1 + p.friction);
  for (; reach < high - low; reach *= 2.0) {
    const double a = std::max(low, p.friction * p.box_load - reach);
    const double b = std::min(high, p.friction * p.box_load + reach);
    const auto excess = [&](double pull) { return excess_tension(p, s, pull); };
    if (a < b && excess(a) <= 0.0 && excess(b) >= 0.0) return root(excess, a, b);
  }
  throw std::domain_error("membrane: friction would slacken the membrane; no quasi-static shape");
}

double acceleration(const MembraneProblem& p, MembraneLaw law, double s) {
  if (law == MembraneLaw::linear) {
    const double center =
        0.5 * p.length +
        p.gravity * (std::sin(p.slope) - p.friction * std::cos(p.slope)) / membrane_stiffness(p);
    return membrane_stiffness(p) * (center - s);
  }
  return p.gravity * (std::sin(p.slope) - std::cos(p.slope) * full_pull(p, s) / p.box_load);
}

struct Event {
  MembraneEnd end;
  double time;  ///< since the start of the stretch, s
};

/// One integration from a state; a new one for each call, so that calls don't depend on each other.
class Integrator {
 public:
  Integrator(const MembraneProblem& problem, MembraneLaw law) : problem_(problem), law_(law) {}

  /// State {s, v} after `duration`.
  void advance(double (&state)[2], double duration) {
    if (duration <= 0.0) return;
    gsl_odeiv2_system system{&Integrator::derivative, nullptr, 2, this};
    const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, duration,
                                      kRelative * problem_.length, kRelative),
        gsl_odeiv2_driver_free);
    double time = 0.0;
    const int status = gsl_odeiv2_driver_apply(driver.get(), &time, duration, state);
    if (error_) std::rethrow_exception(error_);
    if (status != GSL_SUCCESS) {
      throw std::domain_error(std::string("membrane: ") + gsl_strerror(status));
    }
  }

  /// Advances by `duration`, or to what comes first: v = 0 or the lower end.
  Event advance_to_event(double (&state)[2], double duration) {
    const double before[2] = {state[0], state[1]};
    advance(state, duration);
    // Time at which v or ℓ − s, positive before, reaches zero; the duration if it doesn't.
    const auto crossing = [&](int component) {
      const auto value = [&](double time) {
        double trial[2] = {before[0], before[1]};
        advance(trial, time);
        return component == 1 ? trial[1] : problem_.length - trial[0];
      };
      // From rest v grows at first: the bracket begins a moment later.
      return root(value, before[component] == 0.0 ? 1e-6 * duration : 0.0, duration);
    };
    const bool rests = state[1] <= 0.0;
    const bool leaves = state[0] >= problem_.length;
    if (!rests && !leaves) return {MembraneEnd::moves, duration};
    const double rest_time = rests ? crossing(1) : duration;
    const double leave_time = leaves ? crossing(0) : duration;
    const bool first_rests = rests && (!leaves || rest_time <= leave_time);
    const double time = first_rests ? rest_time : leave_time;
    state[0] = before[0];
    state[1] = before[1];
    advance(state, time);
    (first_rests ? state[1] : state[0]) = first_rests ? 0.0 : problem_.length;
    return {first_rests ? MembraneEnd::stops : MembraneEnd::leaves, time};
  }

 private:
  /// Off the span, where a trial step may look, the law of its end goes on.
  static int derivative(double, const double y[], double dydt[], void* self) {
    auto& me = *static_cast<Integrator*>(self);
    const double margin = 1e-9 * me.problem_.length;
    const double s = std::fmin(std::fmax(y[0], margin), me.problem_.length - margin);
    dydt[0] = y[1];
    try {
      dydt[1] = acceleration(me.problem_, me.law_, s);
    } catch (const std::exception&) {
      me.error_ = std::current_exception();  // must not fly through C
      return GSL_EBADFUNC;
    }
    return GSL_SUCCESS;
  }

  const MembraneProblem& problem_;
  MembraneLaw law_;
  std::exception_ptr error_;
};

}  // namespace

std::string MembraneProblem::check() const {
  if (!(tension > 0.0)) return "the tension must be positive";
  if (!(length > 0.0)) return "the length must be positive";
  if (!(own_load >= 0.0)) return "the own load must not be negative";
  if (!(box_load > 0.0)) return "the box's load must be positive";
  if (!(gravity > 0.0)) return "gravity must be positive";
  if (!(slope >= 0.0 && slope < 0.5 * std::numbers::pi)) return "the slope must lie in [0, π/2)";
  if (!(friction >= 0.0)) return "the friction coefficient must not be negative";
  if (!(start > 0.0 && start < length)) return "the start must lie on the span";
  if (!(speed >= 0.0)) return "the speed must not be negative: downhill only";
  for (const double x : {tension, length, own_load, box_load, gravity, friction, speed}) {
    if (!std::isfinite(x)) return "every value must be finite";
  }
  return {};
}

double membrane_stiffness(const MembraneProblem& p) {
  return p.gravity * std::cos(p.slope) * (1.0 + p.friction * p.friction) *
         (p.box_load / p.length + p.own_load) / p.tension;
}

double membrane_stop(const MembraneProblem& p) {
  const double kappa = membrane_stiffness(p);
  const double drive = p.gravity * (std::sin(p.slope) - p.friction * std::cos(p.slope));
  const double center = 0.5 * p.length + drive / kappa;
  if (p.speed == 0.0 && p.start >= center) return p.start;
  return center + std::hypot(center - p.start, p.speed / std::sqrt(kappa));
}

double membrane_acceleration(const MembraneProblem& problem, MembraneLaw law, double position) {
  if (const std::string wrong = problem.check(); !wrong.empty()) demand_of_membrane(false, wrong);
  demand_of_membrane(position > 0.0 && position < problem.length, "the position lies off the span");
  quiet_gsl();
  return acceleration(problem, law, position);
}

MembraneMotion membrane_motion(const MembraneProblem& problem, MembraneLaw law, double duration,
                               int intervals) {
  if (const std::string wrong = problem.check(); !wrong.empty()) demand_of_membrane(false, wrong);
  demand_of_membrane(duration > 0.0 && std::isfinite(duration),
                     "the duration must be positive and finite");
  demand_of_membrane(intervals >= 1, "there must be an interval at least");

  quiet_gsl();
  Integrator integrator(problem, law);
  const double mass = problem.box_load / (problem.gravity * std::cos(problem.slope));
  MembraneMotion motion;
  double state[2] = {problem.start, problem.speed};
  const auto record = [&](double time) {
    motion.samples.push_back({time, state[0], state[1], 0.5 * mass * state[1] * state[1]});
  };
  record(0.0);
  bool under_way = true;
  if (problem.speed == 0.0 && acceleration(problem, law, problem.start) <= 0.0) {
    motion.end = MembraneEnd::stops;
    under_way = false;
  }
  // The state after a stretch no longer than a twelfth of the oscillator's period, so that v can't
  // change sign twice within it.
  const int parts = static_cast<int>(
      std::ceil(2.0 * duration / intervals * std::sqrt(membrane_stiffness(problem))));
  const double stretch = duration / intervals / std::max(parts, 1);
  double time = 0.0;
  for (int k = 1; k <= intervals; ++k) {
    for (int part = 0; part < std::max(parts, 1) && under_way; ++part) {
      const Event event = integrator.advance_to_event(state, stretch);
      time += event.time;
      under_way = event.end == MembraneEnd::moves;
      motion.end = event.end;
    }
    record(duration * k / intervals);
    if (motion.end == MembraneEnd::leaves) break;
  }
  motion.end_time = motion.end == MembraneEnd::moves ? duration : time;
  motion.end_position = state[0];
  return motion;
}

}  // namespace stiction::reference
