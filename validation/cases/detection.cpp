// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "reference/ball_mesh.h"
#include "reference/box_mesh.h"
#include "reference/exact_detection.h"
#include "reference/nonconvex_shapes.h"
#include "solver/phases/depth.h"
#include "solver/phases/detect_pairs.h"
#include "validation/case_run.h"
#include "validation/settings.h"
#include "validation/stiction_method.h"

namespace stiction {

namespace {

using reference::Side;

// Points that a rounded calculation finds hard, and points that it doesn't: all vertices, the
// middles of edges, faces and tetrahedra (of which many lie on shared faces, on the surface, or as
// far from several faces), the same a rounding away, and points at random in and about the body.
std::vector<Vec3> queries(const TetMesh& mesh, int random, std::mt19937& generator) {
  const auto uniform = [&] { return static_cast<double>(generator()) / 4294967296.0; };
  const Vec3 low = mesh.vertices.rowwise().minCoeff(), high = mesh.vertices.rowwise().maxCoeff();
  std::vector<Vec3> points;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    const auto corner = [&](int k) -> Vec3 { return mesh.vertices.col(mesh.tetrahedra(k, e)); };
    Vec3 middle = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
      middle += 0.25 * corner(k);
      points.push_back(corner(k));
      points.push_back((corner((k + 1) % 4) + corner((k + 2) % 4) + corner((k + 3) % 4)) / 3.0);
      for (int j = 0; j < k; ++j) points.push_back(0.5 * (corner(j) + corner(k)));
    }
    points.push_back(middle);
  }
  const std::size_t exact = points.size();
  for (std::size_t k = 0; k < exact; ++k) {
    Vec3 near = points[k];
    for (double& x : near) x += 4e-16 * (2.0 * uniform() - 1.0) * (high - low).maxCoeff();
    points.push_back(near);
  }
  // A few hundred degenerate points a body say all that thousands would.
  std::shuffle(points.begin(), points.end(), generator);
  points.resize(std::min(points.size(), static_cast<std::size_t>(random)));
  for (int k = 0; k < random; ++k) {
    const Vec3 share(uniform(), uniform(), uniform());
    points.push_back(low + (1.2 * share.array() - 0.1).matrix().cwiseProduct(high - low));
  }
  return points;
}

// What the solver's detection says of points in a body at rest: −1 for no contact.
struct Answer {
  double depth = -1.0;  // m
  Vec3 normal = Vec3::Zero();
};

std::vector<Answer> ask_solver(const TetMesh& mesh, const std::vector<Vec3>& points,
                               const Settings& settings) {
  SceneDescription description;
  description.bodies.resize(2);
  description.bodies[0].name = "points";
  description.bodies[0].mesh.vertices.resize(3, static_cast<Eigen::Index>(points.size()));
  description.bodies[0].point_mass = 1.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    description.bodies[0].mesh.vertices.col(static_cast<Eigen::Index>(k)) = points[k];
  }
  description.bodies[1].name = "body";
  description.bodies[1].mesh = mesh;
  const Scene scene = build_scene(description);
  const State state = initial_state(scene);
  Workspace workspace;
  workspace.velocity = state.velocity;
  Options options;
  SettingsReader reader(settings);
  read_method(reader, options);
  options.pairs.hysteresis = 0.0;
  detect_pairs(scene, options, state, workspace);
  depths(scene, options, state, workspace);
  std::vector<Answer> by_vertex(static_cast<std::size_t>(scene.vertex_count()));
  for (const PairContact& contact : workspace.pairs) {
    by_vertex[static_cast<std::size_t>(contact.vertex)] = {contact.depth, contact.normal};
  }
  std::vector<Answer> answers;
  for (std::size_t k = 0; k < points.size(); ++k) {
    answers.push_back(by_vertex[static_cast<std::size_t>(scene.scene_vertex[k])]);
  }
  return answers;
}

struct Comparison {
  int points = 0, inside = 0, boundary = 0, ties = 0;
  int wrong_side = 0;            // a side other than the exact one …
  int wrong_beyond = 0;          // … farther from the surface than rounding reaches
  double farthest_wrong = 0.0;   // distance from the surface of a wrong side, of the body's size
  double depth_error = 0.0;      // largest, of those to the nearest place, of the body's size
  double foot_error = 0.0;       // distance of x + d n from the surface, of the body's size
  int not_nearest = 0;           // depths that are to another place than the nearest …
  int not_nearest_shallow = 0;   // … of points less than half an edge deep
  double shallowest = INFINITY;  // … the least deep of them, in edges

