// SPDX-License-Identifier: GPL-3.0-or-later
// A second engine, as plain as one can be: rigid bodies that slide and do not turn, on half-spaces,
// one contact at a time. It shows that a problem names no engine, and what a new one has to bring.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/demand.h"
#include "solver/hash.h"
#include "validation/engine/cpu_time.h"
#include "validation/engine/engine.h"
#include "validation/engine/settings.h"

namespace stiction {

namespace {

struct Touch {
  std::size_t body = 0, obstacle = 0;
  double gap = 0.0;       // m
  double impulse = 0.0;   // along the normal, N s
  Vec3 friction_impulse;  // N s
  bool sticks = false;
};

struct PlainState {
  std::uint64_t step = 0;
  std::vector<Vec3> position, velocity;  // m, m/s
  std::vector<Touch> touches;            // of the last step
};

// How far a body reaches from its centre against `normal`, m.
double reach(const ProblemBody& body, const Vec3& normal) {
  const auto* box = std::get_if<BoxShape>(&body.shape);
  if (!box) return 0.0;
  return 0.5 * (body.rotation.inverse() * normal).cwiseAbs().dot(box->size);
}

// With symplectic Euler's steps, in which the contact's law holds exactly:
//
//   v' = v + g Δt;   0 ≤ pₙ ⊥ gap + Δt n·v'' ≥ 0;   |pₜ| ≤ μ pₙ, against the slip;   x += Δt v''
//
// A creep speed c > 0 in place of Coulomb's law is what many an engine has: |pₜ| = μ pₙ |u|/c where
// the slip u after the step is below c. On no slope does such a body rest: it creeps at c tan θ/μ.
class PlainEngine final : public Engine {
 public:
  explicit PlainEngine(const Settings& given) {
    SettingsReader reader(given);
    chosen_time_step_ = reader.has("dt");
    time_step_ = reader.number("dt", time_step_);
    creep_ = reader.number("creep", creep_);
    reader.refuse_unknown("plain");
    if (!(time_step_ > 0.0)) throw InputError("setting 'dt' must be above 0");
    if (!(creep_ >= 0.0)) throw InputError("setting 'creep' must not be below 0");
  }

  void load(const Problem& problem, const Accuracy& accuracy) override {
    problem_ = problem;
    if (accuracy.time > 0.0 && !chosen_time_step_) time_step_ = accuracy.time;
    time_step_ /= accuracy.finer;
    for (const ProblemBody& body : problem.bodies) {
      if (!(body.mass > 0.0)) {
        throw InputError("the mass of '" + body.name + "' must be above 0");
      }
      state_.position.push_back(body.position);
      state_.velocity.push_back(body.velocity);
    }
  }

  double time_step() const override { return time_step_; }
  std::uint64_t steps_done() const override { return state_.step; }
  bool symplectic_euler() const override { return true; }

  void advance(std::uint64_t steps) override {
    const double before = thread_cpu_seconds();
    for (std::uint64_t k = 0; k < steps; ++k) {
      step();
      contact_updates_ += state_.touches.size();
    }
    cpu_ += thread_cpu_seconds() - before;
    steps_ += steps;
  }

  BodyMotion body(std::size_t index) const override {
    return {.position = state_.position.at(index), .velocity = state_.velocity.at(index)};
  }

  std::vector<ContactSample> contacts() const override {
    std::vector<ContactSample> samples;
    for (const Touch& touch : state_.touches) {
      const Obstacle& obstacle = problem_.obstacles[touch.obstacle];
      const Vec3& v = state_.velocity[touch.body];
      samples.push_back(
          {.body = touch.body,
           .obstacle = touch.obstacle,
           .normal = obstacle.normal,
           .gap = touch.gap,
           .normal_force = touch.impulse / time_step_,
           .friction_force = touch.friction_impulse / time_step_,
           .slip = v - obstacle.normal.dot(v) * obstacle.normal,
           .sticks = touch.sticks,
           .position = state_.position[touch.body] -
                       reach(problem_.bodies[touch.body], obstacle.normal) * obstacle.normal});
    }
    return samples;
  }

