// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a momentum's change is the sum that audits it: the same velocities summed in rationals.
#include <algorithm>
#include <limits>

#include "reference/exact/exact_momentum.h"
#include "validation/engines/stiction/solver_view.h"
#include "validation/problems/free_boxes.h"

namespace stiction {

namespace {

constexpr double kDuration = 0.06;  // s; the collision takes 10 ms of it

Problem collision() {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.35, Vec3(1.0, 0.6, 0.3).normalized()));
  return free_problem("two free boxes",
                      {free_cube("lower", {-0.013, 0.009, -0.052}, {-0.5, -0.15, 0.5}, 1e-3),
                       free_cube("upper", {0.013, -0.009, 0.075}, {0.5, 0.15, -0.5}, 1e-3, turn)},
                      kDuration);
}

struct Velocities {
  std::vector<double> mass;
  std::vector<Eigen::Vector3d> velocity;
};

// At the end of the last step.
Velocities velocities_of(const Engine& engine) {
  const SolverView view = solver_view(engine);
  Velocities all;
  for (std::size_t k = 0; k < view.scene.mass.size(); ++k) {
    all.mass.push_back(view.scene.mass[k]);
    all.velocity.push_back(view.workspace.velocity[k].v.cast<double>());
  }
  return all;
}

void run_exact(CaseRun& run) {
  constexpr int kSamples = 30;
  const Problem problem = collision();
  const auto simulation = simulate_free(run, problem);
  const Engine& engine = simulation->engine();
  simulation->advance(1);
  const Velocities start = velocities_of(engine);
  const Eigen::Vector3d plain_start = engine.momenta().linear;
  double exact = 0.0, plain = 0.0, apart = 0.0;
  Series changes{"change of the exact sum", "kg m/s", "time", "s", {}, {}};
  for (int k = 1; k <= kSamples; ++k) {
    simulation->advance_to(kDuration * k / kSamples);
    const Velocities now = velocities_of(engine);
    const Eigen::Vector3d change =
        reference::exact_momentum_change(start.mass, start.velocity, now.velocity);
    const Eigen::Vector3d summed = engine.momenta().linear - plain_start;
    exact = std::max(exact, change.norm());
    plain = std::max(plain, summed.norm());
    apart = std::max(apart, (summed - change).norm());
    changes.x.push_back(simulation->time());
    changes.y.push_back(change.norm());
  }
  run.add(changes);
  const double scale = momentum_scale(problem);
  const auto steps = static_cast<double>(engine.steps_done());
  const auto vertices = static_cast<double>(start.mass.size());
  constexpr double kHalfUlp = 0.5 * std::numeric_limits<double>::epsilon();
  run.check(
      {.quantity = "linear momentum, largest change of the exact sum",
       .unit = "kg m/s",
       .statement = "what a collision adds to one body it takes from the other",
       .formula = "Σ m (v(t) − v(0)) = 0, in rationals",
       .source = "Newton's third law",
       .kind = ReferenceKind::kExactComputed,
       .expected = 0.0,
       .relative = true,
       .scale = scale,
       .tolerance = 8.0 * steps * kHalfUlp,
       .reason = "each step rounds each velocity when forces, damping and contacts are added to "
                 "it, by half a unit in the last place, eight times: the worst case, that all "
                 "round the same way"},
      exact);
  run.check({.quantity = "what the plain sum adds to that",
             .unit = "kg m/s",
             .statement = "the audit's own sum is no less exact than what it audits",
             .formula = "|Σ(plain) − Σ(exact)| = 0",
             .source = "[Higham2002], sec. 4.2: |error| ≤ (n − 1) u Σ|xₖ|",
             .kind = ReferenceKind::kExactComputed,
             .expected = 0.0,
             .relative = true,
             .scale = scale,
             .tolerance = 2.0 * vertices * kHalfUlp,
             .reason = "the bound of a sum of as many terms, at the start and now"},
            apart);
  run.show({.quantity = "linear momentum, largest change of the plain sum",
            .unit = "kg m/s",
            .statement = "beside it",
            .formula = "Σ m (v(t) − v(0))",
            .source = "Newton's third law",
            .kind = ReferenceKind::kAnalytic,
            .expected = 0.0,
            .relative = true,
            .scale = scale},
           plain);
}

}  // namespace

std::vector<Case> cases_momentum_exact() {
  return {{.name = "momentum/exact-sum",
           .title = "linear momentum of a collision, summed exactly",
           .suite = "stability",
           .run = run_exact}};
}

}  // namespace stiction
