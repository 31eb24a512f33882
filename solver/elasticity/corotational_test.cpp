// SPDX-License-Identifier: BSD-3-Clause
#include "solver/elasticity/corotational.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "solver/lanes/lane_width.h"
#include "solver/observables.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

constexpr Material kMaterial{1000.0, 1e6, 0.3, 1e-3};
constexpr double kMu = 1e6 / 2.6;
constexpr double kLambda = 0.3 * 1e6 / (1.3 * 0.4);

Scene cube(const Material& material = kMaterial) {
  return build_scene(test::one_body(test::elastic_body(test::cube_mesh(2), material)));
}

std::vector<Vec3> vectors(const std::vector<Force>& forces) {
  std::vector<Vec3> vectors;
  for (const Force& force : forces) vectors.push_back(force.f);
  return vectors;
}

std::vector<Vec3> forces(const Scene& scene, const State& state) {
  std::vector<Force> force(state.position.size());
  add_corotational_forces(scene, state, force);
  return vectors(force);
}

double sum_of_norms(const std::vector<Vec3>& vectors) {
  double sum = 0.0;
  for (const Vec3& vector : vectors) sum += vector.norm();
  return sum;
}

// Deformed by some 5 % and turned, with velocities of 1 m/s: nothing is special about it.
State deformed(const Scene& scene, unsigned seed) {
  const Mat3 turn = Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized()).matrix();
  const Eigen::Index n = scene.rest_position.cols();
  return test::state_at(scene, turn * (scene.rest_position + test::noise(n, 0.02, seed)),
                        test::noise(n, 1.0, seed + 100));
}

// Central difference of the elastic energy with one coordinate, J/m.
double energy_slope(const Scene& scene, const State& state, std::size_t vertex, int axis,
                    double h) {
  std::vector<Position> position = state.position;
  const double x = position[vertex].x[axis];
  position[vertex].x[axis] = x + h;
  const double ahead = elastic_energy(scene, position);
  position[vertex].x[axis] = x - h;
  return (ahead - elastic_energy(scene, position)) / (2.0 * h);
}

TEST(ElasticForces, AreTheNegativeGradientOfTheEnergy) {
  Material undamped = kMaterial;
  undamped.damping_time = 0.0;
  const Scene scene = cube(undamped);
  State state = deformed(scene, 1);
  for (Velocity& velocity : state.velocity) velocity.v.setConstant(test::kNaN);  // unused
  const std::vector<Vec3> force = forces(scene, state);
  double largest = 0.0;
  for (const Vec3& f : force) largest = std::max(largest, f.cwiseAbs().maxCoeff());

  // Worst error over all coordinates, relative to the largest force, by step size.
  std::vector<double> error;
  for (int decade = 2; decade <= 10; ++decade) {
    const double h = std::pow(10.0, -decade);
    double worst = 0.0;
    for (std::size_t v = 0; v < force.size(); ++v) {
      for (int axis = 0; axis < 3; ++axis) {
        const double slope = energy_slope(scene, state, v, axis, h);
        worst = std::max(worst, std::abs(force[v][axis] + slope) / largest);
      }
    }
    error.push_back(worst);
  }
  // Left arm of the V: truncation, O(h²), so each decade gains two.
  EXPECT_NEAR(std::log10(error[0] / error[1]), 2.0, 0.1);
  EXPECT_NEAR(std::log10(error[1] / error[2]), 2.0, 0.1);
  // Right arm: the energy's round-off over h, so each decade loses about one.
  EXPECT_GT(error[8], 100.0 * error[5]);
  // At the bottom the two meet at h ~ ε^⅓: (6e-6)² of the force's curvature, and a factor.
  EXPECT_LT(*std::min_element(error.begin(), error.end()), 1e-9);
}

