// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/scene.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <set>

#include "solver/step.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

TEST(BuildScene, LumpsMassesThatSumUpToDensityTimesVolume) {
  Material material;
  material.density = 700.0;
  const Scene scene = build_scene(test::one_body(test::elastic_body(test::cube_mesh(3), material)));
  // Round-off: 4 · 162 quarters are added.
  EXPECT_NEAR(std::accumulate(scene.mass.begin(), scene.mass.end(), 0.0), 700.0,
              700.0 * 648 * test::kEpsilon);
  EXPECT_NEAR(scene.bodies[0].mass, 700.0, 700.0 * 648 * test::kEpsilon);
}

TEST(BuildScene, GivesEachCornerAQuarterOfItsTetrahedron) {
  const Scene scene = build_scene(test::one_body(test::elastic_body(test::corner_tetrahedron())));
  for (const double mass : scene.mass) EXPECT_DOUBLE_EQ(mass, 1000.0 / 24.0);
}

TEST(BuildScene, MapsDescribedVerticesToTheirPlaces) {
  BodyDescription body = test::elastic_body(test::cube_mesh(2));
  body.initial_velocity = test::noise(27, 1.0, 1);
  SceneDescription description = test::one_body(body);
  description.bodies.push_back(body);
  const Scene scene = build_scene(description);
  ASSERT_EQ(scene.vertex_count(), 54);
  const std::set<int> places(scene.scene_vertex.begin(), scene.scene_vertex.end());
  EXPECT_EQ(places.size(), 54u);
  for (int k = 0; k < 54; ++k) {
    const int place = scene.scene_vertex[static_cast<std::size_t>(k)];
    EXPECT_EQ(scene.rest_position.col(place), body.mesh.vertices.col(k % 27));
    EXPECT_EQ(scene.initial_velocity.col(place), body.initial_velocity.col(k % 27));
    EXPECT_EQ(place >= 27, k >= 27) << "a body's vertices are contiguous";
  }
  EXPECT_EQ(scene.bodies[1].first_vertex, 27);
  EXPECT_EQ(scene.bodies[1].vertex_count, 27);
}

TEST(BuildScene, ListsSurfaceVerticesOfAllBodiesInIncreasingOrder) {
  SceneDescription description = test::one_body(test::elastic_body(test::cube_mesh(2)));
  description.bodies.push_back(description.bodies[0]);
  const Scene scene = build_scene(description);
  EXPECT_EQ(scene.surface_vertex.size(), 2u * 26u);  // one vertex of 27 lies inside
  EXPECT_TRUE(std::is_sorted(scene.surface_vertex.begin(), scene.surface_vertex.end()));
  for (const int v : scene.surface_vertex) {
    EXPECT_NE(Vec3(scene.rest_position.col(v)), Vec3::Constant(0.5));
  }
}

TEST(BuildScene, StopsPinnedVertices) {
  BodyDescription body = test::elastic_body(test::corner_tetrahedron());
  body.initial_velocity = Eigen::Matrix3Xd::Ones(3, 4);
  body.pinned = {2};
  const Scene scene = build_scene(test::one_body(body));
  for (int k = 0; k < 4; ++k) {
    const int place = scene.scene_vertex[static_cast<std::size_t>(k)];
    const double inverse = scene.inverse_mass[static_cast<std::size_t>(place)];
    if (k == 2) {
      EXPECT_EQ(inverse, 0.0);
      EXPECT_EQ(Vec3(scene.initial_velocity.col(place)), Vec3::Zero());
    } else {
      EXPECT_DOUBLE_EQ(inverse * scene.mass[static_cast<std::size_t>(place)], 1.0);
      EXPECT_EQ(Vec3(scene.initial_velocity.col(place)), Vec3::Ones());
    }
  }
  EXPECT_DOUBLE_EQ(scene.bodies[0].mass, 1000.0 / 6.0) << "pinned vertices included";
}

TEST(BuildScene, OfPointMassesHasNoTimeStepLimit) {
  const Scene scene =
      build_scene(test::one_body(test::point_masses(Eigen::Matrix3Xd::Zero(3, 1), 2.0)));
  EXPECT_EQ(scene.stable_time_step, test::kInfinity);
  EXPECT_EQ(scene.mass, std::vector<double>{2.0});
}

