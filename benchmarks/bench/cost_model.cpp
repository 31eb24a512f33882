// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/cost_model.h"

#include "solver/friction/catalog.h"

namespace stiction::bench {

namespace {

// Records, bytes.
constexpr double kVec = sizeof(Vec3);
constexpr double kPosition = sizeof(Position);
constexpr double kVelocity = sizeof(Velocity);
constexpr double kElement = sizeof(Element) + sizeof(ElementConstants);
constexpr double kCorners = sizeof(Element);
constexpr double kPair = sizeof(PairContact), kSite = sizeof(PairSite);
constexpr double kTriangle = sizeof(Topology::Triangle);
constexpr double kMemoryKey = sizeof(ContactKey) + sizeof(ContactStatus);

// Arithmetic of small blocks, in operations.
constexpr double kDot = 5.0;         // of 3-vectors
constexpr double kAxpy = 6.0;        // a x + y
constexpr double kCross = 9.0;       //
constexpr double kProduct3 = 45.0;   // of 3 × 3 matrices
constexpr double kRotation = 140.0;  // closed form: FᵀF, cof F, three Newton steps, factors of R
constexpr double kHooke = 24.0;      // 2μE + λ tr(E) I
constexpr double kBarycentric = 12.0 + 3.0 * (kCross + kDot) + 6.0;
constexpr double kNearest = 6.0 * kDot + 40.0;  // regions of a triangle

struct Counts {
  double vertices, surface, elements, pairs, obstacle, values;
};

Counts counts_of(const Timed& timed, const Workload& work) {
  return {static_cast<double>(work.scene->vertex_count()),
          static_cast<double>(work.scene->surface_vertex.size()),
          static_cast<double>(work.scene->elements.size()),
          static_cast<double>(work.workspace.pairs.size()),
          static_cast<double>(work.workspace.contacts.size()),
          static_cast<double>(friction_rule_values(timed.rule))};
}

ModelledCost of_phase(Phase phase, const Counts& n, bool pairs_possible) {
  // A one-sided contact in its arrays: key, vertex, obstacle, depth, velocity, forces, status.
  constexpr double kOneSided = 8 + 4 + 4 + 8 + kVec + 8 + kVec + 1;
  switch (phase) {
    case Phase::kForces:
      // Position, velocity and force of the vertices pass once; elements are read once.
      // Differences; F, Ḟ, FᵀḞ, F a and P Dₘ⁻ᵀ; R; a and b; sym(FᵀḞ), Hooke's law, β times it; + b;
      // the corners.
      return {n.vertices * (8 + 2 * kVec + kPosition + kVelocity) + n.elements * kElement,
              n.vertices * 3 +
                  n.elements * (18 + 5 * kProduct3 + kRotation + 30 + 18 + kHooke + 18 + 9 + 18)};
    case Phase::kPredict:
      return {n.vertices * (kVec + 2 * kVelocity), n.vertices * (1 + kAxpy)};
    case Phase::kDetect: {
      // Contacts between bodies that last are not looked at.
      const double found = n.obstacle * kOneSided;
      const double all = pairs_possible ? n.vertices * (kPosition + kVelocity + kVec)
                                        : n.surface * (kPosition + kVelocity);
      return {all + found, n.vertices * kAxpy + n.surface * (kAxpy + kDot)};
    }
    case Phase::kDepth:
      return {n.pairs * (2 * kPair + kSite + kTriangle + kCorners + 3 * kVec + 5 * kPosition),
              n.pairs * (kNearest + kCross + 2 * kDot + kBarycentric + 14)};
    case Phase::kNormalForce:
      // Twice over the pairs: loads and forces, then their application to five vertices.
      return {n.pairs * (3 * kPair + 2 * 5 * kVelocity) + n.obstacle * (kOneSided + 2 * kVelocity),
              n.pairs * (5 + 5 + 15 + 4 + 5 * (kAxpy + 2)) + n.obstacle * (3 * kAxpy + kDot)};
    case Phase::kFriction:
      // Memory is carried, forces are warmed, then swept; five vertices twice a contact.
      return {n.pairs * (4 * kPair + 6 * 5 * kVelocity / 2 + 2 * (kMemoryKey + 8 * n.values)) +
                  n.obstacle * (3 * kOneSided + 4 * kVelocity + 2 * (kMemoryKey + 8 * n.values)),
              n.pairs * (2 * (4 * kAxpy + 2 * kDot) + 2 * 5 * (kAxpy + 1) + 40) +
                  n.obstacle * (4 * kDot + 2 * kAxpy + 40)};
    case Phase::kIntegrate:
      return {n.vertices * (kVelocity + 2 * kPosition) + n.pairs * (kSite + 8), n.vertices * kAxpy};
  }
  return {};
}

}  // namespace

ModelledCost modelled_cost(const Timed& timed, const Workload& work) {
  const Counts counts = counts_of(timed, work);
  const bool pairs = work.scene->pairs_possible;
  if (!timed.whole_step) return of_phase(timed.phase, counts, pairs);
  ModelledCost sum;
  for (std::size_t p = 0; p < kPhaseNames.size(); ++p) {
    const ModelledCost cost = of_phase(static_cast<Phase>(p), counts, pairs);
    sum.bytes += cost.bytes;
    sum.flops += cost.flops;
  }
  return sum;
}

}  // namespace stiction::bench