TEST(ElasticForces, OfAUniformStretchAreHookesLaw) {
  // F = diag(1 + s, 1, 1) on one corner tetrahedron: P = 2μ s e₁e₁ᵀ + λ s I, V = 1/6, and −V P are
  // the forces on the corners along the axes.
  const double s = 1e-3;
  Material undamped = kMaterial;
  undamped.damping_time = 0.0;
  const Scene scene =
      build_scene(test::one_body(test::elastic_body(test::corner_tetrahedron(), undamped)));
  Eigen::Matrix3Xd position = scene.rest_position;
  position.row(0) *= 1.0 + s;
  const State state = test::state_at(scene, position, Eigen::Matrix3Xd::Constant(3, 4, test::kNaN));
  const std::vector<Vec3> force = forces(scene, state);
  const auto at = [&](std::size_t described) {
    return force[static_cast<std::size_t>(scene.scene_vertex[described])];
  };
  // Round-off of F − I: ε E V, and some.
  const double round_off = 20.0 * test::kEpsilon * 1e6 / 6.0;
  EXPECT_LT((at(1) - Vec3(-(2.0 * kMu + kLambda) * s / 6.0, 0, 0)).norm(), round_off);
  EXPECT_LT((at(2) - Vec3(0, -kLambda * s / 6.0, 0)).norm(), round_off);
  EXPECT_LT((at(3) - Vec3(0, 0, -kLambda * s / 6.0)).norm(), round_off);
  // Energy V (μ s² + ½λ s²).
  EXPECT_NEAR(elastic_energy(scene, state.position), (kMu + 0.5 * kLambda) * s * s / 6.0,
              s * round_off);
}

TEST(ElasticAndViscousForces, VanishUnderRigidMotion) {
  const Scene scene = cube();
  const Mat3 turn = Eigen::AngleAxisd(2.5, Vec3(3, -1, 2).normalized()).matrix();
  const Vec3 spin(4, -5, 6);  // rad/s
  const Eigen::Matrix3Xd position = (turn * scene.rest_position).colwise() + Vec3(1.0, -2.0, 0.5);
  Eigen::Matrix3Xd velocity(3, position.cols());
  for (Eigen::Index k = 0; k < position.cols(); ++k) {
    velocity.col(k) = spin.cross(Vec3(position.col(k))) + Vec3(7.0, 8.0, -9.0);
  }
  const State state = test::state_at(scene, position, velocity);
  // Positions of up to 3 m are rounded by 3ε/2 and their differences divided by edges of 0.5 m:
  // F is good to 6ε, stresses to (2μ + 3λ) ≈ 2.5 E times that, over areas of 1/8 m²; velocities of
  // up to 30 m/s in the same way, times β = 1 ms. 24 elements meet in a vertex.
  const double round_off = 24.0 * 2.5e6 / 8.0 * (6.0 + 60.0 * 1e-3) * 4.0 * test::kEpsilon;
  for (const Vec3& f : forces(scene, state)) EXPECT_LT(f.norm(), round_off);
  EXPECT_LT(elastic_energy(scene, state.position), round_off * round_off / 1e6);
}

class InternalForces : public testing::TestWithParam<unsigned> {};

TEST_P(InternalForces, KeepLinearAndAngularMomentum) {
  const Scene scene = cube();
  const State state = deformed(scene, GetParam());
  const std::vector<Vec3> force = forces(scene, state);
  Vec3 sum = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
  for (std::size_t k = 0; k < force.size(); ++k) {
    sum += force[k];
    moment += state.position[k].x.cross(force[k]);
  }
  // Forces cancel within an element to its round-off; 48 elements, lever arms of up to 2 m, and the
  // rotation's own round-off of 100 ε in the stress.
  const double total = sum_of_norms(force);
  ASSERT_GT(total, 1e4);  // N: there is something to cancel
  EXPECT_LT(sum.norm(), 48.0 * test::kEpsilon * total);
  EXPECT_LT(moment.norm(), 2.0 * 100.0 * test::kEpsilon * total);
}

TEST_P(InternalForces, LosePowerToDamping) {
  const Scene damped = cube();
  Material undamped_material = kMaterial;
  undamped_material.damping_time = 0.0;
  const Scene undamped = cube(undamped_material);
  const State state = deformed(damped, GetParam());
  const std::vector<Vec3> with = forces(damped, state);
  const std::vector<Vec3> without = forces(undamped, state);
  double power = 0.0;
  for (std::size_t k = 0; k < with.size(); ++k) {
    power += (with[k] - without[k]).dot(state.velocity[k].v);
  }
  EXPECT_LT(power, 0.0);
}