  void add(const Comparison& other) {
    points += other.points;
    inside += other.inside;
    boundary += other.boundary;
    ties += other.ties;
    wrong_side += other.wrong_side;
    wrong_beyond += other.wrong_beyond;
    farthest_wrong = std::max(farthest_wrong, other.farthest_wrong);
    depth_error = std::max(depth_error, other.depth_error);
    foot_error = std::max(foot_error, other.foot_error);
    not_nearest += other.not_nearest;
    not_nearest_shallow += other.not_nearest_shallow;
    shallowest = std::min(shallowest, other.shallowest);
  }
};

// A barycentric weight of order one comes out of some thirty roundings of numbers of order one, and
// the volume it is divided by is up to a hundred times smaller than a cube of the same edge.
constexpr double kRounding = 30.0 * 1.1e-16 * 100.0;
// The solver takes a point as inside up to a weight of −1e-12, so that none falls between two
// tetrahedra: that far, of an element's altitude and so of the body's size at most, outside the
// surface a point may still touch.
constexpr double kMargin = 1e-12;

double mean_edge(const TetMesh& mesh) {
  double sum = 0.0;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    for (int k = 0; k < 4; ++k) {
      for (int j = 0; j < k; ++j) {
        sum += (mesh.vertices.col(mesh.tetrahedra(k, e)) - mesh.vertices.col(mesh.tetrahedra(j, e)))
                   .norm();
      }
    }
  }
  return sum / (6.0 * static_cast<double>(mesh.tetrahedra.cols()));
}

Comparison compare(const TetMesh& mesh, int random, std::mt19937& generator,
                   const Settings& settings) {
  const std::vector<Vec3> points = queries(mesh, random, generator);
  const std::vector<Answer> answers = ask_solver(mesh, points, settings);
  const reference::ExactBody exact(mesh);
  const double edge = mean_edge(mesh);
  const double size =
      (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff()).maxCoeff();
  Comparison seen;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Side side = exact.side(points[k]);
    const reference::ClosestPoint closest = exact.closest_point(points[k]);
    const double distance = std::sqrt(closest.squared_distance);
    const double depth = answers[k].depth;
    const bool touches = depth >= 0.0;
    ++seen.points;
    seen.inside += side == Side::inside;
    seen.boundary += side == Side::boundary;
    seen.ties += side == Side::inside && !closest.unique_point;
    if (side != Side::boundary && touches != (side == Side::inside)) {
      ++seen.wrong_side;
      seen.farthest_wrong = std::max(seen.farthest_wrong, distance / size);
      seen.wrong_beyond += distance > (kMargin + kRounding) * size;
    }
    if (side != Side::inside || !touches) continue;
    // A depth as long as the distance that ends on the surface is one to a nearest place, of which
    // there may be several.
    const Vec3 foot = points[k] + depth * answers[k].normal;
    seen.foot_error =
        std::max(seen.foot_error, std::sqrt(exact.closest_point(foot).squared_distance) / size);
    const double error = std::abs(depth - distance) / size;
    if (error <= kRounding) {
      seen.depth_error = std::max(seen.depth_error, error);
      continue;
    }
    ++seen.not_nearest;
    seen.not_nearest_shallow += distance < 0.5 * edge;
    seen.shallowest = std::min(seen.shallowest, distance / edge);
  }
  return seen;
}

// Moves every vertex by up to `share` of the shortest edge: no two faces are parallel any more.
TetMesh shaken(TetMesh mesh, double share, std::mt19937& generator) {
  double shortest = std::numeric_limits<double>::infinity();
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    for (int k = 0; k < 4; ++k) {
      for (int j = 0; j < k; ++j) {
        shortest = std::min(shortest, (mesh.vertices.col(mesh.tetrahedra(k, e)) -
                                       mesh.vertices.col(mesh.tetrahedra(j, e)))
                                          .norm());
      }
    }
  }
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    for (int k = 0; k < 3; ++k) {
      const double random = static_cast<double>(generator()) / 4294967296.0;
      mesh.vertices(k, v) += share * shortest * (2.0 * random - 1.0) / 1.8;
    }
  }
  return mesh;
}

