// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/step_rate.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <limits>
#include <vector>

#include "solver/step.h"
#include "validation/engine/settings.h"
#include "validation/engines/stiction/stiction_method.h"
#include "validation/engines/stiction/stiction_scene.h"

namespace stiction {

namespace {

// Sizes of the disturbance: far above round-off, far below depths (1e-6 m), what gravity brings in
// a step (1e-3 m/s) and friction forces (0.1 N).
constexpr double kPlace = 1e-10, kSpeed = 1e-8, kForce = 1e-6;

// The numbers of a state that a step changes, in units of the disturbance.
class Unknowns {
 public:
  explicit Unknowns(const Scene& scene, const State& rest) : memory_(rest.pair_friction.value) {
    for (std::size_t v = 0; v < rest.velocity.size(); ++v) {
      if (scene.inverse_mass[v] > 0.0) free_.push_back(v);
    }
  }
  Eigen::Index count() const {
    return static_cast<Eigen::Index>(6 * free_.size() + memory_.size());
  }
  void disturb(State& state, Eigen::Index k, double by) const {
    const auto index = static_cast<std::size_t>(k), moving = 3 * free_.size();
    const auto axis = static_cast<int>(index % 3);
    if (index < moving) {
      state.position[free_[index / 3]].x[axis] += by * kPlace;
    } else if (index < 2 * moving) {
      state.velocity[free_[(index - moving) / 3]].v[axis] += by * kSpeed;
    } else {
      state.pair_friction.value[index - 2 * moving] += by * kForce;
    }
  }
  Eigen::VectorXd of(const State& state) const {
    Eigen::VectorXd all(count());
    Eigen::Index k = 0;
    for (const std::size_t v : free_) {
      all.segment<3>(k) = state.position[v].x / kPlace;
      k += 3;
    }
    for (const std::size_t v : free_) {
      all.segment<3>(k) = state.velocity[v].v / kSpeed;
      k += 3;
    }
    for (const double value : state.pair_friction.value) all[k++] = value / kForce;
    return all;
  }

 private:
  std::vector<std::size_t> free_;
  std::vector<double> memory_;
};

}  // namespace

double slowest_rate(const Problem& problem, const Settings& settings, const Snapshot& rest) {
  SettingsReader reader(settings);
  Options options;
  options.time_step = reader.number("dt", options.time_step);
  read_method(reader, options);
  const Scene scene = build_scene(
      scene_description(problem, {.cells = reader.count("cells", Discretisation{}.cells)}));
  check_options(options, scene);
  const State& start = *static_cast<const State*>(rest.get());
  const Unknowns unknowns(scene, start);
  State state;
  Workspace workspace;
  Eigen::MatrixXd jacobian(unknowns.count(), unknowns.count());
  bool same_contacts = true;
  const auto after = [&](Eigen::Index k, double by) -> Eigen::VectorXd {
    state = start;
    unknowns.disturb(state, k, by);
    step(scene, options, state, workspace);
    same_contacts =
        same_contacts && state.pair_friction.value.size() == start.pair_friction.value.size();
    return same_contacts ? unknowns.of(state) : Eigen::VectorXd::Zero(unknowns.count()).eval();
  };
  for (Eigen::Index k = 0; k < jacobian.cols(); ++k) {
    jacobian.col(k) = 0.5 * (after(k, 1.0) - after(k, -1.0));
  }
  if (!same_contacts) return std::numeric_limits<double>::quiet_NaN();
  constexpr double kResolved = 1e-6;
  double slowest = 0.0;
  const Eigen::VectorXcd values = jacobian.eigenvalues();
  for (const std::complex<double>& value : values) {
    if (std::abs(value) < 1.0 - kResolved) slowest = std::max(slowest, std::abs(value));
  }
  return slowest;
}

}  // namespace stiction
