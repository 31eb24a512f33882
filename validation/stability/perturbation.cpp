// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/stability/perturbation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include "reference/meshes/ball_mesh.h"
#include "reference/meshes/box_mesh.h"
#include "reports/text/names.h"
#include "solver/demand.h"

namespace stiction {

namespace {

using Random = std::mt19937_64;

// std::shuffle and the distributions are free to differ between libraries.
std::size_t below(Random& random, std::size_t count) { return random() % count; }

std::vector<std::size_t> shuffled(std::size_t count, Random& random) {
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), 0);
  for (std::size_t k = count; k > 1; --k) std::swap(places[k - 1], places[below(random, k)]);
  return places;
}

template <class Item>
std::vector<Item> placed(const std::vector<Item>& items, const std::vector<std::size_t>& places) {
  std::vector<Item> there(items.size());
  for (std::size_t k = 0; k < items.size(); ++k) there[places[k]] = items[k];
  return there;
}

Order shuffle_bodies(Problem& problem, std::uint64_t seed) {
  if (problem.bodies.size() + problem.obstacles.size() < 3) {
    throw NotApplicable("there are too few bodies to put in another order");
  }
  Random random(seed);
  Order order{shuffled(problem.bodies.size(), random), shuffled(problem.obstacles.size(), random)};
  problem.bodies = placed(problem.bodies, order.bodies);
  problem.obstacles = placed(problem.obstacles, order.obstacles);
  for (Load& load : problem.loads) load.body = order.bodies[load.body];
  for (Spring& spring : problem.springs) spring.body = order.bodies[spring.body];
  return order;
}

// Even permutations, which keep a tetrahedron's volume positive.
constexpr int kEven[12][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 0, 3, 2},
                              {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 0, 1, 3}, {2, 1, 3, 0},
                              {2, 3, 0, 1}, {3, 0, 2, 1}, {3, 1, 0, 2}, {3, 2, 1, 0}};

TetMesh renumbered(const TetMesh& mesh, Random& random) {
  TetMesh there = mesh;
  const auto vertex = shuffled(static_cast<std::size_t>(mesh.vertices.cols()), random);
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    there.vertices.col(static_cast<Eigen::Index>(vertex[static_cast<std::size_t>(v)])) =
        mesh.vertices.col(v);
  }
  const auto place = shuffled(static_cast<std::size_t>(mesh.tetrahedra.cols()), random);
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    const auto& corners = kEven[below(random, 12)];
    for (int k = 0; k < 4; ++k) {
      const auto v = static_cast<std::size_t>(mesh.tetrahedra(corners[k], e));
      there.tetrahedra(k, static_cast<Eigen::Index>(place[static_cast<std::size_t>(e)])) =
          static_cast<int>(vertex[v]);
    }
  }
  return there;
}

void renumber_vertices(Problem& problem, std::uint64_t seed) {
  Random random(seed);
  bool any = false;
  for (ProblemBody& body : problem.bodies) {
    auto* const shape = std::get_if<MeshShape>(&body.shape);
    if (shape == nullptr) continue;
    any = true;
    shape->mesh = renumbered(shape->mesh, random);
  }
  if (!any) throw NotApplicable("no body is given as a mesh whose vertices could be renumbered");
}

void mesh_shapes(Problem& problem, int fineness) {
  constexpr int kBall = 4;  // frequency: 162 vertices on the surface
  for (ProblemBody& body : problem.bodies) {
    if (const auto* const box = std::get_if<BoxShape>(&body.shape)) {
      const Eigen::Vector3i cells = reference::box_cells(box->size, std::max(fineness, 1));
      body.shape = MeshShape{reference::box_mesh(box->size, cells), true};
    } else if (const auto* const ball = std::get_if<BallShape>(&body.shape)) {
      body.shape =
          MeshShape{reference::ball_mesh({.radius = ball->radius, .frequency = kBall}), true};
    }
  }
}

// Each number stays, or goes to one of its neighbours.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_(seed) {}

  void on(double& number) {
    const std::size_t way = below(random_, 3);
    if (way == 2 || number == 0.0) return;
    const double end = std::numeric_limits<double>::infinity();
    number = std::nextafter(number, way == 0 ? end : -end);
  }
  void on(Vec3& vector) {
    for (double& number : vector) on(number);
  }

 private:
  Random random_;
};

