// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/protocol/problem_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "solver/demand.h"
#include "validation/engine/kit/array_json.h"

namespace stiction {

namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& who, const std::string& what) {
  throw InputError(who + ": " + what);
}

double finite(const std::string& who, const char* what, double value) {
  if (!std::isfinite(value)) refuse(who, fmt::format("its {} is not a finite number", what));
  return value;
}

double above_zero(const std::string& who, const char* what, double value) {
  if (!(finite(who, what, value) > 0.0)) {
    refuse(who, fmt::format("its {} must be above 0, not {}", what, value));
  }
  return value;
}

double not_negative(const std::string& who, const char* what, double value) {
  if (!(finite(who, what, value) >= 0.0)) {
    refuse(who, fmt::format("its {} must not be below 0, not {}", what, value));
  }
  return value;
}

json vector(const std::string& who, const char* what, const Vec3& v) {
  for (int i = 0; i < 3; ++i) finite(who, what, v[i]);
  return {v.x(), v.y(), v.z()};
}

json unit(const std::string& who, const char* what, const Vec3& v) {
  if (!(std::abs(v.norm() - 1.0) < 1e-9)) {
    refuse(who, fmt::format("its {} must have length 1", what));
  }
  return vector(who, what, v);
}

json over_time(const std::string& who, const char* what, const std::vector<double>& time,
               const std::vector<Vec3>& value, const Oscillation& oscillation) {
  if (time.size() != value.size()) refuse(who, fmt::format("its {} has not a value a time", what));
  json values = json::array();
  for (std::size_t k = 0; k < time.size(); ++k) {
    finite(who, what, time[k]);
    if (k > 0 && !(time[k] > time[k - 1])) {
      refuse(who, fmt::format("the times of its {} must increase", what));
    }
    values.push_back(vector(who, what, value[k]));
  }
  json out = {{"time", time}, {"value", values}};
  if (oscillation.moves()) {
    out["oscillation"] = {{"amplitude", vector(who, what, oscillation.amplitude)},
                          {"frequency", not_negative(who, what, oscillation.frequency)},
                          {"phase", finite(who, what, oscillation.phase)},
                          {"begins", finite(who, what, oscillation.begins)},
                          {"full_from", finite(who, what, oscillation.full_from)}};
  }
  return out;
}

json motion_json(const std::string& who, const Motion& motion) {
  json out = over_time(who, "motion", motion.time, motion.offset, motion.oscillation);
  if (!motion.velocity.isZero(0.0)) out["velocity"] = vector(who, "motion", motion.velocity);
  return out;
}

struct ShapeWriter {
  const std::string& who;
  json operator()(const BoxShape& box) const {
    for (int i = 0; i < 3; ++i) above_zero(who, "size", box.size[i]);
    return {{"box", {{"size", vector(who, "size", box.size)}}}};
  }
  json operator()(const BallShape& ball) const {
    return {{"ball", {{"radius", above_zero(who, "radius", ball.radius)}}}};
  }
  json operator()(const PointShape&) const { return {{"point", json::object()}}; }
  json operator()(const MeshShape& shape) const {
    const Eigen::Matrix3Xd& vertices = shape.mesh.vertices;
    if (!vertices.allFinite()) refuse(who, "a vertex of its mesh is not a finite number");
    json corners = json::array();
    for (const int corner : shape.mesh.tetrahedra.reshaped()) corners.push_back(corner);
    return {{"mesh",
             {{"vertices",
               kit::write_array(vertices.data(), static_cast<std::size_t>(vertices.size()))},
              {"tetrahedra", corners},
              {"convex", shape.convex}}}};
  }
};

json body_json(const ProblemBody& body) {
  const std::string who = "body '" + body.name + "'";
  const Eigen::Quaterniond& q = body.rotation;
  if (!(std::abs(q.norm() - 1.0) < 1e-9)) refuse(who, "its rotation must be a unit quaternion");
  json out = {
      {"name", body.name},
      {"shape", std::visit(ShapeWriter{who}, body.shape)},
      {"mass", above_zero(who, "mass", body.mass)},
      {"elasticity",
       {{"youngs_modulus", above_zero(who, "Young's modulus", body.elasticity.youngs_modulus)},
        {"poisson_ratio", finite(who, "Poisson's ratio", body.elasticity.poisson_ratio)},
        {"damping_time", not_negative(who, "damping time", body.elasticity.damping_time)}}},
      {"position", vector(who, "position", body.position)},
      {"rotation", {q.w(), q.x(), q.y(), q.z()}},
      {"velocity", vector(who, "velocity", body.velocity)},
      {"angular_velocity", vector(who, "angular velocity", body.angular_velocity)},
      {"motion", motion_json(who, body.motion)},
      {"self_collision", body.self_collision},
      {"must_deform", body.must_deform}};
  if (body.held) {
    out["held"] = {{"point", vector(who, "held part", body.held->point)},
                   {"normal", vector(who, "held part", body.held->normal)}};
  }
  return out;
}

