// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/time_step_limit.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "solver/elasticity/corotational.h"
#include "solver/observables.h"
#include "solver/step.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

using MatrixX = Eigen::MatrixXd;
using VectorX = Eigen::VectorXd;

// ---- of an element, against brute force and against what really happens -------------------------

// A tetrahedron without symmetry.
TetMesh skew_tetrahedron() {
  TetMesh mesh = test::corner_tetrahedron(0.1);
  mesh.vertices += test::noise(4, 0.02, 7);
  return mesh;
}

// Stiffness matrix of linear tetrahedra from the index form of isotropic elasticity,
//   K_{ai,bj} = V (λ gₐᵢ g_bⱼ + μ gₐⱼ g_bᵢ + μ δᵢⱼ gₐ·g_b),   g the gradients of the shape
//   functions:
// the slow twin of the six strain modes that element_time_step_limit works with.
MatrixX stiffness(const TetMesh& mesh, const Material& material) {
  const double e = material.youngs_modulus;
  const double nu = material.poisson_ratio;
  const double mu = e / (2.0 * (1.0 + nu));
  const double lambda = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  MatrixX k = MatrixX::Zero(mesh.vertices.size(), mesh.vertices.size());
  for (Eigen::Index t = 0; t < mesh.tetrahedra.cols(); ++t) {
    const Eigen::Vector4i corner = mesh.tetrahedra.col(t);
    Mat3 edges;
    for (int a = 0; a < 3; ++a) {
      edges.col(a) = mesh.vertices.col(corner[a + 1]) - mesh.vertices.col(corner[0]);
    }
    Eigen::Matrix<double, 3, 4> g;
    g.rightCols<3>() = edges.inverse().transpose();
    g.col(0) = -g.rightCols<3>().rowwise().sum();
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        k.block<3, 3>(3 * corner[a], 3 * corner[b]) +=
            signed_volume(mesh, t) *
            (lambda * g.col(a) * g.col(b).transpose() + mu * g.col(b) * g.col(a).transpose() +
             mu * g.col(a).dot(g.col(b)) * Mat3::Identity());
      }
    }
  }
  return k;
}

struct StiffestMode {
  double omega;   // rad/s
  VectorX shape;  // three coordinates a vertex
};

StiffestMode stiffest_mode(const TetMesh& mesh, const Material& material) {
  const double mass = material.density * signed_volume(mesh, 0) / 4.0;
  const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(stiffness(mesh, material) / mass);
  return {std::sqrt(eigen.eigenvalues()[11]), eigen.eigenvectors().col(11)};
}

struct Stiff {
  std::string name;
  Material material;
};

void PrintTo(const Stiff& stiff, std::ostream* out) { *out << stiff.name; }

const auto kMaterials = testing::Values(Stiff{"Undamped", {1000.0, 1e6, 0.3, 0.0}},
                                        Stiff{"LightlyDamped", {1000.0, 1e6, 0.3, 1e-4}},
                                        Stiff{"HeavilyDamped", {500.0, 5e5, 0.45, 1e-2}},
                                        Stiff{"NegativePoissonRatio", {1000.0, 1e6, -0.5, 0.0}});

class ElementTimeStepLimit : public testing::TestWithParam<Stiff> {};

TEST_P(ElementTimeStepLimit, AgreesWithTheTwelveByTwelveEigenvalueProblem) {
  const TetMesh mesh = skew_tetrahedron();
  const Material& material = GetParam().material;
  const double beta = material.damping_time;
  const double omega = stiffest_mode(mesh, material).omega;
  const double expected = std::sqrt(beta * beta + 4.0 / (omega * omega)) - beta;
  // Eigenvalues are good to the matrix's size times ε; the difference of the root and β loses
  // (β + limit)/limit of it.
  const double round_off = 100.0 * test::kEpsilon * (expected + beta);
  EXPECT_NEAR(element_time_step_limit(mesh, 0, material), expected, round_off);
}

// Largest |amplitude| of the mode over some steps, in units of its first, by symplectic Euler on it
// alone:   v' = v − Δt ω²(x + β v),   x' = x + Δt v'.
double predicted_amplitude(double dt, double omega, double beta, int steps) {
  double x = 1.0;
  double v = 0.0;
  double largest = 0.0;
  for (int n = 0; n < steps; ++n) {
    v -= dt * omega * omega * (x + beta * v);
    x += dt * v;
    largest = std::max(largest, std::abs(x));
  }
  return largest;
}

