// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's system (15) solved by GSL on a frozen step: what an iteration can reach at best, and
// how fast the fixed point must converge.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "reference/statistics/nonlinear_system.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/frozen_step.h"

namespace stiction {

namespace {

constexpr double kGain = 0.7;

// Factor by which the slip falls in an iteration of the fixed point on the frozen step: of the
// later half of those before round-off.
double observed_rate(const FrozenStep& frozen, Eigen::VectorXd xi) {
  constexpr int kMost = 400;
  constexpr double kRoundOff = 1e-13;  // m/s
  std::vector<double> left;
  for (int k = 0; k < kMost; ++k) {
    const FrozenStep::Slip slip = frozen.slip_with(xi);
    if (slip.along.norm() < kRoundOff) break;
    left.push_back(slip.along.norm());
    xi += kGain * slip.along.cwiseQuotient(slip.free);
  }
  if (left.size() < 4) return std::nan("");
  const std::size_t last = left.size() - 1, middle = last / 2;
  return std::pow(left[last] / left[middle], 1.0 / static_cast<double>(last - middle));
}

double rms(const Eigen::VectorXd& slip, Eigen::Index contacts) {
  return slip.norm() / std::sqrt(static_cast<double>(contacts));
}

void run_frozen(CaseRun& run, const ComparisonScene& scene) {
  const FrozenStep frozen(run.engine(), scene, run.settings().at("method"));
  const Eigen::Index n = frozen.contacts();
  const reference::System along = [&](const Eigen::VectorXd& xi) -> Eigen::VectorXd {
    return frozen.slip_with(xi).along;
  };
  const reference::System both = [&](const Eigen::VectorXd& xi) -> Eigen::VectorXd {
    const FrozenStep::Slip slip = frozen.slip_with(xi);
    Eigen::VectorXd all(2 * n);
    all << slip.along, slip.across;
    return all;
  };
  const reference::System with_bias = [&](const Eigen::VectorXd& bias) -> Eigen::VectorXd {
    return frozen.slip_with_bias(bias);
  };
  const Eigen::VectorXd learned = frozen.learned();
  const FrozenStep::Slip before = frozen.slip_with(learned);
  const reference::SystemSolution root = reference::solve_system(along, learned, 1e-14);
  const FrozenStep::Slip after = frozen.slip_with(root.x);
  const reference::SystemSolution scalar = reference::solve_least_squares(both, root.x);
  const reference::SystemSolution vector =
      reference::solve_least_squares(with_bias, Eigen::VectorXd::Zero(2 * n));
  // ξ is of order 1 and u nearly linear in it.
  const Eigen::MatrixXd jacobian = reference::jacobian_of(along, root.x, 1e-4);
  const Eigen::MatrixXd map =
      Eigen::MatrixXd::Identity(n, n) + kGain * after.free.cwiseInverse().asDiagonal() * jacobian;
  const double radius = reference::spectral_radius(map);

  run.add(Figure{"contacts", "1", "unknowns of (15)", static_cast<double>(n)});
  run.add(Figure{kLearnedSlip, "m/s", "what the fixed point had left, rms", rms(before.along, n)});
  run.add(Figure{kRootSlip, "m/s", "what GSL leaves of it, largest", root.residual});
  run.add(
      Figure{kAcrossSlip, "m/s", "what no scalar a contact acts on, rms", rms(after.across, n)});
  run.add(Figure{"least slip, N scalars", "m/s", "least squares over ξ of both components, rms",
                 rms(both(scalar.x), n)});
  run.add(Figure{kBiasSlip, "m/s", "least squares over a bias in the tangent plane, rms",
                 rms(with_bias(vector.x), n)});
  run.add(Figure{kDominance, "1", "above 1 the paper's assumption holds",
                 reference::diagonal_dominance(jacobian)});
  run.add(Figure{kPredictedRate, "1", "spectral radius of the fixed point at g = 0.7", radius});
  run.add(Figure{kObservedRate, "1", "factor of the slip in an iteration of it",
                 observed_rate(frozen, learned)});
  run.note(
      fmt::format("GSL: hybrids {} after {} iterations, ξ from {:.3g} to {:.3g}; least squares "
                  "over N {} after {}, over 2N {} after {}",
                  root.outcome, root.iterations, root.x.minCoeff(), root.x.maxCoeff(),
                  scalar.outcome, scalar.iterations, vector.outcome, vector.iterations));
}

}  // namespace

std::vector<Case> comparisons_frozen() {
  std::vector<ComparisonScene> scenes = comparison_scenes();
  scenes.push_back(comparison_plate());
  std::vector<Case> cases;
  for (const ComparisonScene& scene : scenes) {
    cases.push_back({.name = "frozen/" + scene.name,
                     .title = "(15) on a frozen step: " + scene.title,
                     .set = scene.quick ? CaseSet::kQuick : CaseSet::kDefault,
                     .variants = {{{"method", "paper"}, {"rule", "fixed-point"}},
                                  {{"method", "quiet"}, {"rule", "fixed-point"}}},
                     .run = [scene](CaseRun& run) { run_frozen(run, scene); }});
  }
  return cases;
}

}  // namespace stiction
