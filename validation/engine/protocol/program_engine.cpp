// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/protocol/program_engine.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "solver/demand.h"
#include "solver/hash.h"
#include "validation/engine/kit/array_json.h"
#include "validation/engine/own_process.h"
#include "validation/engine/protocol/problem_json.h"
#include "validation/engine/protocol/rigid_body.h"

namespace stiction {

namespace {

using nlohmann::json;

constexpr double kClockDrift = 1e-6;  // relative: what sums of Δt in single precision lose
constexpr double kTelling = 2e-3;     // s of CPU time: a hundred times what an observation takes
constexpr std::uint64_t kMostVertices = 1000000000;
constexpr double kUnit = 1e-3;  // of a quaternion's length: an engine may let it drift a little

// A saved state is the program's own affair: it can be taken back by the same process alone.
// Where nobody holds it any more, the program is told so when it saves again.
struct SavedState {
  SavedState(const void* by, json found_by, std::uint64_t at, std::shared_ptr<json> forgotten)
      : engine(by), state(std::move(found_by)), steps(at), given_up(std::move(forgotten)) {}
  SavedState(const SavedState&) = delete;
  SavedState& operator=(const SavedState&) = delete;
  ~SavedState() { given_up->push_back(state); }

  const void* engine;
  json state;
  std::uint64_t steps;
  std::shared_ptr<json> given_up;  // a list of states
};

Vec3 vec3(const JsonField& field) {
  const auto all = field.list([](const JsonField& one) { return finite(one); });
  if (all.size() != 3) field.fail("needs 3 numbers");
  return {all[0], all[1], all[2]};
}

class ProgramEngine final : public Engine, public OwnProcess {
 public:
  ProgramEngine(const ProgramTraits& traits, Settings settings)
      : traits_(traits), given_(std::move(settings)) {}

  void load(const Problem& problem, const Accuracy& accuracy) override {
    problem_ = problem;
    const json described = problem_json(problem);
    for (const ProblemBody& body : problem.bodies) rigid_.emplace_back(body);
    dialogue_ = start(traits_);
    given_up_ = std::make_shared<json>(json::array());
    const json answer = dialogue_->ask(
        "load",
        {{"problem", described}, {"accuracy", accuracy_json(accuracy)}, {"settings", given_}});
    const JsonField fields = dialogue_->fields(answer, "load");
    time_step_ = finite(fields["time_step"]);
    if (!(time_step_ > 0.0)) fields["time_step"].fail("must be above 0");
    if (fields.has("settings")) {
      resolved_ = fields["settings"].map([](const JsonField& one) { return one.text(); });
    }
    see_bodies();
    if (traits_.tells_surface) see_surfaces();
  }

  double time_step() const override { return time_step_; }
  std::uint64_t steps_done() const override { return steps_; }
  bool symplectic_euler() const override { return traits_.symplectic_euler; }

  void advance(std::uint64_t steps) override {
    const double before = dialogue_->cpu_seconds();
    const json answer = dialogue_->ask("advance", {{"steps", steps}});
    cpu_ += dialogue_->cpu_seconds() - before;
    steps_ += steps;
    counted_ += steps;
    const JsonField fields = dialogue_->fields(answer, "advance");
    demand_clock(fields);
    if (fields.has("cpu")) told_cpu_ = finite(fields["cpu"]);
    stale_ = true;
  }

  BodyMotion body(std::size_t index) const override {
    refresh();
    return bodies_.at(index);
  }

  std::vector<ContactSample> contacts() const override;
  Energies energies() const override;
  Momenta momenta() const override;
  double time() const { return static_cast<double>(steps_) * time_step_; }

  Eigen::Matrix3Xi surface(std::size_t index) const override {
    return surfaces_.empty() ? rigid_.at(index).surface() : surfaces_.at(index);
  }

  Eigen::Matrix3Xd vertices(std::size_t index) const override {
    if (surfaces_.empty()) return rigid_.at(index).vertices(body(index));
    return see_vertices(index);
  }

  Settings settings() const override { return resolved_; }

  Cost cost() const override {
    Cost cost;
    cost.cpu_seconds = cpu_;
    cost.told_cpu_seconds = told_cpu_;
    cost.steps = counted_;
    return cost;
  }

  std::optional<std::int64_t> resident_memory() const override {
    return dialogue_->resident_memory();
  }

  std::uint64_t state_hash() const override {
    refresh();
    Fnv1a hash;
    for (const BodyMotion& motion : bodies_) {
      for (const Vec3* part : {&motion.position, &motion.velocity, &motion.angular_velocity}) {
        hash.add(part->data(), sizeof(Vec3));
      }
      hash.add(motion.rotation.coeffs().data(), sizeof(Eigen::Vector4d));
    }
    return hash.value();
  }

