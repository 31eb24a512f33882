// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/stability/digits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/demand.h"

namespace stiction {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void add_vector(std::vector<Observation>& all, const std::string& name, const char* unit,
                const Vec3& value, double scale) {
  constexpr const char* kAxes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    all.push_back({fmt::format("{}, {}", name, kAxes[axis]), unit, value[axis], scale, false});
  }
}

// Values that are equal deviate by nothing, the infinite ones too; what is no number deviates
// without bound.
double standard_deviation(const std::vector<double>& values) {
  const auto same = [&](double value) { return value == values.front(); };
  if (std::all_of(values.begin(), values.end(), same)) return 0.0;
  const auto count = static_cast<double>(values.size());
  double mean = 0.0, squares = 0.0;
  for (const double value : values) mean += value / count;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double sigma = std::sqrt(squares / (count - 1.0));
  return std::isfinite(sigma) ? sigma : kInfinity;
}

// Of the runs that have it.
std::vector<double> values_of(const std::vector<std::vector<Observation>>& runs,
                              const std::string& name) {
  std::vector<double> values;
  for (const auto& run : runs) {
    const auto found = std::find_if(run.begin(), run.end(),
                                    [&](const Observation& one) { return one.name == name; });
    if (found != run.end()) values.push_back(found->value);
  }
  return values;
}

}  // namespace

std::vector<Observation> observations_of(const Record& record, const PerturbedTrace& trace) {
  std::vector<Observation> all;
  double length = 0.0, speed = 0.0;
  for (const PerturbedTrace::End& end : trace.ends) {
    length = std::max(length, end.length);
    speed = std::max(speed, end.speed);
  }
  for (const Judgement& check : record.checks) {
    const Claim& claim = check.claim;
    const std::optional<double> own = scale_of(claim);
    if (!own || claim.derived) continue;
    // A short way is a difference of places, and has no more digits than they.
    const double least = claim.unit == "m" ? length : claim.unit == "m/s" ? speed : 0.0;
    all.push_back({claim.quantity, claim.unit, check.value, std::max(*own, least)});
  }
  // A search for a threshold simulates next to it, where ends are anything.
  constexpr std::size_t kSearch = 5;
  if (trace.ends.size() >= kSearch) return all;
  for (std::size_t k = 0; k < trace.ends.size(); ++k) {
    const PerturbedTrace::End& end = trace.ends[k];
    const std::string which =
        trace.ends.size() > 1 ? fmt::format(" of simulation {}", k + 1) : std::string();
    for (std::size_t b = 0; b < end.bodies.size(); ++b) {
      const auto name = [&](const char* what) {
        return fmt::format("{} of body {} at the end{}", what, b + 1, which);
      };
      add_vector(all, name("position"), "m", end.bodies[b].position, end.length);
      add_vector(all, name("velocity"), "m/s", end.bodies[b].velocity, end.speed);
      // A turn is a difference of places across the body, and has no more digits than they.
      const double turned = end.sizes[b] > 0.0 ? std::max(1.0, end.length / end.sizes[b]) : 1.0;
      const Eigen::Matrix3d turn = end.bodies[b].rotation.toRotationMatrix();
      add_vector(all, name("own x-axis"), "1", turn.col(0), turned);
      add_vector(all, name("own y-axis"), "1", turn.col(1), turned);  // two tell the third
    }
  }
  return all;
}

Deviation unbounded(const std::string& why) { return {kInfinity, kInfinity, why}; }

Deviation deviation(const std::vector<std::vector<Observation>>& runs,
                    const std::vector<std::string>& words, bool may_lack) {
  demand(runs.size() >= 2 && runs.size() == words.size(), "two runs or more, with their words");
  Deviation found;
  std::size_t compared = 0;
  for (const Observation& first : runs[0]) {
    const std::vector<double> values = values_of(runs, first.name);
    if (values.size() < runs.size()) {
      if (may_lack || !first.is_check) continue;
      return unbounded(first.name + ": not measured in every run");
    }
    ++compared;
    const double sigma = standard_deviation(values);
    const double relative = sigma / first.scale;
    if (!(relative > found.relative)) continue;
    std::size_t farthest = 0;
    for (std::size_t r = 1; r < values.size(); ++r) {
      if (!(std::abs(values[r] - values[0]) <= std::abs(values[farthest] - values[0])))
        farthest = r;
    }
    found = {relative, sigma,
             fmt::format("{}: {:.10g} {}, not {:.10g}, when {}", first.name, values[farthest],
                         first.unit, values[0], words[farthest])};
  }
  if (compared == 0) return unbounded("the runs have no figure in common");
  return found;
}

}  // namespace stiction
