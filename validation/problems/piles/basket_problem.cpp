// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/piles/basket_problem.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string>

#include "reference/meshes/nonconvex_shapes.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

// In [−1, 1], the same bits everywhere (std::uniform_real_distribution is not).
double random_signed(std::mt19937& generator) {
  return 2.0 * (static_cast<double>(generator()) / static_cast<double>(generator.max())) - 1.0;
}

// Uniform over rotations: a random point of the ball in four dimensions, made a unit.
Eigen::Quaterniond random_rotation(std::mt19937& generator) {
  while (true) {
    Eigen::Vector4d q;
    for (double& x : q) x = random_signed(generator);
    const double size = q.norm();
    if (size > 0.1 && size <= 1.0) return Eigen::Quaterniond(Eigen::Vector4d(q / size));
  }
}

double farthest_vertex(const TetMesh& mesh) { return mesh.vertices.colwise().norm().maxCoeff(); }

}  // namespace

Problem basket_problem(const BasketSetup& setup) {
  constexpr auto kKinds = static_cast<int>(std::size(reference::kShapes));
  std::vector<TetMesh> meshes;
  double reach = 0.0;  // of the largest shape from its centre of mass, m
  for (const reference::Shape shape : reference::kShapes) {
    meshes.push_back(reference::shape_mesh(shape, setup.edge, setup.cells));
    reach = std::max(reach, farthest_vertex(meshes.back()));
  }
  const double shift = 0.02 * reach;           // sideways, so that no column stands upright
  const double pitch = 2.0 * (reach + shift);  // of the lattice: spheres about the objects fit
  const double half = 0.5 * (setup.columns + 0.5) * pitch;    // of the lattice's width
  const double floor = setup.floor_share * half;              // of the basket's floor
  const double lowest = (half - floor) / setup.wall_tangent;  // where the walls are wide enough

  Problem problem;
  problem.name = "basket";
  std::mt19937 generator(setup.seed);
  int number = 0;
  for (int layer = 0; layer < setup.layers; ++layer) {
    for (int i = 0; i < setup.columns; ++i) {
      for (int j = 0; j < setup.columns; ++j, ++number) {
        const int kind = number % kKinds;
        const double stagger = 0.25 * (layer % 2 == 0 ? -1.0 : 1.0);
        ProblemBody body;
        body.name = reference::name(reference::kShapes[kind]) + " " + std::to_string(number);
        body.shape = MeshShape{meshes[static_cast<std::size_t>(kind)]};
        body.mass = setup.density * reference::shape_volume(reference::kShapes[kind], setup.edge);
        body.elasticity = setup.elasticity;
        body.rotation = random_rotation(generator);
        const double middle = 0.5 * (setup.columns - 1);
        body.position = Vec3((i - middle + stagger) * pitch + shift * random_signed(generator),
                             (j - middle + stagger) * pitch + shift * random_signed(generator),
                             lowest + (layer + 0.5) * pitch);
        problem.bodies.push_back(body);
      }
    }
  }
  problem.obstacles.push_back({"floor", Vec3::Zero(), Vec3::UnitZ(), setup.friction});
  for (const Vec3& out : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
    const Vec3 normal = (setup.wall_tangent * Vec3::UnitZ() - out).normalized();
    problem.obstacles.push_back({"wall", floor * out, normal, setup.friction});
  }
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.friction = setup.friction;
  return problem;
}

std::vector<BodyMotion> motions(const Engine& engine, std::size_t bodies) {
  std::vector<BodyMotion> all;
  for (std::size_t b = 0; b < bodies; ++b) all.push_back(engine.body(b));
  return all;
}

}  // namespace stiction
