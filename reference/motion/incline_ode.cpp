// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/incline_ode.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace stiction::reference {

namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon();

template <auto release>
struct Releaser {
  template <typename T>
  void operator()(T* pointer) const {
    release(pointer);
  }
};
using Step = std::unique_ptr<gsl_odeiv2_step, Releaser<gsl_odeiv2_step_free>>;
using Control = std::unique_ptr<gsl_odeiv2_control, Releaser<gsl_odeiv2_control_free>>;
using Evolve = std::unique_ptr<gsl_odeiv2_evolve, Releaser<gsl_odeiv2_evolve_free>>;
using RootSolver = std::unique_ptr<gsl_root_fsolver, Releaser<gsl_root_fsolver_free>>;

// GSL is C: no exception may pass through it, and its solvers abort on a value that is not finite.
// So a failure is kept here, answered with a harmless root, and thrown when GSL has returned.
struct RootFunction {
  const std::function<double(double)>* function;
  std::exception_ptr failure;

  static double evaluate(double argument, void* self_pointer) noexcept {
    RootFunction& self = *static_cast<RootFunction*>(self_pointer);
    try {
      return (*self.function)(argument);
    } catch (...) {
      self.failure = std::current_exception();
      return 0.0;
    }
  }
};

// Brent's method [Brent1973] on a function of opposite signs at the ends. Returns the ends between
// which the sign changes, `width` apart at most unless rounding forbids it. Ends of the same sign
// mean that the root is within rounding of the upper one.
std::pair<double, double> bracket_root(const std::function<double(double)>& function, double lower,
                                       double upper, double width) {
  if ((function(lower) > 0.0) == (function(upper) > 0.0)) return {upper, upper};
  RootFunction root{&function, nullptr};
  gsl_function gsl{&RootFunction::evaluate, &root};
  const RootSolver solver(gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  gsl_root_fsolver_set(solver.get(), &gsl, lower, upper);
  // Brent needs at most about log2² of the ratio of the widths; 400 leaves room for jumps.
  for (int iteration = 0; iteration < 400 && !root.failure; ++iteration) {
    lower = gsl_root_fsolver_x_lower(solver.get());
    upper = gsl_root_fsolver_x_upper(solver.get());
    if (upper - lower <= width) break;
    gsl_root_fsolver_iterate(solver.get());
  }
  if (root.failure) std::rethrow_exception(root.failure);
  return {lower, upper};
}

double finite(double value, const char* what) {
  if (!std::isfinite(value)) throw std::runtime_error(std::string(what) + " is not finite.");
  return value;
}

// State and phase of the motion, between two breakpoints at a time.
class Motion {
 public:
  Motion(const FrictionalLoads& loads, const PointState& initial, double duration,
         const FrictionalOdeOptions& options)
      : loads_(loads),
        state_{initial.position, initial.velocity},
        resolution_(2.0 * kRounding * duration),
        maximum_events_(options.maximum_events),
        step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2)),
        probe_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2)),
        control_(gsl_odeiv2_control_standard_new(options.absolute_tolerance,
                                                 options.relative_tolerance, 1.0, 1.0)),
        evolve_(gsl_odeiv2_evolve_alloc(2)) {}

  // Loads are evaluated in [first, last] only: from the right at a breakpoint that starts the
  // segment, from the left at one that ends it.
  void start_segment(double last) {
    last_ = last;
    if (time_ == 0.0) {
      sticking_ = state_[1] == 0.0 && excess(0.0) <= 0.0;
      if (!sticking_) start_slip(state_[1] != 0.0 ? state_[1] : tangential(0.0));
    }
    restart_steps();  // the integrator must not reuse a derivative from before a jump
  }

  void advance(double target) {
    while (time_ < target) sticking_ ? advance_stick(target) : advance_slip(target);
  }

  FrictionalSample sample() const { return {time_, state_[0], state_[1], sticking_}; }
  std::vector<FrictionalEvent> take_events() { return std::move(events_); }

 private:
  // a_t(t, x, 0) at the present position
  double tangential(double time) const {
    return finite(loads_.tangential(std::min(time, last_), state_[0], 0.0), "The tangential load");
  }

  // |a_t| − μ a_n at the present position: positive where stick is impossible. The threshold itself
  // must stick, so the bound is raised by the roundings of two products, 4 ε.
  double excess(double time) const {
    const double t = std::min(time, last_);
    const double press = std::max(0.0, finite(loads_.normal(t, state_[0], 0.0), "The normal load"));
    return std::abs(tangential(time)) - loads_.friction * press * (1.0 + 4.0 * kRounding);
  }

  // v̇ = a_t − μ a_n s, with the slip direction s kept through the step: smooth even past v = 0.
  double slip_acceleration(double time, double x, double v) const {
    const double t = std::min(time, last_);
    const double press = std::max(0.0, finite(loads_.normal(t, x, v), "The normal load"));
    return finite(loads_.tangential(t, x, v), "The tangential load") -
           direction_ * loads_.friction * press;
  }

  static int derivative(double t, const double y[], double dydt[], void* self_pointer) noexcept {
    Motion& self = *static_cast<Motion*>(self_pointer);
    try {
      dydt[0] = y[1];
      dydt[1] = self.slip_acceleration(t, y[0], y[1]);
      return GSL_SUCCESS;
    } catch (...) {
      self.failure_ = std::current_exception();
      return GSL_EBADFUNC;
    }
  }

  void check(int status) const {
    if (failure_) std::rethrow_exception(failure_);
    if (status != GSL_SUCCESS) {
      throw std::runtime_error(std::string("GSL's integration of a slip failed: ") +
                               gsl_strerror(status) + ".");
    }
  }

  void record(FrictionalEventKind kind) {
    if (events_.size() >= maximum_events_) {
      throw std::runtime_error("More stick and slip events than the maximum asked for.");
    }
    events_.push_back({kind, time_, state_[0]});
  }

  void start_slip(double towards) {
    sticking_ = false;
    direction_ = towards < 0.0 ? -1.0 : 1.0;
    restart_steps();
  }

  void restart_steps() {
    step_size_ = std::numeric_limits<double>::infinity();  // the error control shortens it
    gsl_odeiv2_evolve_reset(evolve_.get());
    gsl_odeiv2_step_reset(step_.get());
  }

  void advance_stick(double target) {
    if (excess(time_) <= 0.0) {
      if (excess(target) <= 0.0) {
        time_ = target;
        return;
      }
      // The upper end, where the bound is exceeded: slip then starts with a push, however small.
      time_ =
          bracket_root([this](double t) { return excess(t); }, time_, target, resolution_).second;
    }
    record(FrictionalEventKind::kStickToSlip);
    start_slip(tangential(time_));
  }

  // The state after a part of the last step, by one step of the same method: its error is below
  // that of the accepted step.
  std::pair<double, double> part(const double start[2], double start_time, double length) {
    double y[2] = {start[0], start[1]};
    double error[2];
    gsl_odeiv2_system system{&derivative, nullptr, 2, this};
    check(gsl_odeiv2_step_apply(probe_.get(), start_time, length, y, error, nullptr, nullptr,
                                &system));
    return {y[0], y[1]};
  }

  void advance_slip(double target) {
    const double start_time = time_;
    const double start[2] = {state_[0], state_[1]};
    gsl_odeiv2_system system{&derivative, nullptr, 2, this};
    double size = std::min(step_size_, target - time_);
    check(gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(), &system, &time_,
                                  target, &size, state_));
    step_size_ = size;
    const double length = time_ - start_time;
    const auto speed = [&](double tau) { return direction_ * part(start, start_time, tau).second; };
    const auto push = [&](double tau) {
      const auto [x, v] = part(start, start_time, tau);
      return direction_ * slip_acceleration(start_time + tau, x, v);
    };

    double end = length;
    if (direction_ * state_[1] > 0.0) {
      // v may have dipped below zero and come back within the step: look at its minimum.
      if (!(start[1] != 0.0 && push(0.0) < 0.0 && push(length) > 0.0)) return;
      end = bracket_root(push, 0.0, length, resolution_).second;
      if (speed(end) > 0.0) return;
    } else if (start[1] == 0.0) {
      // Slip has started and ended within the step: a shorter one shows the two zeros apart.
      time_ = start_time;
      std::copy(start, start + 2, state_);
      start_slip(direction_);
      step_size_ = length / 4.0;
      if (step_size_ < resolution_) rest(start[0]);
      return;
    }
    const double stop = bracket_root(speed, 0.0, end, resolution_).second;
    time_ = start_time + stop;
    rest(part(start, start_time, stop).first);
  }

  // The velocity has come to zero: stick if friction can hold, else slip in the other direction.
  void rest(double position) {
    state_[0] = position;
    state_[1] = 0.0;
    sticking_ = excess(time_) <= 0.0;
    record(sticking_ ? FrictionalEventKind::kSlipToStick : FrictionalEventKind::kReversal);
    if (!sticking_) start_slip(tangential(time_));
  }

  const FrictionalLoads& loads_;
  double time_ = 0.0;  // s
  double last_ = 0.0;  // latest time at which the loads of this segment hold, s
  double state_[2];    // x, m, and v, m/s
  bool sticking_ = false;
  double direction_ = 1.0;  // of slip: ±1
  double step_size_ = 0.0;  // that the error control proposes, s
  double resolution_;       // of event times, s
  std::size_t maximum_events_;
  std::vector<FrictionalEvent> events_;
  std::exception_ptr failure_;
  Step step_;
  Step probe_;
  Control control_;
  Evolve evolve_;
};