INSTANTIATE_TEST_SUITE_P(RandomStates, InternalForces, testing::Range(1u, 9u),
                         [](const auto& one) { return "Seed" + std::to_string(one.param); });

TEST(ViscousForces, DissipateWhatTheStrainRateSays) {
  // v = A x on an unstretched tetrahedron: power −β V (2μ|Ė|² + λ tr²Ė), Ė = sym A.
  const Scene scene =
      build_scene(test::one_body(test::elastic_body(test::corner_tetrahedron(), kMaterial)));
  Mat3 a;
  a << 1, 2, -3, 0.5, -1, 4, 2, 7, 3;
  const State state = test::state_at(scene, scene.rest_position, a * scene.rest_position);
  const std::vector<Vec3> force = forces(scene, state);
  double power = 0.0;
  for (std::size_t k = 0; k < 4; ++k) power += force[k].dot(state.velocity[k].v);
  const Mat3 rate = 0.5 * (a + a.transpose());
  const double expected = -kMaterial.damping_time / 6.0 *
                          (2.0 * kMu * rate.squaredNorm() + kLambda * rate.trace() * rate.trace());
  EXPECT_NEAR(power, expected, 100.0 * test::kEpsilon * std::abs(expected));
}

TEST(ElasticForces, AreAddedToWhatIsThere) {
  const Scene scene = cube();
  const State state = deformed(scene, 3);
  const std::vector<Vec3> alone = forces(scene, state);
  std::vector<Force> force(alone.size(), {Vec3(1e9, 0, 0)});
  add_corotational_forces(scene, state, force);
  // Sums near 1e9 N are rounded by 1e-7 N, once an element.
  for (std::size_t k = 0; k < alone.size(); ++k) {
    EXPECT_LT((force[k].f - Vec3(1e9, 0, 0) - alone[k]).norm(), 24 * 1.2e-7);
  }
}

// So many tetrahedra that share nothing, deformed, of which those in `inverted` are turned inside
// out.
struct Separate {
  Scene scene;
  State state;

  explicit Separate(const std::vector<bool>& inverted, const Material& material = kMaterial)
      : scene(scene_of(inverted.size(), material)), state(deformed(scene, 4)) {
    for (std::size_t e = 0; e < inverted.size(); ++e) {
      if (!inverted[e]) continue;
      const auto x = [&](int k) -> Vec3& {
        return state.position[static_cast<std::size_t>(scene.elements[e].vertex[k])].x;
      };
      std::swap(x(0), x(1));
    }
    for (std::size_t e = 0; e < inverted.size(); ++e) {
      const auto x = [&](int k) {
        return state.position[static_cast<std::size_t>(scene.elements[e].vertex[k])].x;
      };
      const double volume = (x(1) - x(0)).cross(x(2) - x(0)).dot(x(3) - x(0));
      EXPECT_EQ(volume < 0.0, inverted[e]);
    }
  }

  static Scene scene_of(std::size_t count, const Material& material) {
    SceneDescription description;
    for (std::size_t e = 0; e < count; ++e) {
      description.bodies.push_back(test::elastic_body(test::corner_tetrahedron(), material));
    }
    return build_scene(description);
  }
};

std::vector<Vec3> forces_at(const Scene& scene, const State& state, int width) {
  std::vector<Force> force(state.position.size());
  add_corotational_forces(scene, state, force, width);
  return vectors(force);
}

void expect_same_bits_at_each_width(const Scene& scene, const State& state) {
  const std::vector<Vec3> narrow = forces_at(scene, state, 2);
  EXPECT_GT(sum_of_norms(narrow), 0.0);
  for (const int width : lane_widths()) {
    EXPECT_EQ(forces_at(scene, state, width), narrow)
        << scene.elements.size() << " elements, width " << width;
  }
  EXPECT_EQ(forces(scene, state), narrow);
}

// So many vertices that elements ask for those of others before they come to them.
TEST(ElasticForces, OfManyVerticesAreTheSameBitsAtEachWidth) {
  const Separate separate(std::vector<bool>(8200, false));
  ASSERT_GE(separate.scene.mass.size(), 32768U);
  expect_same_bits_at_each_width(separate.scene, separate.state);
}

