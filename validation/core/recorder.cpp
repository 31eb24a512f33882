// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/recorder.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "validation/observe/observe.h"

namespace stiction {

namespace {

constexpr double kFlownOff =
    50.0;  // sizes of the first frame: a quantum is then a thousandth of it

Triple triple(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

double time_of(const Engine& engine) {
  return static_cast<double>(engine.steps_done()) * engine.time_step();
}

Vec3 vector(const Triple& t) { return {t[0], t[1], t[2]}; }

}  // namespace

Recorder::Recorder(const Problem& problem) : gravity_(problem.gravity) {
  recording_.title = problem.name;
  for (const ProblemBody& body : problem.bodies) recording_.bodies.push_back({body.name, 0, {}});
  for (const Obstacle& obstacle : problem.obstacles) {
    if (obstacle.motion.moves()) continue;
    recording_.planes.push_back({obstacle.name, triple(obstacle.point), triple(obstacle.normal)});
  }
}

void Recorder::start(const Engine& engine, double interval) {
  bool anything = false;
  for (std::size_t b = 0; b < recording_.bodies.size(); ++b) {
    const Eigen::Matrix3Xi surface = engine.surface(b);
    std::vector<Eigen::Index> shown;
    std::vector<std::int64_t> place;  // among the shown, by vertex; −1 where it is not
    FrameBody& body = recording_.bodies[b];
    for (Eigen::Index t = 0; t < surface.cols(); ++t) {
      std::array<std::uint32_t, 3> triangle{};
      for (int k = 0; k < 3; ++k) {
        const auto vertex = static_cast<std::size_t>(surface(k, t));
        if (vertex >= place.size()) place.resize(vertex + 1, -1);
        if (place[vertex] < 0) {
          place[vertex] = static_cast<std::int64_t>(shown.size());
          shown.push_back(surface(k, t));
        }
        triangle[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(place[vertex]);
      }
      body.triangles.push_back(triangle);
    }
    body.vertices = shown.size();
    anything = anything || !shown.empty();
    shown_.push_back(std::move(shown));
  }
  if (!anything) return;
  begin_ = time_of(engine);
  interval_ = interval;
  take(engine);
  if (!has_frames()) return;
  Eigen::AlignedBox3d box;
  for (const Triple& position : recording_.frames.front().positions) box.extend(vector(position));
  centre_ = box.center();
  size_ = box.diagonal().norm();
}

void Recorder::take(const Engine& engine) {
  Frame frame;
  frame.time = time_of(engine);
  frame.gravity = triple(gravity_.at(frame.time));
  const double reach = has_frames() ? kFlownOff * size_ : std::numeric_limits<double>::max();
  bool flown_off = false;
  for (std::size_t b = 0; b < shown_.size(); ++b) {
    const Eigen::Matrix3Xd vertices = engine.vertices(b);
    for (const Eigen::Index v : shown_[b]) {
      frame.positions.push_back(triple(vertices.col(v)));
      // NaN is out of reach as well.
      flown_off = flown_off || !((vertices.col(v) - centre_).norm() <= reach);
    }
  }
  if (flown_off) {
    due_step_ = kNever;
    return;
  }
  for (const ContactSample& contact : contacts_if_told(engine)) {
    const bool shown = contact.normal_force > 0.0 && std::isfinite(contact.normal_force) &&
                       contact.position.allFinite() && contact.friction_force.allFinite();
    if (!shown) continue;
    frame.contacts.push_back({triple(contact.position),
                              triple(contact.normal_force * contact.normal),
                              triple(contact.friction_force), contact.sticks});
  }
  recording_.frames.push_back(std::move(frame));
  // One that is not past: the interval may be shorter than a step.
  do {
    ++taken_;
    due_step_ = static_cast<std::uint64_t>(
        std::llround((begin_ + static_cast<double>(taken_) * interval_) / engine.time_step()));
  } while (due_step_ <= engine.steps_done());
}

}  // namespace stiction
