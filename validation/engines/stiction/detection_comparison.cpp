// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/detection_comparison.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "reference/exact/exact_detection.h"
#include "solver/depth/depth.h"
#include "solver/detection/detect_pairs.h"
#include "validation/engine/settings.h"
#include "validation/engines/stiction/stiction_method.h"

namespace stiction {

namespace {

using reference::Side;

// The solver takes a point as inside up to a weight of −1e-12, so that none falls between two
// tetrahedra: that far, of an element's altitude and so of the body's size at most, outside the
// surface a point may still touch.
constexpr double kMargin = 1e-12;

// In [0, 1). The library's distributions differ from compiler to compiler.
double uniform(std::mt19937& generator) { return static_cast<double>(generator()) / 4294967296.0; }

// Points that a rounded calculation finds hard, and points that it doesn't: all vertices, the
// middles of edges, faces and tetrahedra (of which many lie on shared faces, on the surface, or as
// far from several faces), the same a rounding away, and points at random in and about the body.
std::vector<Vec3> queries(const TetMesh& mesh, int random, std::mt19937& generator) {
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
    for (double& x : near) x += 4e-16 * (2.0 * uniform(generator) - 1.0) * (high - low).maxCoeff();
    points.push_back(near);
  }
  // A few hundred degenerate points a body say all that thousands would.
  std::shuffle(points.begin(), points.end(), generator);
  points.resize(std::min(points.size(), static_cast<std::size_t>(random)));
  for (int k = 0; k < random; ++k) {
    const Vec3 share(uniform(generator), uniform(generator), uniform(generator));
    points.push_back(low + (1.2 * share.array() - 0.1).matrix().cwiseProduct(high - low));
  }
  return points;
}

// What the solver's detection says of points in a body at rest: −1 for no contact.
struct Detected {
  double depth = -1.0;  // m
  Vec3 normal = Vec3::Zero();
};

std::vector<Detected> ask_solver(const TetMesh& mesh, const std::vector<Vec3>& points,
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
  std::vector<Detected> by_vertex(static_cast<std::size_t>(scene.vertex_count()));
  for (const PairContact& contact : workspace.pairs) {
    by_vertex[static_cast<std::size_t>(contact.vertex)] = {contact.depth, contact.normal};
  }
  std::vector<Detected> answers;
  for (std::size_t k = 0; k < points.size(); ++k) {
    answers.push_back(by_vertex[static_cast<std::size_t>(scene.scene_vertex[k])]);
  }
  return answers;
}

// The lengths of all tetrahedra's six edges, m: a shared edge stands once for each of them.
std::vector<double> edge_lengths(const TetMesh& mesh) {
  std::vector<double> lengths;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    for (int k = 0; k < 4; ++k) {
      for (int j = 0; j < k; ++j) {
        lengths.push_back(
            (mesh.vertices.col(mesh.tetrahedra(k, e)) - mesh.vertices.col(mesh.tetrahedra(j, e)))
                .norm());
      }
    }
  }
  return lengths;
}

double mean_edge(const TetMesh& mesh) {
  const std::vector<double> lengths = edge_lengths(mesh);
  return std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(lengths.size());
}

}  // namespace

void DetectionComparison::add(const DetectionComparison& other) {
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
  shallowest = std::min(shallowest, other.shallowest);
}

DetectionComparison compare_detection(const TetMesh& mesh, int random, std::mt19937& generator,
                                      const Settings& settings) {
  const std::vector<Vec3> points = queries(mesh, random, generator);
  const std::vector<Detected> answers = ask_solver(mesh, points, settings);
  const reference::ExactBody exact(mesh);
  const double edge = mean_edge(mesh);
  const double size =
      (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff()).maxCoeff();
  DetectionComparison seen;
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
      seen.wrong_beyond += distance > (kMargin + kDetectionRounding) * size;
    }
    if (side != Side::inside || !touches) continue;
    // A depth as long as the distance that ends on the surface is one to a nearest place, of which
    // there may be several.
    const Vec3 foot = points[k] + depth * answers[k].normal;
    seen.foot_error =
        std::max(seen.foot_error, std::sqrt(exact.closest_point(foot).squared_distance) / size);
    const double error = std::abs(depth - distance) / size;
    if (error <= kDetectionRounding) {
      seen.depth_error = std::max(seen.depth_error, error);
      continue;
    }
    ++seen.not_nearest;
    seen.shallowest = std::min(seen.shallowest, distance / edge);
  }
  return seen;
}

TetMesh shaken(TetMesh mesh, double share, std::mt19937& generator) {
  const std::vector<double> lengths = edge_lengths(mesh);
  const double shortest = *std::min_element(lengths.begin(), lengths.end());
  for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
    for (int k = 0; k < 3; ++k) {
      mesh.vertices(k, v) += share * shortest * (2.0 * uniform(generator) - 1.0) / 1.8;
    }
  }
  return mesh;
}

}  // namespace stiction