// Inverted and undamped elements beside others, in groups that are full and not.
TEST(ElasticForces, AreTheSameBitsAtEachWidth) {
  for (std::size_t count = 1; count < 40; ++count) {
    std::vector<bool> inverted(count);
    for (std::size_t e = 0; e < count; ++e) inverted[e] = e % 5 == count % 5;
    Separate separate(inverted);
    BlocksOfConstants constants;
    for (std::size_t e = 0; e < count; ++e) {
      ElementConstants one = separate.scene.constants[e];
      if (e % 3 == 0) one.damping_time = 0;
      constants.push_back(one);
    }
    separate.scene.constants = constants;
    expect_same_bits_at_each_width(separate.scene, separate.state);
  }
  const Scene scene = cube();
  expect_same_bits_at_each_width(scene, deformed(scene, 5));
}

// Elements are computed side by side, the last of fewer with itself: neither a partner nor an
// inverted one in its place may show.
TEST(ElasticForces, OfAnElementDoNotDependOnThoseBesideIt) {
  for (const std::vector<bool>& inverted : std::vector<std::vector<bool>>{
           {false, true, true, false, true, true, false}, {true}, {false, false, true}}) {
    const Separate separate(inverted);
    const std::vector<Vec3> together = forces(separate.scene, separate.state);
    std::vector<Force> alone(together.size());
    for (std::size_t e = 0; e < inverted.size(); ++e) {
      Scene one = separate.scene;
      one.elements = {separate.scene.elements[e]};
      one.constants = {};
      one.constants.push_back(separate.scene.constants[e]);
      add_corotational_forces(one, separate.state, alone);
    }
    for (std::size_t k = 0; k < alone.size(); ++k) EXPECT_EQ(together[k], alone[k].f) << k;
  }
}

// Ranges of elements have vertices in common, and some have inverted elements at their borders.
TEST(ElasticForces, HaveTheSameBitsWhenThreadsShareThem) {
  if (most_threads() == 1) GTEST_SKIP() << "built without oneTBB";
  const Scene scene =
      build_scene(test::one_body(test::elastic_body(test::cube_mesh(14), kMaterial)));
  const State state = deformed(scene, 5);
  const std::vector<Vec3> wanted = forces(scene, state);
  for (const int threads : {1, 2, 5}) {
    const Team team(threads);
    ElementShares shares;
    for (int again = 0; again < 2; ++again) {
      std::vector<Force> force(state.position.size());
      add_corotational_forces(scene, state, team, shares, force);
      EXPECT_EQ(vectors(force), wanted) << threads << " threads";
    }
    EXPECT_EQ(shares.share.size() > 1, threads > 1);
  }
}

TEST(ElasticForces, OfAnInvertedElementAreTheNegativeGradientToo) {
  Material undamped = kMaterial;
  undamped.damping_time = 0.0;
  const Separate separate({false, true}, undamped);
  const std::vector<Vec3> force = forces(separate.scene, separate.state);
  const double h = 1e-5;
  for (std::size_t k = 0; k < force.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      // The slope's error is h² = 1e-10 of the third derivative, some E, and ε/h = 2e-11 of the
      // energy, some E V, each some ten times.
      EXPECT_NEAR(force[k][axis], -energy_slope(separate.scene, separate.state, k, axis, h),
                  1e-9 * sum_of_norms(force));
    }
  }
}

TEST(ElasticForces, OfAnInvertedElementPushItBack) {
  const Scene scene =
      build_scene(test::one_body(test::elastic_body(test::corner_tetrahedron(), kMaterial)));
  Eigen::Matrix3Xd position = scene.rest_position;
  const auto tip = static_cast<std::size_t>(scene.scene_vertex[3]);
  position(2, static_cast<Eigen::Index>(tip)) = -0.2;  // through the face below
  const State state = test::state_at(scene, position, Eigen::Matrix3Xd::Zero(3, 4));
  EXPECT_GT(forces(scene, state)[tip].z(), 0.0);
}

}  // namespace
}  // namespace stiction