json obstacle_json(const Obstacle& obstacle) {
  const std::string who = "obstacle '" + obstacle.name + "'";
  return {{"name", obstacle.name},
          {"point", vector(who, "point", obstacle.point)},
          {"normal", unit(who, "normal", obstacle.normal)},
          {"friction", not_negative(who, "friction", obstacle.friction)},
          {"motion", motion_json(who, obstacle.motion)}};
}

json load_json(const Load& load) {
  const std::string who = "a load";
  return {
      {"body", load.body},
      {"force", over_time(who, "force", load.force.time, load.force.value, load.force.oscillation)},
      {"couple",
       over_time(who, "couple", load.couple.time, load.couple.value, load.couple.oscillation)}};
}

json spring_json(const Spring& spring) {
  const std::string who = "a spring";
  return {{"body", spring.body},
          {"anchor", vector(who, "anchor", spring.anchor)},
          {"anchor_velocity", vector(who, "anchor's velocity", spring.anchor_velocity)},
          {"axis", unit(who, "axis", spring.axis)},
          {"stiffness", not_negative(who, "stiffness", spring.stiffness)}};
}

// What an engine need not know of where it is not asked for is left out.
void add_contacts_of_their_own(const std::string& who, const Problem& problem, json& out) {
  json pairs = json::array();
  for (const PairFriction& pair : problem.pair_friction) {
    const std::size_t others = pair.against_body ? problem.bodies.size() : problem.obstacles.size();
    if (pair.body >= problem.bodies.size() || pair.other >= others) {
      refuse(who, "a pair's friction is of what is not there");
    }
    pairs.push_back({{"body", pair.body},
                     {"other", pair.other},
                     {"against_body", pair.against_body},
                     {"friction", not_negative(who, "a pair's friction", pair.friction)}});
  }
  if (!pairs.empty()) out["pair_friction"] = pairs;
  if (problem.restitution != 0.0) {
    out["restitution"] = not_negative(who, "restitution", problem.restitution);
  }
}

}  // namespace

json problem_json(const Problem& problem) {
  const std::string who = "problem '" + problem.name + "'";
  const auto demand_body = [&](std::size_t body) {
    if (body >= problem.bodies.size()) refuse(who, "a load acts on a body that is not there");
  };
  json bodies = json::array(), obstacles = json::array(), loads = json::array(),
       springs = json::array();
  if (problem.bodies.empty()) refuse(who, "it has no bodies");
  for (const ProblemBody& body : problem.bodies) bodies.push_back(body_json(body));
  for (const Obstacle& obstacle : problem.obstacles) obstacles.push_back(obstacle_json(obstacle));
  for (const Load& load : problem.loads) {
    demand_body(load.body);
    loads.push_back(load_json(load));
  }
  for (const Spring& spring : problem.springs) {
    demand_body(spring.body);
    springs.push_back(spring_json(spring));
  }
  json out = {{"name", problem.name},
              {"bodies", bodies},
              {"obstacles", obstacles},
              {"gravity", over_time(who, "gravity", problem.gravity.time,
                                    problem.gravity.acceleration, problem.gravity.oscillation)},
              {"drag",
               {{"rate", not_negative(who, "drag", problem.drag.rate)},
                {"full_until", finite(who, "drag", problem.drag.full_until)},
                {"ends", finite(who, "drag", problem.drag.ends)}}},
              {"loads", loads},
              {"springs", springs},
              {"friction", not_negative(who, "friction", problem.friction)},
              {"duration", finite(who, "duration", problem.duration)}};
  add_contacts_of_their_own(who, problem, out);
  return out;
}

std::string problem_summary(const Problem& problem) {
  json summary = problem_json(problem);
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const auto* const shape = std::get_if<MeshShape>(&problem.bodies[b].shape);
    if (shape == nullptr) continue;
    const std::string who = "body '" + problem.bodies[b].name + "'";
    const Eigen::Matrix3Xd& vertices = shape->mesh.vertices;
    if (vertices.cols() == 0) refuse(who, "its mesh has no vertices");
    summary["bodies"][b]["shape"] = {
        {"mesh",
         {{"vertices", vertices.cols()},
          {"tetrahedra", shape->mesh.tetrahedra.cols()},
          {"convex", shape->convex},
          {"low", vector(who, "mesh", vertices.rowwise().minCoeff())},
          {"high", vector(who, "mesh", vertices.rowwise().maxCoeff())}}}};
  }
  return summary.dump();
}

json accuracy_json(const Accuracy& accuracy) {
  return {{"fineness", accuracy.fineness},
          {"roundness", accuracy.roundness},
          {"time", accuracy.time},
          {"finer", accuracy.finer}};
}

}  // namespace stiction