  Snapshot save() const override {
    if (!traits_.manifest.snapshots) return Engine::save();
    json request = json::object();
    if (!given_up_->empty()) request["forget"] = std::exchange(*given_up_, json::array());
    const json answer = dialogue_->ask("save", std::move(request));
    dialogue_->fields(answer, "save")["state"];
    return std::make_shared<const SavedState>(this, answer.at("state"), steps_, given_up_);
  }

  void restore(const Snapshot& snapshot) override {
    const auto& saved = *static_cast<const SavedState*>(snapshot.get());
    if (saved.engine != this) {
      throw NotApplicable(
          "a state that another process of the engine has saved cannot be taken up");
    }
    const json answer = dialogue_->ask("restore", {{"state", saved.state}});
    steps_ = saved.steps;
    demand_clock(dialogue_->fields(answer, "restore"));
    stale_ = true;
  }

 private:
  void see_bodies() const;
  void see_surfaces();
  Eigen::Matrix3Xd see_vertices(std::size_t index) const;
  void demand_clock(const JsonField& fields) const;
  json observe(const char* what) const {
    const double before = dialogue_->cpu_seconds();
    json answer = dialogue_->ask("observe", {{"what", json::array({what})}});
    // Telling is not billed; an engine that does its work when it is looked at is.
    const double spent = dialogue_->cpu_seconds() - before;
    if (steps_ > 0 && spent > kTelling) cpu_ += spent;
    return answer;
  }
  void refresh() const {
    if (stale_) see_bodies();
  }