  Energies energies() const override {
    Energies sum;
    const Vec3 gravity = problem_.gravity.at(static_cast<double>(state_.step) * time_step_);
    for (std::size_t b = 0; b < problem_.bodies.size(); ++b) {
      const double mass = problem_.bodies[b].mass;
      sum.kinetic += 0.5 * mass * state_.velocity[b].squaredNorm();
      sum.gravity -= mass * gravity.dot(state_.position[b]);
    }
    return sum;
  }

  Momenta momenta() const override {
    Momenta sum{Vec3::Zero(), Vec3::Zero()};
    for (std::size_t b = 0; b < problem_.bodies.size(); ++b) {
      const Vec3 momentum = problem_.bodies[b].mass * state_.velocity[b];
      sum.linear += momentum;
      sum.angular += state_.position[b].cross(momentum);
    }
    return sum;
  }

  Settings settings() const override {
    Settings all{{"dt", fmt::format("{}", time_step_)}};
    if (creep_ > 0.0) all["creep"] = fmt::format("{}", creep_);
    return all;
  }

  Cost cost() const override {
    Cost cost;
    cost.cpu_seconds = cpu_;
    cost.steps = steps_;
    cost.contact_updates = contact_updates_;
    return cost;
  }

  std::uint64_t state_hash() const override {
    Fnv1a hash;
    for (const auto* list : {&state_.position, &state_.velocity}) {
      hash.add(list->data(), list->size() * sizeof(Vec3));
    }
    return hash.value();
  }

  Snapshot save() const override { return std::make_shared<const PlainState>(state_); }
  void restore(const Snapshot& snapshot) override {
    state_ = *static_cast<const PlainState*>(snapshot.get());
  }

 private:
  void step() {
    const Vec3 gravity = problem_.gravity.at(static_cast<double>(state_.step) * time_step_);
    state_.touches.clear();
    for (std::size_t b = 0; b < problem_.bodies.size(); ++b) {
      Vec3& velocity = state_.velocity[b];
      velocity += time_step_ * gravity;
      for (std::size_t o = 0; o < problem_.obstacles.size(); ++o) touch(b, o);
      state_.position[b] += time_step_ * velocity;
    }
    ++state_.step;
  }

  void touch(std::size_t b, std::size_t o) {
    const ProblemBody& body = problem_.bodies[b];
    const Obstacle& obstacle = problem_.obstacles[o];
    const Vec3& n = obstacle.normal;
    Vec3& velocity = state_.velocity[b];
    const double gap = n.dot(state_.position[b] - obstacle.point) - reach(body, n);
    // What is inside already isn't thrown out: the contact only stops the approach.
    const double speed = -std::max(gap, 0.0) / time_step_ - n.dot(velocity);
    if (!(speed > 0.0)) return;
    velocity += speed * n;
    Touch touch{.body = b,
                .obstacle = o,
                .gap = gap,
                .impulse = body.mass * speed,
                .friction_impulse = Vec3::Zero()};
    const Vec3 slip = velocity - n.dot(velocity) * n;
    const double fast = slip.norm(), most = obstacle.friction * speed;
    const double creeping = creep_ > 0.0 ? fast / (1.0 + most / creep_) : 0.0;
    const double taken = creeping <= creep_ ? std::min(fast - creeping, most) : most;
    touch.sticks = taken == fast;
    if (fast > 0.0) {
      velocity -= taken / fast * slip;
      touch.friction_impulse = -body.mass * taken / fast * slip;
    }
    state_.touches.push_back(touch);
  }

  Problem problem_;
  PlainState state_;
  double time_step_ = 2e-4, creep_ = 0.0;
  bool chosen_time_step_ = false;
  double cpu_ = 0.0;
  std::uint64_t steps_ = 0, contact_updates_ = 0;
};

}  // namespace

EngineKind engine_plain() {
  return {
      .name = "plain",
      .description =
          "rigid bodies that slide on half-spaces and do not turn: Coulomb's law, step by step",
      .manifest = {.point_masses = true,
                   .boxes = true,
                   .varying_gravity = true,
                   .contacts = true,
                   .snapshots = true},
      .settings_help = {{"dt", "time step, s (default 2e-4)"},
                        {"creep",
                         "slip speed below which friction fades, m/s (default 0: Coulomb's law)"}},
      .make = [](const Settings& settings) -> std::unique_ptr<Engine> {
        return std::make_unique<PlainEngine>(settings);
      }};
}

}  // namespace stiction
