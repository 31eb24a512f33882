// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/passage_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace stiction {

namespace {

double time_of(const Engine& engine) {
  return static_cast<double>(engine.steps_done()) * engine.time_step();
}

// Of places: squares of their distances and products of three are numbers, as the exact predicates
// that are asked about them want.
constexpr double kFarthest = 1e60;  // m

bool has_extension(const ProblemBody& body) {
  return !std::holds_alternative<PointShape>(body.shape);
}

// A search for a threshold begins with the same bodies each time, and a thickness asks a hundred rays: found
// once for all simulations of the program.
double thickness_of(const reference::Skin& skin) {
  if (skin.triangles().cols() == 0) return 0.0;
  const auto triangles = skin.triangles().reshaped();
  const auto vertices = skin.vertices().reshaped();
  std::pair key(std::vector<int>(triangles.begin(), triangles.end()),
                std::vector<double>(vertices.begin(), vertices.end()));
  // Of a few, for runs of many scenes; never destroyed, as threads may outlive main.
  constexpr std::size_t kMost = 64;
  static auto& known = *new std::map<decltype(key), double>;
  static auto& of_known = *new std::mutex;
  {
    const std::lock_guard lock(of_known);
    if (const auto found = known.find(key); found != known.end()) return found->second;
  }
  const double thickness = skin.thickness();
  const std::lock_guard lock(of_known);
  if (known.size() >= kMost) known.clear();
  return known.emplace(std::move(key), thickness).first->second;
}

}  // namespace

PassageWatch::PassageWatch(const Problem& problem)
    : problem_(problem),
      told_(problem.bodies.size() * (problem.bodies.size() + problem.obstacles.size()), false) {}

void PassageWatch::look(const Engine& engine, bool at_end) {
  const auto wait_for = [&](double time) {
    due_step_ = engine.steps_done() +
                std::max<std::uint64_t>(1, static_cast<std::uint64_t>(time / engine.time_step()));
  };
  wait_for(kLongest);
  const std::size_t bodies = problem_.bodies.size();
  std::vector<BodyMotion> motion;
  std::vector<Eigen::Matrix3Xd> vertices;
  for (std::size_t b = 0; b < bodies; ++b) {
    motion.push_back(engine.body(b));
    vertices.push_back(engine.vertices(b));
    // What has diverged is told by the engine, and has no inside.
    if (!motion.back().position.allFinite()) return;
    if (!(motion.back().position.array().abs() <= kFarthest).all() ||
        !(vertices.back().array().abs() <= kFarthest).all()) {
      tell_of_flight(time_of(engine), b);
      return;
    }
  }
  if (skins_.empty()) {
    for (std::size_t b = 0; b < bodies; ++b) {
      skins_.emplace_back(engine.surface(b), vertices[b]);
      thickness_.push_back(thickness_of(skins_.back()));
    }
  } else {
    for (std::size_t b = 0; b < bodies; ++b) skins_[b].move(vertices[b]);
  }
  double wait = kLongest;
  for (std::size_t a = 0; a < bodies; ++a) {
    for (std::size_t b = 0; b < bodies; ++b) {
      if (a == b || thickness_[a] == 0.0 || thickness_[b] == 0.0) continue;
      const double speed = (motion[a].velocity - motion[b].velocity).norm();
      const double most = 0.4 * thickness_[b];
      const double standing = 0.25 * thickness_[b] + 2.0 * speed * engine.time_step();
      look_at_pair(time_of(engine), a, b, at_end ? std::min(standing, most) : most);
      wait = std::min(wait, 0.5 * (thickness_[a] + thickness_[b]) / std::max(speed, 1e-9));
    }
  }
  look_at_obstacles(time_of(engine), motion);
  wait_for(wait);
}

void PassageWatch::tell_of_flight(double time, std::size_t body) {
  if (flown_) return;
  flown_ = true;
  found_.push_back(
      fmt::format("'{}' is more than {:g} m away, or nowhere, at t = {:.3g} s: whether it has "
                  "passed through anything is not known",
                  problem_.bodies[body].name, kFarthest, time));
}

void PassageWatch::look_at_pair(double time, std::size_t a, std::size_t b, double allowed) {
  const std::size_t bodies = problem_.bodies.size();
  const std::size_t pair = std::min(a, b) * bodies + std::max(a, b);
  if (told_[pair]) return;
  const auto overlap = reference::deepest(skins_[a], skins_[b], allowed);
  if (!overlap) return;
  told_[pair] = true;
  const std::string depth = fmt::format("{:.3g} mm", 1e3 * overlap->depth);
  const std::string& one = problem_.bodies[a].name;
  const std::string& other = problem_.bodies[b].name;
  found_.push_back(
      overlap->by_an_edge
          ? fmt::format("'{}' passes through '{}', {} deep, at t = {:.3g} s", one, other, depth,
                        time)
          : fmt::format("'{}' is {} inside '{}' at t = {:.3g} s", one, depth, other, time));
}

void PassageWatch::look_at_obstacles(double time, const std::vector<BodyMotion>& motion) {
  const std::size_t bodies = problem_.bodies.size();
  for (std::size_t o = 0; o < problem_.obstacles.size(); ++o) {
    const Obstacle& obstacle = problem_.obstacles[o];
    for (std::size_t b = 0; b < bodies; ++b) {
      const std::size_t told = bodies * bodies + o * bodies + b;
      if (told_[told] || !has_extension(problem_.bodies[b])) continue;
      const Vec3 plane = obstacle.point + obstacle.motion.at(time);
      const double height = obstacle.normal.dot(motion[b].position - plane);
      if (!(height < 0.0)) continue;
      told_[told] = true;
      found_.push_back(fmt::format("the centre of '{}' is {:.3g} mm beneath '{}' at t = {:.3g} s",
                                   problem_.bodies[b].name, -1e3 * height, obstacle.name, time));
    }
  }
}

}  // namespace stiction