// The same of the whole step on a tetrahedron that starts in this mode.
double simulated_amplitude(const TetMesh& mesh, const Material& material, double dt, int steps) {
  const StiffestMode mode = stiffest_mode(mesh, material);
  const Scene scene = build_scene(test::one_body(test::elastic_body(mesh, material)));
  State state = initial_state(scene);
  const double amplitude = 1e-9;  // m
  const auto position = [&](int k) -> Vec3& {
    const int place = scene.scene_vertex[static_cast<std::size_t>(k)];
    return state.position[static_cast<std::size_t>(place)].x;
  };
  for (int k = 0; k < 4; ++k) position(k) += amplitude * mode.shape.segment<3>(3 * k);
  const Options options{.time_step = dt, .rule = "none"};
  Workspace workspace;
  double largest = 0.0;
  for (int n = 0; n < steps; ++n) {
    step(scene, options, state, workspace);
    double projection = 0.0;
    for (int k = 0; k < 4; ++k) {
      projection += mode.shape.segment<3>(3 * k).dot(position(k) - mesh.vertices.col(k));
    }
    largest = std::max(largest, std::abs(projection));
  }
  return largest / amplitude;
}

TEST_P(ElementTimeStepLimit, KeepsTheStiffestModeBoundedBelowIt) {
  const TetMesh mesh = skew_tetrahedron();
  const double limit = element_time_step_limit(mesh, 0, GetParam().material);
  // An undamped mode at ωΔt/2 = 0.98 swings up to 1/√(1 − 0.98²) = 5.03 times its start; damping
  // only lowers that.
  EXPECT_LT(simulated_amplitude(mesh, GetParam().material, 0.98 * limit, 20000), 5.1);
}

TEST_P(ElementTimeStepLimit, IsWhereTheStiffestModeBlowsUp) {
  const TetMesh mesh = skew_tetrahedron();
  const Material& material = GetParam().material;
  const double dt = 1.05 * element_time_step_limit(mesh, 0, material);
  const double omega = stiffest_mode(mesh, material).omega;
  int steps = 1;
  while (predicted_amplitude(dt, omega, material.damping_time, steps) < 1e3) {
    ASSERT_LT(++steps, 1000) << "it must grow";
  }
  // At 1e3 × 1e-9 m strains are 1e-5 and more of the 0.1 m edges, and the law is linear to as much;
  // 1e-7 of the first amplitude is round-off of the positions.
  const double predicted = predicted_amplitude(dt, omega, material.damping_time, steps);
  EXPECT_NEAR(simulated_amplitude(mesh, material, dt, steps), predicted, 1e-3 * predicted);
}

INSTANTIATE_TEST_SUITE_P(Materials, ElementTimeStepLimit, kMaterials,
                         [](const auto& one) { return one.param.name; });

// ---- of a body -----------------------------------------------------------------------------------

double limit_of(double omega2, double beta) { return std::sqrt(beta * beta + 4.0 / omega2) - beta; }

