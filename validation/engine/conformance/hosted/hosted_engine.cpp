// SPDX-License-Identifier: GPL-3.0-or-later
// This project's own solver as a program behind the engine protocol: what it answers through the
// pipes must be what it answers directly, to the last bit. For the tests of `engine check` a fault
// of an adapter can be planted in it: --set fault=…
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "solver/demand.h"
#include "validation/engine/engine.h"
#include "validation/engine/kit/stiction_engine.h"

namespace stiction {

namespace {

using Eigen::Map;

constexpr std::string_view kFaults[] = {"none",  "sign",   "degrees",  "gravity-twice", "swapped",
                                        "clock", "forget", "friction", "half-step",     "nan",
                                        "exit",  "finer",  "stands"};

Vec3 vec(const double v[3]) { return Vec3(v); }

VectorOverTime over_time(const stiction_keyframes& frames) {
  VectorOverTime out;
  for (std::size_t k = 0; k < frames.count; ++k) {
    out.time.push_back(frames.time[k]);
    out.value.emplace_back(frames.value[k]);
  }
  return out;
}

Shape shape_of(const stiction_body& body) {
  if (body.shape == STICTION_BOX) return BoxShape{vec(body.size)};
  if (body.shape == STICTION_BALL) return BallShape{body.radius};
  if (body.shape == STICTION_POINT) return PointShape{};
  MeshShape shape;
  shape.convex = body.convex != 0;
  shape.mesh.vertices.resize(3, static_cast<Eigen::Index>(body.vertex_count));
  shape.mesh.tetrahedra.resize(4, static_cast<Eigen::Index>(body.tetrahedron_count));
  for (std::size_t v = 0; v < body.vertex_count; ++v) {
    shape.mesh.vertices.col(static_cast<Eigen::Index>(v)) = vec(body.vertices[v]);
  }
  for (std::size_t e = 0; e < body.tetrahedron_count; ++e) {
    for (int k = 0; k < 4; ++k) {
      shape.mesh.tetrahedra(k, static_cast<Eigen::Index>(e)) =
          static_cast<int>(body.tetrahedra[e][k]);
    }
  }
  return shape;
}

ProblemBody body_of(const stiction_body& given) {
  ProblemBody body;
  body.name = given.name;
  body.shape = shape_of(given);
  body.mass = given.mass;
  body.elasticity = {given.youngs_modulus, given.poisson_ratio, given.damping_time};
  body.position = vec(given.position);
  body.rotation = {given.rotation[0], given.rotation[1], given.rotation[2], given.rotation[3]};
  body.velocity = vec(given.velocity);
  body.angular_velocity = vec(given.angular_velocity);
  if (given.held) body.held = HeldPart{vec(given.held_point), vec(given.held_normal)};
  const VectorOverTime motion = over_time(given.motion);
  body.motion = {motion.time, motion.value};
  body.self_collision = given.self_collision != 0;
  body.must_deform = given.must_deform != 0;
  return body;
}

Problem problem_of(const stiction_problem& given) {
  Problem problem;
  problem.name = given.name;
  for (std::size_t b = 0; b < given.body_count; ++b) {
    problem.bodies.push_back(body_of(given.bodies[b]));
  }
  for (std::size_t o = 0; o < given.obstacle_count; ++o) {
    const stiction_obstacle& one = given.obstacles[o];
    const VectorOverTime motion = over_time(one.motion);
    problem.obstacles.push_back(
        {one.name, vec(one.point), vec(one.normal), one.friction, {motion.time, motion.value}});
  }
  const VectorOverTime gravity = over_time(given.gravity);
  problem.gravity = {gravity.time, gravity.value};
  problem.drag = {given.drag_rate, given.drag_full_until, given.drag_ends};
  problem.friction = given.friction;
  problem.duration = given.duration;
  for (std::size_t k = 0; k < given.load_count; ++k) {
    problem.loads.push_back(
        {given.loads[k].body, over_time(given.loads[k].force), over_time(given.loads[k].couple)});
  }
  for (std::size_t k = 0; k < given.spring_count; ++k) {
    const stiction_spring& one = given.springs[k];
    problem.springs.push_back(
        {one.body, vec(one.anchor), vec(one.anchor_velocity), vec(one.axis), one.stiffness});
  }
  return problem;
}

// The solver, and what an adapter needs beside it. One problem a process.
struct Hosted {
  Problem problem{};
  std::unique_ptr<Engine> engine{};
  std::string fault{};
  std::vector<Snapshot> saved{};
  bool forgotten = false;  // fault "forget": velocities are told as 0 until the next step
  std::vector<ContactSample> contacts{};
};

Hosted& hosted(void* self) { return *static_cast<Hosted*>(self); }

Settings given_settings() {
  Settings settings;
  for (const auto& [name, help] : find_engine("stiction").settings_help) {
    if (stiction_has(name.c_str())) settings[name] = stiction_text(name.c_str(), "");
  }
  return settings;
}

void plant(const std::string& fault, Problem& problem) {
  if (fault == "degrees") {
    for (ProblemBody& body : problem.bodies) body.angular_velocity *= std::numbers::pi / 180.0;
  } else if (fault == "gravity-twice") {
    for (Vec3& a : problem.gravity.acceleration) a *= 2.0;
  } else if (fault == "friction") {
    for (Obstacle& obstacle : problem.obstacles) obstacle.friction *= 1.02;
  }
}

void* load(const stiction_problem* given) {
  auto self = std::make_unique<Hosted>();
  self->fault = stiction_text("fault", "none");
  if (std::find(std::begin(kFaults), std::end(kFaults), self->fault) == std::end(kFaults)) {
    stiction_refuse("there is no such fault");
  }
  self->problem = problem_of(*given);
  plant(self->fault, self->problem);
  self->engine = find_engine("stiction").make(given_settings());
  self->engine->load(self->problem, {given->fineness, given->roundness, given->time,
                                     self->fault == "finer" ? 1.0 : given->finer});
  for (const auto& [name, value] : self->engine->settings()) {
    stiction_tell(name.c_str(), value.c_str());
  }
  return self.release();
}

double time_step(void* self) { return hosted(self).engine->time_step(); }

void advance(void* self, std::uint64_t steps) {
  Hosted& one = hosted(self);
  one.forgotten = false;
  if (one.fault == "clock") return;
  if (one.fault == "exit" && one.engine->steps_done() > 100) std::exit(0);
  if (one.fault == "half-step") steps = (steps + 1) / 2;
  one.engine->advance(steps);
}

void body(void* self, std::size_t index, stiction_body_state* state) {
  Hosted& one = hosted(self);
  const std::size_t count = one.problem.bodies.size();
  if (one.fault == "swapped") index = count - 1 - index;
  const BodyMotion motion = one.engine->body(index);
  Map<Vec3>(state->position) = motion.position;
  Map<Vec3>(state->velocity) = motion.velocity;
  Map<Vec3>(state->angular_velocity) = motion.angular_velocity;
  const Eigen::Quaterniond turned = motion.rotation * one.problem.bodies[index].rotation;
  const double q[] = {turned.w(), turned.x(), turned.y(), turned.z()};
  std::copy(q, q + 4, state->rotation);
  if (one.fault == "stands" && !one.problem.obstacles.empty()) {
    Map<Vec3>(state->position) = one.problem.bodies[index].position;
  }
  if (one.forgotten) Map<Vec3>(state->velocity).setZero();
  if (one.fault == "nan" && one.engine->steps_done() > 100) state->position[1] = std::nan("");
}

std::size_t contacts(void* self, stiction_contact* out, std::size_t room) {
  Hosted& one = hosted(self);
  one.contacts = one.engine->contacts();
  const double sign = one.fault == "sign" ? -1.0 : 1.0;
  for (std::size_t k = 0; k < std::min(room, one.contacts.size()); ++k) {
    const ContactSample& from = one.contacts[k];
    stiction_contact& to = out[k];
    to = {};
    to.body = from.body;
    to.other = from.obstacle;
    to.against_body = from.against_body ? 1 : 0;
    Map<Vec3>(to.normal) = from.normal;
    to.gap = from.gap;
    to.normal_force = sign * from.normal_force;
    Map<Vec3>(to.friction_force) = sign * from.friction_force;
    Map<Vec3>(to.slip) = from.slip;
    Map<Vec3>(to.position) = from.position;
    to.sticks = from.sticks ? 1 : 0;
  }
  return one.contacts.size();
}

void energies(void* self, double* kinetic, double* gravity, double* elastic) {
  const Energies told = hosted(self).engine->energies();
  *kinetic = told.kinetic;
  *gravity = told.gravity;
  *elastic = told.elastic;
}

void momenta(void* self, double linear[3], double angular[3]) {
  const Momenta told = hosted(self).engine->momenta();
  Map<Vec3>(linear, 3) = told.linear;
  Map<Vec3>(angular, 3) = told.angular;
}

std::size_t surface(void* self, std::size_t index, std::uint32_t (*triangles)[3],
                    std::size_t room) {
  const Eigen::Matrix3Xi all = hosted(self).engine->surface(index);
  const auto count = static_cast<std::size_t>(all.cols());
  for (std::size_t t = 0; t < std::min(room, count); ++t) {
    for (int k = 0; k < 3; ++k) {
      triangles[t][k] = static_cast<std::uint32_t>(all(k, static_cast<Eigen::Index>(t)));
    }
  }
  return count;
}

std::size_t vertices(void* self, std::size_t index, double (*positions)[3], std::size_t room) {
  const Eigen::Matrix3Xd all = hosted(self).engine->vertices(index);
  const auto count = static_cast<std::size_t>(all.cols());
  for (std::size_t v = 0; v < std::min(room, count); ++v) {
    std::copy_n(all.col(static_cast<Eigen::Index>(v)).data(), 3, positions[v]);
  }
  return count;
}

void* save(void* self) { return new Snapshot(hosted(self).engine->save()); }

void restore(void* self, const void* saved) {
  Hosted& one = hosted(self);
  one.engine->restore(*static_cast<const Snapshot*>(saved));
  one.forgotten = one.fault == "forget";
}

void forget(void*, void* saved) { delete static_cast<Snapshot*>(saved); }

void end(void* self) { delete &hosted(self); }

int serve(int argc, char** argv) {
  std::map<std::string, std::string> help = find_engine("stiction").settings_help;
  help["fault"] = "one of an adapter, planted for tests (default none)";
  std::vector<stiction_setting> settings;
  for (const auto& [name, meaning] : help) settings.push_back({name.c_str(), meaning.c_str()});
  settings.push_back({});
  stiction_engine engine{};
  engine.name = "hosted";
  engine.version = "";
  engine.description = "this project's solver behind the engine protocol";
  engine.can =
      "points boxes balls meshes deformable held_parts body_contact self_contact moving_obstacles "
      "drag varying_gravity loads spin";
  engine.settings = settings.data();
  engine.symplectic_euler = 1;
  engine.load = load;
  engine.time_step = time_step;
  engine.advance = advance;
  engine.body = body;
  engine.contacts = contacts;
  engine.energies = energies;
  engine.momenta = momenta;
  engine.surface = surface;
  engine.vertices = vertices;
  engine.save = save;
  engine.restore = restore;
  engine.forget = forget;
  engine.end = end;
  return stiction_engine_main(&engine, argc, argv);
}

}  // namespace

}  // namespace stiction

int main(int argc, char** argv) { return stiction::serve(argc, argv); }
