// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "validation/engines/stiction/solver_view.h"
#include "validation/problems/slopes/slab_problem.h"

namespace stiction {

namespace {

// Largest eigenvalue of Δt² K^½ W K^½: what fraction of a depth the normal forces close in a step.
// W is the contacts' inverse mass matrix along their normals, K = fⁿ/d their stiffness.
double largest_kappa(double dt, const Workspace& workspace) {
  std::vector<const PairContact*> loaded;
  for (const PairContact& contact : workspace.pairs) {
    if (contact.depth > 0.0 && contact.normal_force > 0.0) loaded.push_back(&contact);
  }
  if (loaded.empty()) return 0.0;
  const auto weight_of = [](const PairContact& contact, std::int32_t vertex) {
    double weight = contact.vertex == vertex ? 1.0 : 0.0;
    for (int k = 0; k < 4; ++k) {
      if (contact.partner[k] == vertex) weight -= contact.weight[k];
    }
    return weight;
  };
  const auto count = static_cast<Eigen::Index>(loaded.size());
  Eigen::MatrixXd kappa(count, count);
  for (Eigen::Index a = 0; a < count; ++a) {
    const PairContact& one = *loaded[static_cast<std::size_t>(a)];
    std::vector<std::int32_t> touched(one.partner, one.partner + 4);
    touched.push_back(one.vertex);
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (Eigen::Index b = 0; b < count; ++b) {
      const PairContact& other = *loaded[static_cast<std::size_t>(b)];
      double mobility = 0.0;
      for (const std::int32_t v : touched) {
        mobility += weight_of(one, v) * weight_of(other, v) *
                    workspace.velocity[static_cast<std::size_t>(v)].inverse_mass;
      }
      kappa(a, b) = dt * dt * mobility * one.normal.dot(other.normal) *
                    std::sqrt(one.normal_force / one.depth * other.normal_force / other.depth);
    }
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(kappa, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

// Vertices of one body inside a tetrahedron of the other, at the predicted positions of the last
// step, that have no contact: each vertex near the other body against each of its tetrahedra.
int overlooked(const Scene& scene, const Workspace& workspace) {
  constexpr double kInside = 1e-9;  // of a weight: far above round-off, far below any depth
  const std::vector<Vec3>& x = workspace.search.predicted;
  const Topology& topology = scene.topology;
  const auto at = [&](std::int32_t v) -> const Vec3& { return x[static_cast<std::size_t>(v)]; };
  const std::size_t bodies = topology.body_triangle_begin.size() - 1;
  std::vector<Eigen::AlignedBox3d> box(bodies);
  for (std::size_t v = 0; v < x.size(); ++v) {
    box[static_cast<std::size_t>(topology.vertex_body[v])].extend(x[v]);
  }
  int count = 0;
  for (std::size_t v = 0; v < x.size(); ++v) {
    const auto own = topology.vertex_body[v];
    const bool found = std::any_of(
        workspace.pairs.begin(), workspace.pairs.end(),
        [&](const PairContact& contact) { return contact.vertex == static_cast<std::int32_t>(v); });
    if (found || !box[own == 0 ? 1 : 0].contains(x[v])) continue;
    for (std::size_t e = 0; e < scene.elements.size(); ++e) {
      if (topology.element_body[e] == own) continue;
      const auto& corner = scene.elements[e].vertex;
      Eigen::Matrix3d edges;
      for (int k = 0; k < 3; ++k) edges.col(k) = at(corner[k + 1]) - at(corner[0]);
      const Vec3 weight = edges.inverse() * (x[v] - at(corner[0]));
      if (std::min(weight.minCoeff(), 1.0 - weight.sum()) > kInside) {
        ++count;
        break;
      }
    }
  }
  return count;
}

void run_kappa(CaseRun& run, const SlabSetup& setup) {
  SlabRun slab(run, setup);
  // κ needs each contact's partners and weights, which no engine shows.
  const auto [scene, options, workspace] = solver_view(slab.engine());
  Series kappa{"largest κ", "1", "time", "s", {}, {}};
  double largest = 0.0;
  int changes = 0;
  int unseen = 0;
  std::size_t loaded_before = 0;
  const int steps = static_cast<int>(1.5 / options.time_step);
  for (int k = 1; k <= steps; ++k) {
    slab.engine().advance(1);
    const double time = k * options.time_step;
    unseen += overlooked(scene, workspace);
    if (time < 0.05) continue;  // hardly any weight yet
    std::size_t loaded = 0;
    for (const PairContact& contact : workspace.pairs) loaded += contact.depth > 0.0;
    if (time > 1.0 && loaded != loaded_before) ++changes;
    loaded_before = loaded;
    if (k % 50 != 0) continue;
    kappa.x.push_back(time);
    kappa.y.push_back(largest_kappa(options.time_step, workspace));
    largest = std::max(largest, kappa.y.back());
  }
  const double bound =
      options.pairs.gain == NormalGain::kHarmonic ? options.pairs.harmonic_gain : 1;
  run.check({.quantity = "largest κ above its bound",
             .unit = "1",
             .statement = "no depth is closed by more than its whole in a step",
             .formula = "max(0, κ_max − κ₀) = 0, with κ₀ = 1 for the paper's gain",
             .source = "derived: z² − 2(1 − κ)z + (1 − κ) = 0 alternates for κ > 1",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-12,
             .reason = "round-off of an eigenvalue of order one, some thousand roundings"},
            std::max(0.0, largest - bound));
  run.check({.quantity = "vertices inside the other body without a contact",
             .unit = "1",
             .statement = "no vertex that is inside a body is without its contact in any step",
             .formula = "in a tetrahedron of the other body, all weights above 1e-9 ⇒ a contact",
             .source = "every vertex against every tetrahedron, by matrix inversion",
             .kind = ReferenceKind::kExactComputed,
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "a count; weights that round-off could turn are left out"},
            static_cast<double>(unseen));
  run.note(
      fmt::format("κ_max {:.6f} (bound {:.2f}, limit of stability 1.333); loaded contacts come "
                  "or go in {} of {:.0f} steps between 1 s and 1.5 s",
                  largest, bound, changes, 0.5 / options.time_step));
  run.add(std::move(kappa));
}

}  // namespace

std::vector<Case> cases_slab_kappa() {
  const SlabSetup setup = slab_at_20_degrees();
  return {{.name = "slab/kappa",
           .title = "fraction of the depth closed in a step, measured beside its bound",
           .variants = {{{"method", "paper"}},
                        {{"method", "quiet"}},
                        {{"method", "quiet"}, {"kappa", "0.7"}}},
           .run = [setup](CaseRun& run) { run_kappa(run, setup); }}};
}

}  // namespace stiction