  ProgramTraits traits_;
  Settings given_, resolved_;
  std::unique_ptr<Dialogue> dialogue_;
  std::shared_ptr<json> given_up_ = std::make_shared<json>(json::array());  // saved states
  Problem problem_;
  std::vector<RigidBody> rigid_;
  std::vector<Eigen::Matrix3Xi> surfaces_;  // of bodies that deform, where the program tells them
  double time_step_ = 0.0;
  std::uint64_t steps_ = 0, counted_ = 0;
  mutable double cpu_ = 0.0;
  double told_cpu_ = 0.0;
  // Asked for when a case looks, once a step.
  mutable bool stale_ = false;
  mutable std::vector<BodyMotion> bodies_;
};

std::vector<double> finite_array(const JsonField& field, const json& value, const char* name) {
  std::vector<double> all;
  try {
    all = kit::read_array(value, std::string("'") + name + "'");
  } catch (const std::runtime_error& what) {
    field.fail(what.what());
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!std::isfinite(all[k])) field.fail(fmt::format("its number {} is not finite", k));
  }
  return all;
}

std::vector<double> array_of(const JsonField& fields, const json& answer, const char* name,
                             std::size_t count) {
  const JsonField field = fields[name];
  const std::vector<double> all = finite_array(field, answer.at(name), name);
  if (all.size() != count) {
    field.fail(fmt::format("has {} numbers where {} belong", all.size(), count));
  }
  return all;
}

void ProgramEngine::see_bodies() const {
  const std::size_t count = problem_.bodies.size();
  const json answer = observe("bodies");
  const JsonField fields = dialogue_->fields(answer, "observe")["bodies"];
  const json& told = answer.at("bodies");
  const auto position = array_of(fields, told, "position", 3 * count);
  const auto velocity = array_of(fields, told, "velocity", 3 * count);
  const auto rotation = array_of(fields, told, "rotation", 4 * count);
  const auto spin = array_of(fields, told, "angular_velocity", 3 * count);
  bodies_.resize(count);
  for (std::size_t b = 0; b < count; ++b) {
    const double* const q = &rotation[4 * b];
    const Eigen::Quaterniond turned(q[0], q[1], q[2], q[3]);
    if (!(std::abs(turned.norm() - 1.0) < kUnit)) {
      fields["rotation"].fail(fmt::format("that of body {} is no unit quaternion", b));
    }
    bodies_[b] = {.position = Vec3(&position[3 * b]),
                  .velocity = Vec3(&velocity[3 * b]),
                  .rotation = turned.normalized() * problem_.bodies[b].rotation.inverse(),
                  .angular_velocity = Vec3(&spin[3 * b])};
  }
  stale_ = false;
}

void ProgramEngine::see_surfaces() {
  const json answer = observe("surface");
  const auto bodies =
      dialogue_->fields(answer, "observe")["surface"].list([](const JsonField& body) {
        auto corners = body.list([](const JsonField& k) {
          if (k.count() > kMostVertices) k.fail("is no vertex");
          return k.count();
        });
        if (corners.size() % 3 != 0) body.fail("has not three corners a triangle");
        return corners;
      });
  for (const std::vector<std::uint64_t>& corners : bodies) {
    Eigen::Matrix3Xi triangles(3, static_cast<Eigen::Index>(corners.size() / 3));
    for (Eigen::Index k = 0; k < triangles.size(); ++k) {
      triangles.data()[k] = static_cast<int>(corners[static_cast<std::size_t>(k)]);
    }
    surfaces_.push_back(std::move(triangles));
  }
  if (surfaces_.size() != problem_.bodies.size()) {
    dialogue_->fields(answer, "observe")["surface"].fail("is not one list a body");
  }
}

Eigen::Matrix3Xd ProgramEngine::see_vertices(std::size_t index) const {
  const json answer = observe("vertices");
  const JsonField field = dialogue_->fields(answer, "observe")["vertices"];
  const json& told = answer.at("vertices");
  if (!told.is_array() || told.size() != surfaces_.size()) field.fail("is not one list a body");
  const std::vector<double> all = finite_array(field, told.at(index), "vertices");
  const Eigen::Map<const Eigen::Matrix3Xd> vertices(all.data(), 3,
                                                    static_cast<Eigen::Index>(all.size() / 3));
  const Eigen::Matrix3Xi& triangles = surfaces_.at(index);
  if (all.size() % 3 != 0 || (triangles.size() > 0 && triangles.maxCoeff() >= vertices.cols())) {
    field.fail(
        fmt::format("has {} numbers for body {}: not three for each vertex that its triangles name",
                    all.size(), index));
  }
  return vertices;
}

void ProgramEngine::demand_clock(const JsonField& fields) const {
  const double told = finite(fields["time"]);
  if (fields["steps"].count() != steps_) {
    fields["steps"].fail(
        fmt::format("has done {} steps where {} were asked for", fields["steps"].count(), steps_));
  }
  if (!(std::abs(told - time()) <= kClockDrift * time() + 0.01 * time_step_)) {
    fields["time"].fail(
        fmt::format("its clock stands at {:.9g} s after {} steps of {:.9g} s: did time advance?",
                    told, steps_, time_step_));
  }
}

std::vector<ContactSample> ProgramEngine::contacts() const {
  if (!traits_.manifest.contacts) return Engine::contacts();
  const json answer = observe("contacts");
  return dialogue_->fields(answer, "observe")["contacts"].list([&](const JsonField& one) {
    ContactSample contact;
    contact.body = one["body"].count();
    contact.against_body = one.has("other_body");
    contact.obstacle = one[contact.against_body ? "other_body" : "obstacle"].count();
    const std::size_t others =
        contact.against_body ? problem_.bodies.size() : problem_.obstacles.size();
    if (contact.body >= problem_.bodies.size()) one["body"].fail("there is no such body");
    if (contact.obstacle >= others) one.fail("it touches what is not there");
    contact.normal = vec3(one["normal"]);
    contact.gap = finite(one["gap"]);
    contact.normal_force = finite(one["normal_force"]);
    contact.friction_force = vec3(one["friction_force"]);
    contact.slip = vec3(one["slip"]);
    contact.position = vec3(one["position"]);
    contact.sticks = one.has("sticks") && one["sticks"].boolean();
    return contact;
  });
}

Energies ProgramEngine::energies() const {
  if (traits_.tells_energies) {
    const json answer = observe("energies");
    const JsonField told = dialogue_->fields(answer, "observe")["energies"];
    return {finite(told["kinetic"]), finite(told["gravity"]), finite(told["elastic"])};
  }
  refresh();
  Energies sum;
  const Vec3 gravity = problem_.gravity.at(time());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    sum.kinetic += rigid_[b].kinetic_energy(bodies_[b]);
    sum.gravity -= problem_.bodies[b].mass * gravity.dot(bodies_[b].position);
  }
  return sum;
}

Momenta ProgramEngine::momenta() const {
  if (traits_.tells_momenta) {
    const json answer = observe("momenta");
    const JsonField told = dialogue_->fields(answer, "observe")["momenta"];
    return {vec3(told["linear"]), vec3(told["angular"])};
  }
  refresh();
  Momenta sum{Vec3::Zero(), Vec3::Zero()};
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Vec3 momentum = problem_.bodies[b].mass * bodies_[b].velocity;
    sum.linear += momentum;
    sum.angular += bodies_[b].position.cross(momentum) + rigid_[b].spin(bodies_[b]);
  }
  return sum;
}

}  // namespace

std::unique_ptr<Dialogue> start(const ProgramTraits& traits) {
  return traits.answers ? std::make_unique<Dialogue>(traits.words, traits.answers)
                        : std::make_unique<Dialogue>(traits.words, traits.limits);
}

std::unique_ptr<Engine> make_program_engine(const ProgramTraits& traits, const Settings& settings) {
  return std::make_unique<ProgramEngine>(traits, settings);
}

}  // namespace stiction
