// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/surface_shape.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "reference/meshes/closed_surface.h"
#include "reference/meshes/mesh_size.h"
#include "reports/screen/program.h"
#include "reports/screen/status_line.h"
#include "reports/text/number.h"
#include "validation/user/user_problem.h"

namespace stiction {

namespace {

// What takes less is not worth a line.
constexpr double kSoonShown = 0.5, kSoonTold = 3.0;  // s

class MeshingStatus {
 public:
  explicit MeshingStatus(std::string file) : file_(std::move(file)) {}

  void clear() { line_.clear(); }

  void show(const reference::MeshingProgress& now) {
    std::string text = "meshing " + file_;
    if (now.tetrahedra > 0.0) {
      text += ": about " + reference::in_words(now.tetrahedra) + " tetrahedra";
    }
    if (line_.is_seen()) {
      if (now.seconds >= kSoonShown) line_.show(text + " · " + duration_text(now.seconds));
    } else if (now.seconds >= kSoonTold && !told_) {
      tell(text);
      told_ = true;
    }
  }

 private:
  std::string file_;
  StatusLine line_;
  bool told_ = false;
};

reference::SurfaceOptions read_options(TomlTable& table) {
  reference::SurfaceOptions options;
  options.unit = table.number("scale", 1.0);
  if (!(options.unit > 0.0)) table.refuse("scale", "'scale' must be positive");
  // The mesher sees the file's own units.
  options.cell_size = table.number("cell_size", options.cell_size) / options.unit;
  options.feature_angle = table.number("feature_angle_deg", options.feature_angle);
  constexpr double kMost = 1e9;  // beyond all memory
  const double most = table.number("most_tetrahedra", static_cast<double>(options.most_tetrahedra));
  if (!(most >= 1.0 && most <= kMost)) {
    table.refuse("most_tetrahedra", "'most_tetrahedra' must lie between 1 and 1e9");
  }
  options.most_tetrahedra = std::llround(most);
  options.time_limit = table.number("time_limit", options.time_limit);
  if (!(options.time_limit > 0.0)) table.refuse("time_limit", "'time_limit' must be positive");
  if (const std::string wrong = options.check(); !wrong.empty()) {
    table.refuse(table.has("cell_size") ? "cell_size" : "feature_angle_deg", wrong);
  }
  return options;
}

}  // namespace

MeshShape read_surface(TomlTable& table) {
  const std::filesystem::path given = table.text("file");
  reference::SurfaceOptions options = read_options(table);
  MeshingStatus status(given.filename().string());
  options.progress = [&](const reference::MeshingProgress& now) { status.show(now); };
  options.not_kept = [&](const std::string& why) {
    status.clear();
    tell(given.filename().string() +
         ": its mesh is not kept, and will be made again the next time: " + why);
  };
  try {
    MeshShape shape{reference::body_of_closed_surface(table.folder() / given, options).mesh};
    shape.mesh.vertices *= options.unit;
    return shape;
  } catch (const reference::SurfaceError& error) {
    const bool of_size = error.flaw() == reference::SurfaceFlaw::too_large;
    table.refuse(of_size && table.has("cell_size") ? "cell_size" : "file", error.what());
  } catch (const reference::MesherError& error) {
    throw NotMeshed(table.at("file", error.what()));
  }
}

}  // namespace stiction
