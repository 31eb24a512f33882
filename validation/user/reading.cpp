// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/reading.h"

#include <fmt/format.h>

#include <cmath>

#include "reports/text/text.h"
#include "validation/user/problem_keys.h"
#include "validation/user/read_motion.h"

namespace stiction {

std::string Names::add(TomlTable& table) {
  std::string name = table.text("name");
  if (name.empty() || name != one_line(name)) {
    table.refuse("name", "a name must be one line of plain text");
  }
  if (!numbers_.emplace(name, names_.size()).second) {
    table.refuse("name", "the name '" + name + "' is taken");
  }
  names_.push_back(name);
  return name;
}

const std::size_t* Names::find(const std::string& name) const {
  const auto found = numbers_.find(name);
  return found == numbers_.end() ? nullptr : &found->second;
}

std::size_t Names::find(TomlTable& table, const std::string& key, const std::string& what) const {
  const std::string name = table.text(key);
  if (const std::size_t* const found = find(name)) return *found;
  table.refuse(key, fmt::format("there is no {} '{}'; there are: {}", what, name, listed()));
}

std::string Names::listed() const {
  constexpr std::size_t kTold = 20;
  if (names_.empty()) return "none";
  if (names_.size() <= kTold) return fmt::format("{}", fmt::join(names_, ", "));
  return fmt::format("{} and {} more", fmt::join(names_.begin(), names_.begin() + kTold, ", "),
                     names_.size() - kTold);
}

Partner find_partner(TomlTable& table, const std::string& key, const Reading& reading) {
  const std::string name = table.text(key);
  const std::size_t* const obstacle = reading.obstacles.find(name);
  const std::size_t* const body = reading.bodies.find(name);
  if (obstacle != nullptr && body != nullptr) {
    table.refuse(key, "'" + name + "' is an obstacle and a body: give them two names");
  }
  if (obstacle != nullptr) return {*obstacle, false};
  if (body != nullptr) return {*body, true};
  table.refuse(key, fmt::format("there is no obstacle '{}', nor a body of that name above; "
                                "obstacles: {}; bodies: {}",
                                name, reading.obstacles.listed(), reading.bodies.listed()));
}

void refuse_point(TomlTable& table, const Reading& reading, const std::string& key,
                  std::size_t body) {
  const ProblemBody& one = reading.user.problem.bodies[body];
  if (!std::holds_alternative<PointShape>(one.shape)) return;
  table.refuse(key, fmt::format("'{}' is a point, which does not turn", one.name));
}

Eigen::Vector3d read_direction(TomlTable& table, const std::string& key) {
  const Eigen::Vector3d vector = table.vector(key);
  if (vector.isZero(0.0)) table.refuse(key, fmt::format("'{}' must not be zero", key));
  return vector.stableNormalized();
}

double read_friction(TomlTable& table) {
  const double friction = table.number("friction");
  if (!(friction >= 0.0)) table.refuse("friction", "'friction' must not be negative");
  return friction;
}

// rad.
double read_slope(TomlTable& table) {
  if (!table.has("slope_tan")) return table.number("slope_deg", 0.0) * kDegree;
  if (table.has("slope_deg")) {
    table.refuse("slope_tan", "give 'slope_deg' or 'slope_tan', not both");
  }
  return std::atan(table.number("slope_tan"));
}

void read_obstacle(TomlTable table, Reading& reading) {
  Obstacle obstacle;
  obstacle.name = reading.obstacles.add(table);
  obstacle.point = table.vector("point", Eigen::Vector3d::Zero());
  obstacle.friction = read_friction(table);
  const double azimuth = table.number("azimuth_deg", 0.0) * kDegree;
  if (table.has("normal")) {
    obstacle.normal = read_direction(table, "normal");
    for (const char* const slope : {"slope_deg", "slope_tan"}) {
      if (table.has(slope)) {
        table.refuse(slope, fmt::format("give 'normal' or '{}', not both", slope));
      }
    }
  } else {
    const double slope = read_slope(table);
    obstacle.normal = Eigen::Vector3d(std::sin(slope) * std::cos(azimuth),
                                      std::sin(slope) * std::sin(azimuth), std::cos(slope))
                          .normalized();
  }
  // Steepest descent; along the azimuth on level ground.
  const Eigen::Vector3d& n = obstacle.normal;
  const Eigen::Vector3d descent = -Eigen::Vector3d::UnitZ() + n.z() * n;
  const Eigen::Vector3d level(std::cos(azimuth), std::sin(azimuth), 0.0);
  const bool steep = descent.norm() > 1e-9;
  reading.user.downhill.push_back(steep ? descent.normalized()
                                        : Eigen::Vector3d((level - n.dot(level) * n).normalized()));
  reading.user.level.push_back(!steep && !table.has("azimuth_deg"));
  if (table.has("motion")) {
    obstacle.motion = read_motion(table.table("motion", problem_keys::motion()));
  }
  reading.user.problem.obstacles.push_back(obstacle);
  table.finish();
}

void read_load(TomlTable table, Reading& reading) {
  Load load;
  load.body = reading.bodies.find(table, "body", "body");
  load.force = read_force(table, "force", problem_keys::force());
  load.couple = read_force(table, "couple", problem_keys::couple());
  if (table.has("couple")) refuse_point(table, reading, "couple", load.body);
  if (!table.has("force") && !table.has("couple")) {
    table.refuse("body", "a [[load]] needs a 'force' or a 'couple'");
  }
  reading.user.problem.loads.push_back(load);
  table.finish();
}

void read_spring(TomlTable table, Reading& reading) {
  Spring spring;
  spring.body = reading.bodies.find(table, "body", "body");
  spring.anchor = table.vector("anchor");
  spring.anchor_velocity = table.vector("anchor_velocity", Eigen::Vector3d::Zero());
  spring.axis = read_direction(table, "axis");
  spring.stiffness = table.number("stiffness");
  if (!(spring.stiffness >= 0.0)) table.refuse("stiffness", "'stiffness' must not be negative");
  reading.user.problem.springs.push_back(spring);
  table.finish();
}

void read_pair(TomlTable table, Reading& reading) {
  Problem& problem = reading.user.problem;
  PairFriction pair;
  pair.body = reading.bodies.find(table, "body", "body");
  const Partner partner = find_partner(table, "against", reading);
  pair.other = partner.index;
  pair.against_body = partner.is_body;
  pair.friction = read_friction(table);
  if (pair.against_body && pair.other == pair.body && !problem.bodies[pair.body].self_collision) {
    table.refuse("against", "a body touches itself only with self_collision = true");
  }
  for (const PairFriction& other : problem.pair_friction) {
    if (other.against_body != pair.against_body) continue;
    const bool same = other.body == pair.body && other.other == pair.other;
    const bool swapped = pair.against_body && other.body == pair.other && other.other == pair.body;
    if (same || swapped) table.refuse("against", "the friction of these two is given twice");
  }
  problem.pair_friction.push_back(pair);
  table.finish();
}

}  // namespace stiction