TEST(BuildScene, NamesTheElementAndBodyThatLimitTheTimeStep) {
  SceneDescription description = test::one_body(test::elastic_body(test::cube_mesh(1)));
  BodyDescription other = test::elastic_body(test::cube_mesh(1));
  other.name = "with a thin one";
  // Squeezes the cell's tetrahedra unevenly: whichever brute force finds stiffest must be named.
  other.mesh.vertices.col(1) += Vec3(-0.4, 0.2, 0.1);
  description.bodies.push_back(other);
  const Scene scene = build_scene(description);
  int stiffest = -1;
  double smallest = test::kInfinity;
  for (int e = 0; e < 6; ++e) {
    const double limit = element_time_step_limit(other.mesh, e, other.material);
    if (limit < smallest) {
      smallest = limit;
      stiffest = 6 + e;
    }
  }
  EXPECT_EQ(scene.stable_time_step, smallest);
  EXPECT_EQ(scene.stiffest_element, stiffest);
  EXPECT_EQ(scene.stiffest_body, "with a thin one");
}

// ---- the element's time step limit, against brute force and against what really happens ---------

// A tetrahedron without symmetry.
TetMesh skew_tetrahedron() {
  TetMesh mesh = test::corner_tetrahedron(0.1);
  mesh.vertices += test::noise(4, 0.02, 7);
  return mesh;
}

// Stiffness matrix of one linear tetrahedron from the index form of isotropic elasticity,
//   K_{ai,bj} = V (λ gₐᵢ g_bⱼ + μ gₐⱼ g_bᵢ + μ δᵢⱼ gₐ·g_b),   g the gradients of the shape
//   functions:
// the slow twin of the six strain modes that element_time_step_limit works with.
Matrix12 stiffness(const TetMesh& mesh, const Material& material) {
  Mat3 edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = mesh.vertices.col(k + 1) - mesh.vertices.col(0);
  Eigen::Matrix<double, 3, 4> g;
  g.rightCols<3>() = edges.inverse().transpose();
  g.col(0) = -g.rightCols<3>().rowwise().sum();
  const double e = material.youngs_modulus;
  const double nu = material.poisson_ratio;
  const double mu = e / (2.0 * (1.0 + nu));
  const double lambda = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  Matrix12 k;
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      k.block<3, 3>(3 * a, 3 * b) =
          signed_volume(mesh, 0) *
          (lambda * g.col(a) * g.col(b).transpose() + mu * g.col(b) * g.col(a).transpose() +
           mu * g.col(a).dot(g.col(b)) * Mat3::Identity());
    }
  }
  return k;
}

struct StiffestMode {
  double omega;    // rad/s
  Vector12 shape;  // three coordinates a vertex
};

StiffestMode stiffest_mode(const TetMesh& mesh, const Material& material) {
  const double mass = material.density * signed_volume(mesh, 0) / 4.0;
  const Eigen::SelfAdjointEigenSolver<Matrix12> eigen(stiffness(mesh, material) / mass);
  return {std::sqrt(eigen.eigenvalues()[11]), eigen.eigenvectors().col(11)};
}

struct Stiff {
  std::string name;
  Material material;
};

void PrintTo(const Stiff& stiff, std::ostream* out) { *out << stiff.name; }

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

INSTANTIATE_TEST_SUITE_P(Materials, ElementTimeStepLimit,
                         testing::Values(Stiff{"Undamped", {1000.0, 1e6, 0.3, 0.0}},
                                         Stiff{"LightlyDamped", {1000.0, 1e6, 0.3, 1e-4}},
                                         Stiff{"HeavilyDamped", {500.0, 5e5, 0.45, 1e-2}},
                                         Stiff{"NegativePoissonRatio", {1000.0, 1e6, -0.5, 0.0}}),
                         [](const auto& one) { return one.param.name; });

TEST(SceneSerial, IsAnotherOfACopyAndTheSameOfWhatWasMoved) {
  const SceneDescription one = test::one_body(test::elastic_body(test::corner_tetrahedron()));
  Scene scene = build_scene(one);
  const std::uint64_t serial = scene.serial;
  const Scene copy = scene;
  EXPECT_NE(copy.serial, serial);
  Scene assigned = build_scene(one);
  assigned = scene;
  EXPECT_NE(assigned.serial, serial);
  EXPECT_NE(assigned.serial, copy.serial);
  const Scene moved = std::move(scene);
  EXPECT_EQ(moved.serial, serial);
}

}  // namespace
}  // namespace stiction
