// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <random>
#include <string>
#include <vector>

#include "reference/meshes/ball_mesh.h"
#include "reference/meshes/box_mesh.h"
#include "reference/meshes/nonconvex_shapes.h"
#include "validation/core/case_run.h"
#include "validation/engines/stiction/consistent_comparison.h"
#include "validation/engines/stiction/detection_comparison.h"

namespace stiction {

namespace {

constexpr const char* kConsistentSource = "crossings in CGAL's rationals, means with 50 digits";

struct Placement {
  std::string name;
  TetMesh a, b;
};

TetMesh moved(TetMesh mesh, const Vec3& by) {
  mesh.vertices.colwise() += by;
  return mesh;
}

TetMesh turned(TetMesh mesh, double angle, const Vec3& axis) {
  mesh.vertices = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix() * mesh.vertices;
  return mesh;
}

// Sizes are powers of two, and so are all shares of them: every coordinate is exact, and what lies
// on a face, an edge or a corner does so exactly.
std::vector<Placement> degenerate() {
  const TetMesh box = reference::box_mesh(Vec3(1, 1, 1), {2, 2, 2});
  const TetMesh fine = reference::box_mesh(Vec3(1, 1, 1), {4, 4, 4});
  const TetMesh plate = reference::box_mesh(Vec3(2, 2, 0.0625), {4, 4, 1});
  const TetMesh column = reference::box_mesh(Vec3(0.5, 0.5, 2), {2, 2, 8});
  return {{"boxes flush, a sixteenth in each other", box, moved(box, Vec3(0, 0, 0.9375))},
          {"the same of other meshes", fine, moved(box, Vec3(0, 0, 0.9375))},
          {"boxes flush on each other's face", box, moved(fine, Vec3(0, 0, 1))},
          {"flush along one side", box, moved(box, Vec3(0.25, 0, 0.9375))},
          {"corner on edge", box, moved(box, Vec3(1, 1, 0.9375))},
          {"corner on corner", box, moved(box, Vec3(1, 1, 1))},
          {"corner on the diagonal of a face", box, moved(fine, Vec3(0.75, 0.75, 0.9375))},
          {"a box through a plate", plate, moved(box, Vec3(0.125, 0.25, 0.46875))},
          {"a column through a plate", plate, moved(column, Vec3(0.0625, 0.125, 0))},
          {"a column deep in a box", reference::box_mesh(Vec3(4, 4, 4), {2, 2, 2}),
           moved(column, Vec3(0.125, 0.25, 1.25))},
          {"a box within a box", moved(box, Vec3(0.25, 0, 0)),
           reference::box_mesh(Vec3(4, 4, 4), {2, 2, 2})}};
}

// Bodies in every way in each other.
std::vector<Placement> random(int count, std::mt19937& generator) {
  const TetMesh box = reference::box_mesh(Vec3(0.1, 0.1, 0.1), {3, 3, 3});
  const std::vector<TetMesh> bodies = {box,
                                       reference::box_mesh(Vec3(0.2, 0.2, 0.01), {4, 4, 1}),
                                       reference::box_mesh(Vec3(0.05, 0.05, 0.2), {2, 2, 8}),
                                       reference::ball_mesh({.radius = 0.06, .frequency = 3}),
                                       reference::shape_mesh(reference::Shape::jack, 0.04),
                                       reference::shape_mesh(reference::Shape::u, 0.04)};
  const auto uniform = [&] {
    return 2.0 * (static_cast<double>(generator()) / 4294967296.0) - 1.0;
  };
  const auto any = [&] { return Vec3(uniform(), uniform(), uniform()); };
  std::vector<Placement> placements;
  for (int k = 0; k < count; ++k) {
    const std::size_t one = generator() % bodies.size(), other = generator() % bodies.size();
    const double angle = 3.0 * uniform();
    const Vec3 axis = any(), by = 0.08 * any();
    placements.push_back({fmt::format("random {}", k), shaken(bodies[one], 0.1, generator),
                          moved(turned(shaken(bodies[other], 0.1, generator), angle, axis), by)});
  }
  return placements;
}

TetMesh ulps_off(TetMesh mesh, std::mt19937& generator) {
  for (double& x : mesh.vertices.reshaped()) {
    x += 4e-16 * (2.0 * (static_cast<double>(generator()) / 4294967296.0) - 1.0);
  }
  return mesh;
}

std::string words(const std::string& name, const ConsistentComparison& seen) {
  return fmt::format(
      "{}: {} vertices, {} with an edge that leaves, {} by their neighbours, up to level {}; {} "
      "lost, {} of another level; largest errors of depth {:.0e} m ({:.2g} of what rounding can) "
      "and direction {:.0e} rad ({:.2g})",
      name, seen.vertices, seen.border, seen.inner, seen.deepest, seen.lost, seen.other_level,
      seen.depth_error, seen.depth_excess, seen.direction_error, seen.direction_excess);
}

Claim count_claim(const std::string& quantity, const std::string& statement) {
  return {.quantity = quantity,
          .unit = "1",
          .statement = statement,
          .formula = "count = 0",
          .source = kConsistentSource,
          .kind = ReferenceKind::kExactComputed,
          .expected = 0.0,
          .tolerance = 0.0,
          .reason = "a count"};
}

Claim error_claim(const std::string& quantity, const std::string& statement) {
  return {.quantity = quantity,
          .unit = "1",
          .statement = statement,
          .formula = "|error|/bound ≤ 1",
          .source = kConsistentSource,
          .kind = ReferenceKind::kExactComputed,
          .expected = 0.0,
          .tolerance = 1.0,
          .reason =
              "the bound is 3.3e-13 (thirty roundings over a volume a hundred times below a "
              "cube's) of the size, times the derivatives of the means: a weight is the more "
              "wrong the nearer the crossing and the flatter the edge"};
}

void check_all(CaseRun& run, const std::string& of, const ConsistentComparison& seen,
               const std::string& other_level = "of another level") {
  run.check(count_claim(of + ": vertices in one answer only",
                        "what touches is what is exactly in or on the other body"),
            seen.lost);
  run.check(
      count_claim(of + ": vertices " + other_level,
                  "what has an edge that leaves, and in how many steps depths reach the rest"),
      seen.other_level);
  run.check(error_claim(of + ": error of depth over its bound",
                        "d is the weighted mean over the edges that leave, or over neighbours"),
            seen.depth_excess, fmt::format("largest error {:.1e} m", seen.depth_error));
  run.check(error_claim(of + ": error of direction over its bound",
                        "n is the direction of the weighted sum of normals"),
            seen.direction_excess, fmt::format("largest error {:.1e} rad", seen.direction_error));
}

void run_consistent(CaseRun& run, int count) {
  std::mt19937 generator(1);
  ConsistentComparison exactly, off, anywhere;
  for (const Placement& placement : degenerate()) {
    const ConsistentComparison seen =
        compare_consistent(placement.a, placement.b, placement.a, placement.b, run.settings());
    run.note(words(placement.name, seen));
    exactly.add(seen);
    ConsistentComparison apart;
    for (int k = 0; k < 4; ++k) {
      apart.add(compare_consistent(placement.a, placement.b, ulps_off(placement.a, generator),
                                   ulps_off(placement.b, generator), run.settings()));
    }
    run.note(words(placement.name + ", ulps off, four times", apart));
    off.add(apart);
  }
  for (const Placement& placement : random(count, generator)) {
    anywhere.add(
        compare_consistent(placement.a, placement.b, placement.a, placement.b, run.settings()));
  }
  run.note(words(fmt::format("{} random placements", count), anywhere));
  check_all(run, "degenerate", exactly);
  check_all(run, "ulps off", off, "reached by one of the two only");
  check_all(run, "random", anywhere);
}

}  // namespace

std::vector<Case> cases_consistent_depth() {
  return {{.name = "detection/exact-consistent",
           .title = "consistent depths against exact ones: flush, edges and corners, thin, deep",
           .variants = {{}},
           .run = [](CaseRun& run) { run_consistent(run, 40); }},
          {.name = "detection/exact-consistent/thousand",
           .title = "consistent depths against exact ones, a thousand random placements",
           .set = CaseSet::kFull,
           .variants = {{}},
           .run = [](CaseRun& run) { run_consistent(run, 1000); }}};
}

}  // namespace stiction
