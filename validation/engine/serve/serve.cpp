// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/serve/serve.h"

#include <algorithm>
#include <memory>
#include <string>

#include "validation/engine/kit/stiction_engine.h"
#include "validation/engine/protocol/manifest_words.h"

namespace stiction {

namespace {

using Eigen::Map;
using Eigen::Vector3d;

Vector3d vec(const double v[3]) { return Vector3d(v); }

VectorOverTime over_time(const stiction_keyframes& frames) {
  VectorOverTime out;
  for (std::size_t k = 0; k < frames.count; ++k) {
    out.time.push_back(frames.time[k]);
    out.value.emplace_back(frames.value[k]);
  }
  const stiction_oscillation& sine = frames.oscillation;
  out.oscillation = {vec(sine.amplitude), sine.frequency, sine.phase, sine.begins, sine.full_from};
  return out;
}

Motion motion_of(const stiction_keyframes& frames) {
  const VectorOverTime given = over_time(frames);
  return {given.time, given.value, vec(frames.velocity), given.oscillation};
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
  body.motion = motion_of(given.motion);
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
    problem.obstacles.push_back(
        {one.name, vec(one.point), vec(one.normal), one.friction, motion_of(one.motion)});
  }
  const VectorOverTime gravity = over_time(given.gravity);
  problem.gravity = {gravity.time, gravity.value, gravity.oscillation};
  problem.drag = {given.drag_rate, given.drag_full_until, given.drag_ends};
  problem.friction = given.friction;
  problem.duration = given.duration;
  for (std::size_t k = 0; k < given.pair_friction_count; ++k) {
    const stiction_pair_friction& one = given.pair_friction[k];
    problem.pair_friction.push_back({one.body, one.other, one.against_body != 0, one.friction});
  }
  problem.restitution = given.restitution;
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

// What is served; the kit's functions have no other way to it.
const EngineKind* served = nullptr;

struct Served {
  Problem problem{};
  std::unique_ptr<Engine> engine{};
};

Served& of(void* self) { return *static_cast<Served*>(self); }
Engine& engine_of(void* self) { return *of(self).engine; }

void* load(const stiction_problem* given) {
  Settings settings;
  for (const auto& [name, help] : served->settings_help) {
    if (stiction_has(name.c_str())) settings[name] = stiction_text(name.c_str(), "");
  }
  auto self = std::make_unique<Served>();
  self->problem = problem_of(*given);
  self->engine = served->make(settings);
  try {
    self->engine->load(self->problem,
                       {given->fineness, given->roundness, given->time, given->finer});
  } catch (const NotApplicable& lacking) {
    stiction_lacks(lacking.what());
  }
  for (const auto& [name, value] : self->engine->settings()) {
    stiction_tell(name.c_str(), value.c_str());
  }
  return self.release();
}

double time_step(void* self) { return engine_of(self).time_step(); }

void advance(void* self, std::uint64_t steps) { engine_of(self).advance(steps); }

void body(void* self, std::size_t index, stiction_body_state* state) {
  const BodyMotion motion = engine_of(self).body(index);
  Map<Vector3d>(state->position) = motion.position;
  Map<Vector3d>(state->velocity) = motion.velocity;
  Map<Vector3d>(state->angular_velocity) = motion.angular_velocity;
  const Eigen::Quaterniond turned = motion.rotation * of(self).problem.bodies[index].rotation;
  const double q[] = {turned.w(), turned.x(), turned.y(), turned.z()};
  std::copy(q, q + 4, state->rotation);
}

std::size_t contacts(void* self, stiction_contact* out, std::size_t room) {
  const std::vector<ContactSample> all = engine_of(self).contacts();
  for (std::size_t k = 0; k < std::min(room, all.size()); ++k) {
    const ContactSample& from = all[k];
    stiction_contact& to = out[k];
    to = {};
    to.body = from.body;
    to.other = from.obstacle;
    to.against_body = from.against_body ? 1 : 0;
    Map<Vector3d>(to.normal) = from.normal;
    to.gap = from.gap;
    to.normal_force = from.normal_force;
    Map<Vector3d>(to.friction_force) = from.friction_force;
    Map<Vector3d>(to.slip) = from.slip;
    Map<Vector3d>(to.position) = from.position;
    to.sticks = from.sticks ? 1 : 0;
  }
  return all.size();
}

void energies(void* self, double* kinetic, double* gravity, double* elastic) {
  const Energies told = engine_of(self).energies();
  *kinetic = told.kinetic;
  *gravity = told.gravity;
  *elastic = told.elastic;
}

void momenta(void* self, double linear[3], double angular[3]) {
  const Momenta told = engine_of(self).momenta();
  Map<Vector3d>(linear, 3) = told.linear;
  Map<Vector3d>(angular, 3) = told.angular;
}

std::size_t surface(void* self, std::size_t index, std::uint32_t (*triangles)[3],
                    std::size_t room) {
  const Eigen::Matrix3Xi all = engine_of(self).surface(index);
  const auto count = static_cast<std::size_t>(all.cols());
  for (std::size_t t = 0; t < std::min(room, count); ++t) {
    for (int k = 0; k < 3; ++k) {
      triangles[t][k] = static_cast<std::uint32_t>(all(k, static_cast<Eigen::Index>(t)));
    }
  }
  return count;
}

std::size_t vertices(void* self, std::size_t index, double (*positions)[3], std::size_t room) {
  const Eigen::Matrix3Xd all = engine_of(self).vertices(index);
  const auto count = static_cast<std::size_t>(all.cols());
  for (std::size_t v = 0; v < std::min(room, count); ++v) {
    std::copy_n(all.col(static_cast<Eigen::Index>(v)).data(), 3, positions[v]);
  }
  return count;
}

void* save(void* self) { return new Snapshot(engine_of(self).save()); }

void restore(void* self, const void* saved) {
  engine_of(self).restore(*static_cast<const Snapshot*>(saved));
}

void forget(void*, void* saved) { delete static_cast<Snapshot*>(saved); }

void end(void* self) { delete &of(self); }

std::string words_of(const Manifest& manifest) {
  std::string words;
  for (const ManifestWord& one : kManifestWords) {
    // The kit adds these from the functions that there are.
    if (one.has == &Manifest::contacts || one.has == &Manifest::snapshots) continue;
    if (manifest.*one.has) words += (words.empty() ? "" : " ") + std::string(one.word);
  }
  return words;
}

std::string words_of(const Settings& settings) {
  std::string words;
  for (const auto& [name, value] : settings) {
    words += (words.empty() ? "" : " ") + name + "=" + value;
  }
  return words;
}

}  // namespace

int serve_engine(const EngineKind& kind, const std::vector<Configuration>& configurations, int argc,
                 char** argv) {
  served = &kind;
  const std::string can = words_of(kind.manifest);
  std::vector<stiction_setting> settings;
  for (const auto& [name, meaning] : kind.settings_help) {
    settings.push_back({name.c_str(), meaning.c_str()});
  }
  settings.push_back({});
  std::vector<std::string> words;
  for (const Configuration& one : configurations) words.push_back(words_of(one.settings));
  std::vector<stiction_configuration> told;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const Configuration& one = configurations[k];
    told.push_back({one.name.c_str(), words[k].c_str(), one.source.c_str()});
  }
  told.push_back({});
  std::vector<std::string> efforts;
  for (const Settings& one : kind.ladder) efforts.push_back(words_of(one));
  std::vector<const char*> ladder;
  for (const std::string& one : efforts) ladder.push_back(one.c_str());
  ladder.push_back(nullptr);
  stiction_engine engine{};
  engine.name = kind.name.c_str();
  engine.version = "";
  engine.description = kind.description.c_str();
  engine.can = can.c_str();
  engine.settings = settings.data();
  engine.configurations = told.data();
  engine.ladder = ladder.data();
  engine.symplectic_euler = kind.make({})->symplectic_euler() ? 1 : 0;
  engine.load = load;
  engine.time_step = time_step;
  engine.advance = advance;
  engine.body = body;
  engine.energies = energies;
  engine.momenta = momenta;
  engine.surface = surface;
  engine.vertices = vertices;
  engine.end = end;
  if (kind.manifest.contacts) engine.contacts = contacts;
  if (kind.manifest.snapshots) {
    engine.save = save;
    engine.restore = restore;
    engine.forget = forget;
  }
  return stiction_engine_main(&engine, argc, argv);
}

}  // namespace stiction