void add_noise(Problem& problem, std::uint64_t seed) {
  Noise noise(seed);
  for (ProblemBody& body : problem.bodies) {
    if (auto* const box = std::get_if<BoxShape>(&body.shape)) noise.on(box->size);
    if (auto* const ball = std::get_if<BallShape>(&body.shape)) noise.on(ball->radius);
    if (auto* const shape = std::get_if<MeshShape>(&body.shape)) {
      for (double& number : shape->mesh.vertices.reshaped()) noise.on(number);
    }
    noise.on(body.mass);
    noise.on(body.elasticity.youngs_modulus);
    noise.on(body.position);
    noise.on(body.velocity);
    noise.on(body.angular_velocity);
  }
  for (Obstacle& obstacle : problem.obstacles) noise.on(obstacle.point);
  for (Vec3& acceleration : problem.gravity.acceleration) noise.on(acceleration);
}

ReferenceFrame turned(double degrees, const Vec3& axis) {
  return {.turn = Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized())
                      .toRotationMatrix()};
}

std::vector<Perturbation> all_perturbations() {
  std::vector<Perturbation> all;
  const auto add = [&](Perturbation one) { all.push_back(std::move(one)); };
  add({.name = "rerun", .group = "rerun", .words = "run again"});
  add({.name = "rewind",
       .group = "rewind",
       .words = "each step taken, taken back and taken again",
       .rewinds = true});
  const std::vector<std::pair<double, Vec3>> turns = {
      {90.0, {0, 0, 1}}, {40.0, {1, 2, 3}}, {-115.0, {-2, 1, 0.5}}};
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const auto& [degrees, axis] = turns[k];
    add({.name = fmt::format("turned/{}", k + 1),
         .group = "turned",
         .words = fmt::format("turned by {:g}° about ({:g}, {:g}, {:g})", degrees, axis.x(),
                              axis.y(), axis.z()),
         .frame = turned(degrees, axis)});
  }
  for (const double distance : {1.0, 1e3, 1e6}) {
    const std::string name = fmt::format("moved {:g} m", distance);
    ReferenceFrame frame;
    frame.shift = distance * Vec3(2, -3, 6) / 7.0;
    add({.name = fmt::format("moved/{:g}", distance),
         .group = name,
         .words = name + " away along (2, −3, 6)",
         .frame = frame});
  }
  add({.name = "meshed",
       .group = "meshed",
       .words = "boxes and balls given as meshes",
       .meshed = true});
  ReferenceFrame mirror;
  const Vec3 normal = Vec3(1, -2, 0.5).normalized();
  mirror.turn -= 2.0 * normal * normal.transpose();
  add({.name = "mirrored",
       .group = "mirrored",
       .words = "mirrored at a plane across (1, −2, ½), meshes too",
       .frame = mirror,
       .meshed = true});
  for (const std::uint64_t seed : {1u, 2u}) {
    add({.name = fmt::format("bodies/{}", seed),
         .group = "bodies renumbered",
         .words = fmt::format("bodies and obstacles in another order, seed {}", seed),
         .bodies = seed});
  }
  for (const std::uint64_t seed : {1u, 2u}) {
    add({.name = fmt::format("vertices/{}", seed),
         .group = "vertices renumbered",
         .words = fmt::format("vertices and tetrahedra in another order, seed {}", seed),
         .meshed = true,
         .vertices = seed});
  }
  ReferenceFrame units;
  units.length = 1e-3;
  units.mass = 1e3;
  units.time = 10.0;
  add({.name = "units",
       .group = "other units",
       .words = "lengths × 1e-3, masses × 1e3, times × 10",
       .frame = units});
  ReferenceFrame passing;
  passing.drift = 10.0 * Vec3(2, -3, 6) / 7.0;
  add({.name = "drifting",
       .group = "moving frame",
       .words = "everything at 10 m/s more along (2, −3, 6)",
       .frame = passing});
  for (const char* const way : {"upward", "downward", "toward-zero"}) {
    add({.name = fmt::format("rounding/{}", way),
         .group = "rounding modes",
         .words = fmt::format("the engine's arithmetic rounds {}", way),
         .rounding = way});
  }
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    add({.name = fmt::format("ulp/{}", seed),
         .group = "noise of 1 ulp",
         .words = fmt::format("each number of the scene ±1 ulp or 0 off, seed {}", seed),
         .ulp = seed});
  }
  add({.name = "fused", .group = "contraction", .words = "a·b + c rounded once", .build = "fused"});
  add({.name = "single",
       .group = "single precision",
       .words = "the engine built in single precision",
       .build = "single"});
  return all;
}

}  // namespace