void check_input(const FrictionalLoads& loads, const PointState& initial, double duration,
                 const FrictionalOdeOptions& options) {
  critical_tangent(loads.friction);  // refuses a bad μ
  if (!loads.tangential || !loads.normal) {
    throw std::invalid_argument("Both the tangential and the normal load must be given.");
  }
  if (!std::isfinite(initial.position) || !std::isfinite(initial.velocity)) {
    throw std::invalid_argument("The initial state must be finite.");
  }
  if (!(duration > 0.0) || !std::isfinite(duration)) {
    throw std::invalid_argument("The duration must be finite and positive.");
  }
  if (!(options.sample_interval > 0.0)) {
    throw std::invalid_argument("The sample interval must be positive.");
  }
  if (!(options.relative_tolerance >= 0.0) || !(options.absolute_tolerance >= 0.0) ||
      !(options.relative_tolerance + options.absolute_tolerance > 0.0)) {
    throw std::invalid_argument("The tolerances must not be negative, and one must be positive.");
  }
  for (const double breakpoint : loads.breakpoints) {
    if (!std::isfinite(breakpoint)) throw std::invalid_argument("A breakpoint must be finite.");
  }
}

}  // namespace

// a_t = g sin θ,  a_n = g cos θ
FrictionalLoads incline_loads(const Incline& incline) {
  sticks(incline);  // refuses a bad incline
  const double tangential = incline.gravity * std::sin(incline.angle);
  const double normal = incline.gravity * std::cos(incline.angle);
  return {.tangential = [tangential](double, double, double) { return tangential; },
          .normal = [normal](double, double, double) { return normal; },
          .friction = incline.friction,
          .breakpoints = {}};
}

