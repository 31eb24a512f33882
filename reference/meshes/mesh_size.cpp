// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stiction::reference {

namespace {

constexpr double kPerCube = 5.0;  // tetrahedra in a cube of edge h

// Away from zero, to two digits.
double rounded_up(double length) {
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
  return std::ceil(length / unit) * unit;
}

}  // namespace

double MeshSize::thickness() const { return 2.0 * volume / area; }

double MeshSize::tetrahedra() const {
  const double h = std::min(cell_size, thickness());
  return kPerCube * volume / (h * h * h);
}

std::string MeshSize::advice(double most, double unit) const {
  const double needed = std::cbrt(kPerCube * volume / most);
  if (needed <= thickness()) {
    return fmt::format("choose a cell_size of {:.2g} m or more, or raise most_tetrahedra",
                       rounded_up(needed * unit));
  }
  return fmt::format(
      "it is about {:.2g} m thin, which no cell_size helps; give it a thicker shape, or raise "
      "most_tetrahedra",
      thickness() * unit);
}

std::string in_words(double count) {
  if (count >= 1e15) return fmt::format("{:.1e}", count);
  if (count >= 1e6) return fmt::format("{:.3g} million", 1e-6 * count);
  if (count < 1e4) return fmt::format("{:.0f}", count);
  const auto whole = static_cast<long>(count);
  return fmt::format("{} {:03}", whole / 1000, whole % 1000);
}

}  // namespace stiction::reference