const std::vector<Perturbation>& perturbations() {
  static const std::vector<Perturbation> all = all_perturbations();
  return all;
}

const std::vector<PerturbationGroup>& perturbation_groups() {
  static const std::string kRoom =
      "ten digits: it rounds each number anew, by 1e-16, and a scene that is no threshold may make "
      "a million times that of it";
  static const std::string kSame = "the same operations in the same order: nothing is rounded anew";
  static const std::string kBias =
      "each operation rounds by 1e-16 more, always the same way: twelve digits of what rests, ten "
      "of what moves, over whose ten thousand steps that adds up";
  static const std::string kOutcome = "the mechanics are the same";
  static const std::vector<PerturbationGroup> all = {
      {"rerun", "", 0.0, 0.0, kSame, "the same run gives the same bits"},
      {"rewind", "", 0.0, 0.0, kSame, "a step from a restored state is the step that was taken"},
      {"turned", "", 1e-10, 1e-10, kRoom, "nothing depends on which way the axes point"},
      {"moved 1 m", "", 1e-10, 1e-10, kRoom, "nothing depends on where the origin is"},
      {"moved 1000 m", "", 1e-7, 1e-7,
       kRoom + "; coordinates of 1e3 m round by a thousand times as much",
       "nothing depends on where the origin is"},
      {"moved 1e+06 m", "", 1e-4, 1e-4,
       kRoom + "; coordinates of 1e6 m round by a million times as much",
       "nothing depends on where the origin is"},
      {"mirrored", "meshed", 1e-10, 1e-10, kRoom, "left and right are alike"},
      {"bodies renumbered", "", 1e-10, 1e-10, kRoom, "nothing depends on the order of bodies"},
      {"vertices renumbered", "meshed", 1e-10, 1e-10, kRoom,
       "nothing depends on the order of vertices"},
      {"other units", "", 1e-10, 1e-10, kRoom, "nothing depends on the units"},
      {"moving frame", "", 1e-9, 1e-9, kRoom + "; positions grow to 10 m",
       "rest and steady motion are alike"},
      {"rounding modes", "", 1e-10, 1e-12, kBias, kOutcome},
      {"noise of 1 ulp", "", 1e-10, 1e-10, kRoom, kOutcome},
      {"contraction", "", 1e-10, 1e-10, kRoom, kOutcome},
      {"single precision", "", 1e-2, 1e-2, "two digits: numbers round by 6e-8", kOutcome},
  };
  return all;
}

const Perturbation& find_perturbation(const std::string& name) {
  for (const Perturbation& one : perturbations()) {
    if (one.name == name) return one;
  }
  throw InputError("unknown perturbation '" + name + "'; there are: " +
                   listed_names(perturbations(), [](const Perturbation& one) { return one.name; }));
}

PerturbedProblem perturbed(const Problem& problem, const Perturbation& how, int fineness) {
  PerturbedProblem there{problem, {}};
  there.order.bodies.resize(problem.bodies.size());
  there.order.obstacles.resize(problem.obstacles.size());
  std::iota(there.order.bodies.begin(), there.order.bodies.end(), 0);
  std::iota(there.order.obstacles.begin(), there.order.obstacles.end(), 0);
  if (how.meshed) mesh_shapes(there.problem, fineness);
  if (how.vertices) renumber_vertices(there.problem, *how.vertices);
  there.problem = how.frame.seen(there.problem);
  if (how.bodies) there.order = shuffle_bodies(there.problem, *how.bodies);
  if (how.ulp) add_noise(there.problem, *how.ulp);
  return there;
}

}  // namespace stiction