// The largest stable step of the whole body at rest, by all its modes.
double true_limit(const BodyDescription& body) {
  const Scene scene = build_scene(test::one_body(body));
  MatrixX k = stiffness(body.mesh, body.material);
  for (Eigen::Index i = 0; i < k.rows(); ++i) {
    const auto vertex =
        static_cast<std::size_t>(scene.scene_vertex[static_cast<std::size_t>(i / 3)]);
    k.row(i) *= std::sqrt(scene.inverse_mass[vertex]);
    k.col(i) *= std::sqrt(scene.inverse_mass[vertex]);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(k, Eigen::EigenvaluesOnly);
  return limit_of(eigen.eigenvalues().maxCoeff(), body.material.damping_time);
}

double of_elements(const BodyDescription& body) {
  double smallest = test::kInfinity;
  for (Eigen::Index e = 0; e < body.mesh.tetrahedra.cols(); ++e) {
    smallest = std::min(smallest, element_time_step_limit(body.mesh, e, body.material));
  }
  return smallest;
}

BodyDescription jagged_cube(int cells, const Material& material) {
  BodyDescription body = test::elastic_body(test::cube_mesh(cells), material);
  body.mesh.vertices += test::noise(body.mesh.vertices.cols(), 0.1 / cells, 5);
  return body;
}

class BodyTimeStepLimitOf : public testing::TestWithParam<Stiff> {};

TEST_P(BodyTimeStepLimitOf, IsThatOfAllModes) {
  for (const int cells : {1, 2, 3, 5}) {
    BodyDescription body = jagged_cube(cells, GetParam().material);
    for (const int pinned : {0, 1, 4}) {
      for (int k = static_cast<int>(body.pinned.size()); k < pinned; ++k) body.pinned.push_back(k);
      const double limit = body_time_step_limit(body);
      const double right = true_limit(body);
      // From above, but for rounding of a sum of as many terms.
      EXPECT_GT(limit, right * (1.0 - 1e-12)) << cells << " cells, pinned " << pinned;
      EXPECT_LT(limit, right * 1.01) << cells << " cells, pinned " << pinned;
    }
  }
}

TEST_P(BodyTimeStepLimitOf, IsAboveThatOfItsElements) {
  for (const int cells : {1, 2, 6}) {
    const BodyDescription body = test::elastic_body(test::cube_mesh(cells), GetParam().material);
    EXPECT_GT(body_time_step_limit(body), 1.05 * of_elements(body)) << cells << " cells";
  }
}

// The most energy that a cube comes to have whose vertices were moved by up to `crumple` edges, in
// units of what it starts with. Below its limit an oscillator's energy swings (1.6 to 5.7 times it was
// here), above it grows, here to 1e9 and more.
double crumpled_energy(const BodyDescription& body, double edge, double crumple, double dt) {
  const Scene scene = build_scene(test::one_body(body));
  State state = initial_state(scene);
  const Eigen::Matrix3Xd noise = test::noise(scene.vertex_count(), crumple * edge, 3);
  for (int k = 0; k < scene.vertex_count(); ++k) {
    state.position[static_cast<std::size_t>(k)].x += noise.col(k);
  }
  const Options options{.time_step = dt, .rule = "none"};
  Workspace workspace;
  const double start = elastic_energy(scene, state.position);
  double most = 0.0;
  for (int n = 0; n < 2000; ++n) {
    step(scene, options, state, workspace);
    most = std::max(most, elastic_energy(scene, state.position) + kinetic_energy(scene, state));
  }
  return most / start;
}

// Some elements are inside out.
TEST(BodyTimeStepLimit, DoesNotHoldOfACrumpledBodyAsThatOfElementsDoes) {
  const BodyDescription body = test::elastic_body(test::cube_mesh(4), {500.0, 5e5, 0.45, 1e-2});
  EXPECT_LT(crumpled_energy(body, 0.25, 0.5, 0.95 * of_elements(body)), 10.0);
  EXPECT_GT(crumpled_energy(body, 0.25, 0.5, 0.95 * body_time_step_limit(body)), 1e10);
}

// So that what steps are taken by themselves keeps a margin of 20 % where nothing is damped.
TEST(ElementTimeStepLimitOfABody, HoldsOfACrumpledOneIfItIsDamped) {
  const BodyDescription undamped = test::elastic_body(test::cube_mesh(2), {500.0, 5e5, 0.3, 0.0});
  EXPECT_LT(crumpled_energy(undamped, 0.5, 0.3, 0.8 * of_elements(undamped)), 3.0);
  EXPECT_GT(crumpled_energy(undamped, 0.5, 0.3, of_elements(undamped)), 1e10);
  const BodyDescription damped = test::elastic_body(test::cube_mesh(2), {500.0, 5e5, 0.3, 1e-4});
  EXPECT_LT(crumpled_energy(damped, 0.5, 0.3, of_elements(damped)), 3.0);
}

TEST(BodyTimeStepLimit, IsInfiniteWhereNothingElasticMoves) {
  BodyDescription held = test::elastic_body(test::corner_tetrahedron());
  held.pinned = {0, 1, 2, 3};
  EXPECT_EQ(body_time_step_limit(held), test::kInfinity);
  EXPECT_EQ(body_time_step_limit(test::point_masses(Eigen::Matrix3Xd::Zero(3, 2), 1.0)),
            test::kInfinity);
}

INSTANTIATE_TEST_SUITE_P(Materials, BodyTimeStepLimitOf, kMaterials,
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace stiction