void run_detection(CaseRun& run, int random) {
  if (run.engine().name != "stiction") return;
  std::mt19937 generator(1);
  const std::pair<const char*, TetMesh> bodies[] = {
      {"box of 3 cells", reference::box_mesh(Vec3(0.1, 0.1, 0.1), {3, 3, 3})},
      {"plate of one layer", reference::box_mesh(Vec3(0.2, 0.2, 0.01), {4, 4, 1})},
      {"ball", reference::ball_mesh({.radius = 0.1, .frequency = 4})},
      {"jack", reference::shape_mesh(reference::Shape::jack, 0.02)},
      {"hook, finer", reference::shape_mesh(reference::Shape::u, 0.02, 2)}};
  Comparison all;
  for (const auto& [name, mesh] : bodies) {
    for (const bool shake : {false, true}) {
      const Comparison seen =
          compare(shake ? shaken(mesh, 0.1, generator) : mesh, random, generator, run.settings());
      std::string note = fmt::format(
          "{}{}: {} points, {} inside, {} on the surface, {} as near to several places; {} on "
          "another side than the exact one, at most {:.0e} of the body's size away; largest errors "
          "of depth {:.0e} and foot {:.0e} of the size",
          name, shake ? ", shaken" : "", seen.points, seen.inside, seen.boundary, seen.ties,
          seen.wrong_side, seen.farthest_wrong, seen.depth_error, seen.foot_error);
      if (seen.not_nearest > 0) {
        note += fmt::format(
            "; {} depths are not to the nearest place, the shallowest {:.2f} mean edges deep: "
            "the solver looks within two rings of triangles about the tetrahedron",
            seen.not_nearest, seen.shallowest);
      }
      run.note(note);
      all.add(seen);
    }
  }
  const std::string source = "CGAL: side and closest point in rationals";
  run.check({.quantity = "points found on the wrong side",
             .unit = "1",
             .claim = "a vertex touches a body exactly if it is in one of its tetrahedra",
             .formula = "count = 0",
             .source = source,
             .kind = ReferenceKind::kExactComputed,
             .value = static_cast<double>(all.wrong_beyond),
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "a count; left out is what lies within 1e-12 (the solver's margin) + 3e-13 "
                       "(rounding of a weight) of the body's size from the surface",
             .worst = fmt::format("{} of {} points, none farther than {:.0e} of the size",
                                  all.wrong_side, all.points, all.farthest_wrong)});
  run.check(
      {.quantity = "depths to another than the nearest place",
       .unit = "1",
       .claim = "up to half an edge deep the depth is the distance from the surface",
       .formula = "count = 0",
       .source = source,
       .kind = ReferenceKind::kExactComputed,
       .value = static_cast<double>(all.not_nearest_shallow),
       .expected = 0.0,
       .tolerance = 0.0,
       .reason = "a count; only farther in can the nearest triangle lie outside the two rings "
                 "that are searched, and no step moves a vertex that far",
       .worst = all.not_nearest > 0 ? fmt::format("{} in all, the shallowest {:.2f} edges deep",
                                                  all.not_nearest, all.shallowest)
                                    : ""});
  run.check({.quantity = "distance of x + d n from the surface",
             .unit = "1",
             .claim = "the depth vector ends on the surface",
             .formula = "dist(x + d n)/size = 0",
             .source = source,
             .kind = ReferenceKind::kExactComputed,
             .value = all.foot_error,
             .expected = 0.0,
             .tolerance = kRounding,
             .reason = "thirty roundings over a volume a hundred times below a cube's"});
}

}  // namespace

std::vector<Case> cases_detection() {
  return {{.name = "detection/exact",
           .title = "inside tests and depths against exact ones",
           .variants = {{}},
           .run = [](CaseRun& run) { run_detection(run, 300); }},
          {.name = "detection/exact/thousands",
           .title = "inside tests and depths against exact ones, ten times the points",
           .set = CaseSet::kFull,
           .variants = {{}},
           .run = [](CaseRun& run) { run_detection(run, 3000); }}};
}

}  // namespace stiction
