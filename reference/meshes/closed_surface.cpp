// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/closed_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstring>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "reference/meshes/box_mesh.h"
#include "reference/meshes/filled_surface.h"
#include "reference/meshes/mesh_cache.h"
#include "reference/process/child.h"

namespace stiction::reference {

namespace {

using Eigen::Index;

std::string exact(double number) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

std::filesystem::path mesher_for(const std::string& file) {
  try {
    return find_mesher(mesher_places());
  } catch (const MesherError& error) {
    throw MesherError(file + ": " + error.what());
  }
}

// What is no file may have no end, and large files are no sooner read than meshed.
bool is_remembered(const std::filesystem::path& file) {
  constexpr std::uintmax_t kMost = 64 << 20;  // bytes
  std::error_code none;
  return std::filesystem::is_regular_file(file, none) &&
         std::filesystem::file_size(file, none) <= kMost;
}

// All that a mesh follows from; the unit is for sentences alone.
MeshOrigin origin_of(const std::filesystem::path& file, const std::string& mesher,
                     const SurfaceOptions& options) {
  std::string words;
  for (const double one :
       {options.cell_size, options.facet_distance, options.feature_angle,
        static_cast<double>(options.seed), static_cast<double>(options.most_tetrahedra)}) {
    words += exact(one) + " ";
  }
  return {content_of(file), file.extension().string(), words, content_of(mesher)};
}

// What the mesher has told on stderr so far.
struct Expected {
  double tetrahedra = 0.0;
  double cell_size = 0.0;  // m
};

Expected expected_in(const std::string& errors) {
  Expected expected;
  std::string word;
  std::istringstream(errors) >> word >> expected.tetrahedra >> expected.cell_size;
  return word == kExpected ? expected : Expected{};
}

std::function<void(double, const Ended&)> meanwhile(const SurfaceOptions& options) {
  if (!options.progress) return {};
  return [&options](double seconds, const Ended& so_far) {
    options.progress({seconds, expected_in(so_far.errors).tetrahedra});
  };
}

FilledSurface fill(const std::string& file, const SurfaceOptions& options) {
  const auto fail = [&](const std::string& what) {
    throw MesherError(file + ": the mesher " + what);
  };
  const std::string mesher = mesher_for(file).string();
  const MeshCache cache(is_remembered(file) ? mesh_cache_folder() : "");
  MeshOrigin origin;
  if (is_remembered(file)) origin = origin_of(file, mesher, options);
  if (std::optional<FilledSurface> known = cache.find(origin)) return *std::move(known);
  Ended ended;
  try {
    ended = run_child(
        {mesher, "--cell-size", exact(options.cell_size), "--facet-distance",
         exact(options.facet_distance), "--feature-angle", exact(options.feature_angle), "--seed",
         std::to_string(options.seed), "--most-tetrahedra", std::to_string(options.most_tetrahedra),
         "--unit", exact(options.unit), "--", file},
        {.time_limit = options.time_limit, .meanwhile = meanwhile(options)});
  } catch (const ChildError& error) {
    fail(std::string("can't be run: ") + error.what());
  }
  const std::string sentence = last_line(ended.errors);
  if (ended.code == kNoSuchProgram) fail("can't be run: there is no program '" + mesher + "'");
  if (ended.timed_out) {
    const std::string stopped = "was stopped after " + exact(options.time_limit) + " s";
    const double cell = expected_in(ended.errors).cell_size;
    if (!(cell > 0.0)) {
      fail(stopped +
           ", still reading or checking the triangles: give a surface of fewer, or raise "
           "time_limit");
    }
    fail(stopped + ": choose a larger cell_size, such as " +
         fmt::format("{:.3g} m", 2.0 * cell * options.unit) + ", or raise time_limit");
  }
  if (ended.signal == SIGKILL) {
    fail("was killed (signal 9), as happens when memory runs out: choose a larger cell_size");
  }
  if (ended.signal != 0) {
    fail("ended with signal " + std::to_string(ended.signal) + " (" + strsignal(ended.signal) +
         ")");
  }
  const int flaw = ended.code - kFirstFlaw;
  if (flaw >= 0 && flaw < kSurfaceFlaws) {
    throw SurfaceError(static_cast<SurfaceFlaw>(flaw), sentence);
  }
  if (ended.code != kFilled) {
    fail("failed: " + (sentence.empty() ? "exit code " + std::to_string(ended.code) : sentence));
  }
  FilledSurface filled;
  try {
    filled = filled_surface_from(ended.output);
  } catch (const std::invalid_argument& error) {
    fail(std::string("wrote no mesh: ") + error.what());
  }
  const std::string why_not = cache.keep(origin, filled);
  if (!why_not.empty() && options.not_kept) options.not_kept(why_not);
  return filled;
}

double mean_edge(const TetMesh& mesh) {
  std::set<std::pair<int, int>> edges;
  for (Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    const Eigen::Vector4i t = mesh.tetrahedra.col(e);
    for (int k = 0; k < 4; ++k) {
      for (int j = 0; j < k; ++j) edges.insert(std::minmax(t[j], t[k]));
    }
  }
  double sum = 0.0;
  for (const auto& [p, q] : edges) sum += (mesh.vertices.col(p) - mesh.vertices.col(q)).norm();
  return sum / static_cast<double>(edges.size());
}

}  // namespace

std::string SurfaceOptions::check() const {
  if (!(cell_size >= 0.0) || !std::isfinite(cell_size)) return "cell_size must be finite, ≥ 0";
  if (!(facet_distance >= 0.0) || !std::isfinite(facet_distance)) {
    return "facet_distance must be finite, ≥ 0";
  }
  if (!(feature_angle > 0.0 && feature_angle < 180.0)) {
    return "the feature angle must lie between 0° and 180°";
  }
  if (!(unit > 0.0) || !std::isfinite(unit)) return "unit must be positive and finite";
  if (most_tetrahedra <= 0) return "most_tetrahedra must be positive";
  if (!(time_limit > 0.0)) return "time_limit must be positive";
  return {};
}

SurfaceBody body_of_closed_surface(const std::filesystem::path& file,
                                   const SurfaceOptions& options) {
  if (const std::string wrong = options.check(); !wrong.empty()) {
    throw std::invalid_argument("closed surface: " + wrong);
  }
  FilledSurface filled = fill(file.string(), options);
  SurfaceBody body;
  body.mesh = std::move(filled.mesh);
  const auto demand = [&](bool holds, const char* what) {
    if (!holds) throw SurfaceError(SurfaceFlaw::not_meshed, file.string() + ": " + what);
  };
  demand(body.mesh.tetrahedra.cols() > 0, "no tetrahedron fits: choose a smaller cell_size");
  const MeshCertificate certificate = certify(body.mesh);
  demand(certificate.non_positive_tetrahedra == 0 && certificate.non_manifold_faces == 0 &&
             certificate.boundary_closed,
         "the mesh is not sound: choose a smaller cell_size");
  body.report.given_triangles = filled.given_triangles;
  body.report.given_volume = filled.given_volume;
  body.report.vertices = body.mesh.vertices.cols();
  body.report.tetrahedra = body.mesh.tetrahedra.cols();
  body.report.surface_triangles = certificate.boundary_triangles;
  body.report.volume = certificate.volume.nearest;
  body.report.quality = certificate.quality;
  body.report.mean_edge = mean_edge(body.mesh);
  return body;
}

}  // namespace stiction::reference
