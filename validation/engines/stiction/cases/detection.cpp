// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <random>
#include <string>
#include <vector>

#include "reference/meshes/ball_mesh.h"
#include "reference/meshes/box_mesh.h"
#include "reference/meshes/nonconvex_shapes.h"
#include "validation/core/case_run.h"
#include "validation/engines/stiction/detection_comparison.h"

namespace stiction {

namespace {

constexpr const char* kDetectionSource = "CGAL: side and closest point in rationals";

struct NamedMesh {
  std::string name;
  TetMesh mesh;
};

std::vector<NamedMesh> bodies() {
  return {{"box of 3 cells", reference::box_mesh(Vec3(0.1, 0.1, 0.1), {3, 3, 3})},
          {"block of 4 cells", reference::box_mesh(Vec3(0.1, 0.1, 0.1), {4, 4, 4})},
          {"plate of one layer", reference::box_mesh(Vec3(0.2, 0.2, 0.01), {4, 4, 1})},
          {"sheet of two layers", reference::box_mesh(Vec3(0.2, 0.2, 0.002), {4, 4, 2})},
          {"ball", reference::ball_mesh({.radius = 0.1, .frequency = 4})},
          {"jack", reference::shape_mesh(reference::Shape::jack, 0.02)},
          {"hook, finer", reference::shape_mesh(reference::Shape::u, 0.02, 2)}};
}

std::string words(const std::string& name, const DetectionComparison& seen) {
  std::string note = fmt::format(
      "{}: {} points, {} inside, {} on the surface, {} as near to several places; {} on "
      "another side than the exact one, at most {:.0e} of the body's size away; largest errors "
      "of depth {:.0e} and foot {:.0e} of the size",
      name, seen.points, seen.inside, seen.boundary, seen.ties, seen.wrong_side,
      seen.farthest_wrong, seen.depth_error, seen.foot_error);
  if (seen.not_nearest > 0) {
    note +=
        fmt::format("; {} depths are not to the nearest place, the shallowest {:.2f} edges deep",
                    seen.not_nearest, seen.shallowest);
  }
  return note;
}

void check_sides(CaseRun& run, const DetectionComparison& all) {
  run.check({.quantity = "points found on the wrong side",
             .unit = "1",
             .statement = "a vertex touches a body exactly if it is in one of its tetrahedra",
             .formula = "count = 0",
             .source = kDetectionSource,
             .kind = ReferenceKind::kExactComputed,
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "a count; left out is what lies within 1e-12 (the solver's margin) + 3e-13 "
                       "(rounding of a weight) of the body's size from the surface"},
            static_cast<double>(all.wrong_beyond),
            fmt::format("{} of {} points, none farther than {:.0e} of the size", all.wrong_side,
                        all.points, all.farthest_wrong));
}

void check_depths(CaseRun& run, const DetectionComparison& all) {
  run.check(
      {.quantity = "depths to another than the nearest place",
       .unit = "1",
       .statement =
           "the depth is the distance from the surface, however deep, in thin bodies as well",
       .formula = "count = 0",
       .source = kDetectionSource,
       .kind = ReferenceKind::kExactComputed,
       .expected = 0.0,
       .tolerance = 0.0,
       .reason = "a count; a place counts as nearest within 3e-13 (rounding) of the body's size"},
      static_cast<double>(all.not_nearest),
      all.not_nearest > 0 ? fmt::format("the shallowest {:.2f} mean edges deep", all.shallowest)
                          : "");
  run.check({.quantity = "distance of x + d n from the surface",
             .unit = "1",
             .statement = "the depth vector ends on the surface",
             .formula = "dist(x + d n)/size = 0",
             .source = kDetectionSource,
             .kind = ReferenceKind::kExactComputed,
             .expected = 0.0,
             .tolerance = kDetectionRounding,
             .reason = "thirty roundings over a volume a hundred times below a cube's"},
            all.foot_error);
}

void run_detection(CaseRun& run, int random) {
  std::mt19937 generator(1);
  DetectionComparison all;
  for (const auto& [name, mesh] : bodies()) {
    for (const bool shake : {false, true}) {
      const DetectionComparison seen = compare_detection(
          shake ? shaken(mesh, 0.1, generator) : mesh, random, generator, run.settings());
      run.note(words(shake ? name + ", shaken" : name, seen));
      all.add(seen);
    }
  }
  check_sides(run, all);
  check_depths(run, all);
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
