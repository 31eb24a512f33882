// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/precision_question.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/demand.h"
#include "solver/scene/scene.h"
#include "validation/engines/stiction/stiction_scene.h"

namespace stiction {

namespace {

// 1, 2 and 5 in turn: the k-th of …, 0.5, 1, 2, 5, 10, …, the 0-th being 1.
double round_number(int k) {
  constexpr std::array<double, 3> kMantissas{1.0, 2.0, 5.0};
  const int decade = k >= 0 ? k / 3 : -((2 - k) / 3);
  // One rounding, so that 2e-4 is the number that its text says.
  const double mantissa = kMantissas[static_cast<std::size_t>(k - 3 * decade)];
  return decade >= 0 ? mantissa * std::pow(10.0, decade) : mantissa / std::pow(10.0, -decade);
}

}  // namespace

StableStep stable_step(const PrecisionQuestion& question, int cells) {
  const int fineness = question.fineness > 0 ? question.fineness : cells;
  const Scene scene = build_scene(scene_description(question.problem(cells), {.cells = fineness}));
  return {scene.stable_time_step, static_cast<double>(scene.mass.size())};
}

std::vector<double> time_steps_about(double limit, double finest) {
  demand(limit > 0.0 && std::isfinite(limit), "a stable time step is positive and finite");
  int above = static_cast<int>(std::floor(3.0 * std::log10(limit))) - 3;
  while (round_number(above) <= limit) ++above;
  std::vector<double> steps{round_number(above)};
  const double unit = std::pow(10.0, std::floor(std::log10(limit)) - 2.0);
  const double rounded = std::stod(step_text(std::floor(limit / unit) * unit));
  int below = above - 1;
  if (rounded > round_number(below)) steps.push_back(rounded);
  do {
    steps.push_back(round_number(below--));
  } while (round_number(below) >= finest * (1.0 - 1e-9));
  return steps;
}

std::string step_text(double dt) {
  const std::string text = fmt::format("{:.2e}", dt);  // "3.10e-04"
  std::string mantissa = text.substr(0, text.find('e'));
  mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (mantissa.back() == '.') mantissa.pop_back();
  return fmt::format("{}e{}", mantissa, std::stoi(text.substr(text.find('e') + 1)));
}

PrecisionReference extrapolated(const std::vector<std::array<double, 2>>& f,
                                const std::vector<double>& h) {
  demand(f.size() == 3 && h.size() == 3 && h[0] > h[1] && h[1] > h[2], "three meshes, ever finer");
  std::array<double, 3> g{};
  for (std::size_t m = 0; m < g.size(); ++m) g[m] = 2.0 * f[m][1] - f[m][0];
  const double of_step = std::abs(g[2] - f[2][1]);
  const double ratio = (g[1] - g[0]) / (g[2] - g[1]);
  const auto ratio_of = [&](double p) {
    return (std::pow(h[0], p) - std::pow(h[1], p)) / (std::pow(h[1], p) - std::pow(h[2], p));
  };
  if (!(ratio >= ratio_of(1.0) && ratio <= ratio_of(2.0))) {
    return {.value = g[2],
            .uncertainty = std::max(std::abs(g[0] - g[2]), std::abs(g[1] - g[2])) + of_step};
  }
  const auto rest_of = [&](double p) { return (g[2] - g[1]) / (std::pow(h[1] / h[2], p) - 1.0); };
  return {.value = g[2] + 0.5 * (rest_of(1.0) + rest_of(2.0)),
          .uncertainty = 0.5 * std::abs(rest_of(1.0) - rest_of(2.0)) + of_step};
}

}  // namespace stiction