FrictionalMotion integrate_frictional_motion(const FrictionalLoads& loads,
                                             const PointState& initial, double duration,
                                             const FrictionalOdeOptions& options) {
  check_input(loads, initial, duration, options);
  std::vector<double> ends;
  for (const double breakpoint : loads.breakpoints) {
    if (breakpoint > 0.0 && breakpoint < duration) ends.push_back(breakpoint);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  ends.push_back(std::numeric_limits<double>::infinity());

  Motion motion(loads, initial, duration, options);
  FrictionalMotion result;
  std::size_t sample = 0;
  for (const double end : ends) {
    motion.start_segment(std::nextafter(end, 0.0));
    if (sample == 0) result.samples.push_back(motion.sample());
    sample = std::max<std::size_t>(sample, 1);
    for (;; ++sample) {
      const double next = static_cast<double>(sample) * options.sample_interval;
      // A last sample closer to the duration than rounding is the duration's own.
      const bool is_last = next >= duration * (1.0 - 4.0 * kRounding);
      const double target = is_last ? duration : next;
      if (target > end) {
        motion.advance(end);
        break;
      }
      motion.advance(target);
      result.samples.push_back(motion.sample());
      if (is_last) break;
    }
  }
  result.events = motion.take_events();
  return result;
}

}  // namespace stiction::reference
