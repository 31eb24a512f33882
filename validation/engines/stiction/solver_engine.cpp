// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/solver_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "solver/demand.h"
#include "solver/elasticity/corotational.h"
#include "solver/observables.h"
#include "solver/scene/time_step_limit.h"
#include "solver/step.h"
#include "validation/engine/cpu_time.h"
#include "validation/engine/engine.h"
#include "validation/engine/settings.h"
#include "validation/engines/stiction/configurations.h"
#include "validation/engines/stiction/contact_samples.h"
#include "validation/engines/stiction/solver_view.h"
#include "validation/engines/stiction/step_cost.h"
#include "validation/engines/stiction/stiction_method.h"
#include "validation/engines/stiction/stiction_scene.h"

namespace stiction {

namespace {

// How often a run looks whether it still consists of numbers, in steps.
constexpr std::uint64_t kFiniteEvery = 256;

// Largest of 1, 2, 5 × 10ⁿ not above `limit`.
double round_down_125(double limit) {
  const double decade = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * decade <= limit) return factor * decade;
  }
  return decade;
}

// The largest step not above `limit`, s, of which a whole number makes 10 ms, as cases ask for times;
// of limits of 10 ms or more, the limit.
double step_below(double limit) {
  constexpr double kWhole = 1e-2;
  return limit < kWhole ? kWhole / std::ceil(kWhole / limit) : limit;
}

// Least n with 10 n² + 2 surface vertices or more.
int ball_frequency(int vertices) {
  int n = 1;
  while (10 * n * n + 2 < vertices) ++n;
  return n;
}

class StictionEngine final : public Engine {
 public:
  explicit StictionEngine(const Settings& given) : given_(given) {
    SettingsReader reader(given);
    read_method(reader, options_);
    chosen_cells_ = reader.has("cells");
    how_.cells = reader.count("cells", how_.cells);
    chosen_ball_ = reader.has("ball");
    how_.ball = reader.count("ball", how_.ball);
    chosen_time_step_ = reader.has("dt");
    options_.time_step = reader.number("dt", options_.time_step);
    settled_ = reader.number("settled", settled_);
    if (settled_ < 0.0) throw InputError("setting 'settled' must not be below 0");
    reader.refuse_unknown("stiction");
    check_options(options_);
  }

  void load(const Problem& problem, const Accuracy& accuracy) override {
    if (accuracy.fineness > 0 && !chosen_cells_) how_.cells = accuracy.fineness;
    if (accuracy.roundness > 0 && !chosen_ball_) how_.ball = ball_frequency(accuracy.roundness);
    origin_ = own_origin(problem);
    SceneDescription description = scene_description(seen_from(origin_, problem), how_);
    // Of a place far away.
    constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
    description.rounding = static_cast<Real>(kRounding * origin_.norm());
    scene_ = build_scene(description);
    meshes_ = distinct_meshes(description);
    if (!chosen_time_step_) {
      const bool asked = accuracy.time > 0.0 && accuracy.time <= scene_.stable_time_step;
      options_.time_step =
          asked ? accuracy.time : std::min(options_.time_step, own_time_step(description));
    }
    options_.time_step /= accuracy.finer;
    check_options(options_, scene_);
    state_ = initial_state(scene_);
    workspace_ = Workspace{};
    team_choice_ = TeamChoice(team_);
    if (team_.size() > 1) workspace_.team_choice = &team_choice_;
    if (settled_ > 0.0) settle(problem, accuracy);
    begun_ = state_.step;
  }

  double time_step() const override { return options_.time_step; }
  std::uint64_t steps_done() const override { return state_.step - begun_; }
  // To round-off means that of double precision.
  bool symplectic_euler() const override {
    return std::is_same_v<Real, double> && options_.integrator == Integrator::kSymplecticEuler;
  }

  void advance(std::uint64_t steps) override {
    const double before = cpu_seconds_so_far();
    for (std::uint64_t k = 0; k < steps; ++k) {
      workspace_.phase_seconds = cost_.phases_of(state_.step);
      step(scene_, options_, state_, workspace_);
      cost_.add_step(workspace_);
      if (workspace_.search.outrun.travel > 0.0) refuse_outrun();
      if (workspace_.search.too_deep.depth > 0.0) refuse_passage();
      if (cost_.steps() % kFiniteEvery == 0 || k + 1 == steps) demand_finite();
    }
    cost_.add_cpu(cpu_seconds_so_far() - before);
  }

  BodyMotion body(std::size_t index) const override {
    const Body& body = scene_.bodies.at(index);
    return {origin_ + centre_of_mass(scene_, state_, body), centre_velocity(scene_, state_, body),
            Eigen::Quaterniond(fitted_rotation(scene_, state_, body)),
            angular_velocity(scene_, state_, body)};
  }

  std::vector<ContactSample> contacts() const override {
    std::vector<ContactSample> samples =
        contact_samples(scene_, state_, workspace_, options_.time_step);
    for (ContactSample& one : samples) one.position += origin_;
    return samples;
  }

  Eigen::Matrix3Xi surface(std::size_t index) const override {
    const Body& body = scene_.bodies.at(index);
    Eigen::Matrix4Xi tetrahedra(4, body.element_count);
    for (int e = 0; e < body.element_count; ++e) {
      const Element& element = scene_.elements[static_cast<std::size_t>(body.first_element + e)];
      for (int k = 0; k < 4; ++k) tetrahedra(k, e) = element.vertex[k] - body.first_vertex;
    }
    return surface_triangles(tetrahedra);
  }

  Eigen::Matrix3Xd vertices(std::size_t index) const override {
    const Body& body = scene_.bodies.at(index);
    Eigen::Matrix3Xd positions(3, body.vertex_count);
    for (int v = 0; v < body.vertex_count; ++v) {
      positions.col(v) =
          origin_ +
          state_.position[static_cast<std::size_t>(body.first_vertex + v)].x.cast<double>();
    }
    return positions;
  }

  Energies energies() const override {
    const double time = static_cast<double>(state_.step) * options_.time_step;
    // About the world's origin, so that its zero stays where it is while gravity grows.
    double mass = 0.0;
    for (const Body& body : scene_.bodies) mass += body.mass;
    const double of_origin = -mass * scene_.gravity.at(time).dot(origin_);
    return {kinetic_energy(), gravity_energy(scene_, state_, time) + of_origin,
            elastic_energy(scene_, state_.position)};
  }

  double kinetic_energy() const override { return stiction::kinetic_energy(scene_, state_); }

  Momenta momenta() const override {
    const Eigen::Vector3d linear = linear_momentum(scene_, state_);
    return {linear, angular_momentum(scene_, state_) + origin_.cross(linear)};
  }

  std::vector<Mesh> meshes() const override { return meshes_; }

  int fineness() const override { return how_.cells; }

  Settings settings() const override {
    Settings all = method_settings(options_, scene_.pairs_possible);
    all["dt"] = fmt::format("{}", options_.time_step);
    all["cells"] = fmt::format("{}", how_.cells);
    if (settled_ > 0.0) all["settled"] = fmt::format("{}", settled_);
    return all;
  }

  Cost cost() const override { return cost_.total(workspace_.contact_updates); }
  double cpu_seconds() const override { return cost_.cpu_seconds(); }

  std::uint64_t state_hash() const override { return hash_of(state_); }
  Snapshot save() const override { return std::make_shared<const State>(state_); }
  void restore(const Snapshot& snapshot) override {
    state_ = *static_cast<const State*>(snapshot.get());
    // Those of the step after the snapshot; there are none until the next step.
    workspace_.contacts.clear();
    workspace_.pairs.clear();
    workspace_.edges.clear();
  }

  SolverView view() const { return {scene_, options_, workspace_}; }

 private:
  // Where bodies touch each other a step nearer the limit costs digits: with it 5 scenes of the suite
  // of stability, tips and edges on one another, slip by more than they may. Elsewhere a body that is
  // damped keeps its margin of 20 % to the limit of the whole body near rest, and none to that of
  // elements: below it such bodies hold where they are crumpled, by 0.3 of an edge and mostly by 0.5,
  // and without damping they don't.
  double own_time_step(const SceneDescription& description) const {
    const double stable = scene_.stable_time_step;
    if (scene_.pairs_possible) return round_down_125(0.8 * stable);
    double limit = stable;
    for (const BodyDescription& body : description.bodies) {
      const bool damped = body.material.damping_time > 0.0;
      limit = std::min(limit, 0.8 * (damped ? body_time_step_limit(body) : stable));
    }
    return step_below(limit);
  }

  // The state in which comparisons begin (settled_without_memory() in validation/comparison/), made
  // by the engine itself: a program cannot take up a state of another process.
  void settle(const Problem& problem, const Accuracy& accuracy) {
    const auto with_rule = [&](const char* rule) {
      Settings settings;
      for (const char* name : {"method", "depth", "dt", "cells", "ball"}) {
        const auto found = given_.find(name);
        if (found != given_.end()) settings.insert(*found);
      }
      settings["rule"] = rule;
      auto engine = std::make_unique<StictionEngine>(settings);
      engine->load(problem, accuracy);
      return engine;
    };
    const auto settling = with_rule("stored-vector");
    settling->advance(static_cast<std::uint64_t>(std::llround(settled_ / settling->time_step())));
    const auto forgetting = with_rule("none");
    forgetting->restore(settling->save());
    forgetting->advance(1);
    restore(forgetting->save());
  }

  double cpu_seconds_so_far() const { return thread_cpu_seconds() + team_.helpers_cpu_seconds(); }

  [[noreturn]] void refuse_outrun() const {
    const PairSearch::Outrun& outrun = workspace_.search.outrun;
    const auto name = [&](std::int32_t b) -> const std::string& {
      return scene_.bodies[static_cast<std::size_t>(b)].name;
    };
    throw InputError(fmt::format(
        "'{}' and '{}' come at each other by {:.3g} mm in a step, more than an element of the "
        "thinner one is wide ({:.3g} mm), so that they could pass through each other unseen: the "
        "time step must be below {:.2g} s",
        name(outrun.body), name(outrun.other), 1e3 * outrun.travel, 1e3 * outrun.width,
        options_.time_step * outrun.width / outrun.travel));
  }

  [[noreturn]] void refuse_passage() const {
    const PairSearch::TooDeep& deep = workspace_.search.too_deep;
    throw InputError(fmt::format(
        "'{}' has sunk {:.3g} mm into '{}', {:.2g} of the width of its least element ({:.3g} mm), "
        "at "
        "t = {:.4g} s: it is passing through; a smaller time step or stiffer bodies may hold",
        scene_.bodies[body_of(scene_, deep.vertex)].name, 1e3 * deep.depth,
        scene_.bodies[static_cast<std::size_t>(deep.body)].name, deep.depth / deep.width,
        1e3 * deep.width, static_cast<double>(state_.step) * options_.time_step));
  }

  void demand_finite() const {
    if (is_finite(state_)) return;
    throw InputError(fmt::format("the simulation diverged before t = {:.4g} s (step {})",
                                 static_cast<double>(state_.step) * options_.time_step,
                                 state_.step));
  }

  Settings given_;
  Options options_;
  Discretisation how_;
  double settled_ = 0.0;     // s
  std::uint64_t begun_ = 0;  // steps of the solver at the engine's time 0
  // What a user set goes before what a case asks for.
  bool chosen_cells_ = false, chosen_ball_ = false, chosen_time_step_ = false;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  // of the solver's coordinates
  Scene scene_;
  std::vector<Mesh> meshes_;
  State state_;
  Team team_{step_threads()};
  TeamChoice team_choice_{team_};
  Workspace workspace_;
  StepCost cost_;
};

std::unique_ptr<Engine> make(const Settings& settings) {
  return std::make_unique<StictionEngine>(settings);
}

// What boxes on a slope take by themselves, then its halves: errors are of first order in it.
const std::vector<Settings> kLadder{
    {{"dt", "1e-4"}}, {{"dt", "5e-5"}}, {{"dt", "2.5e-5"}}, {{"dt", "1.25e-5"}}};

std::map<std::string, std::string> settings_help() {
  std::map<std::string, std::string> help = method_settings_help();
  const auto add = [&help](const char* name, const char* words) {
    demand(help.emplace(name, words).second, "a rule's parameter has the name of another setting");
  };
  add("dt", "time step, s (default 2e-4, or less where stability asks for it)");
  add("cells", "cells along a box's longest edge (default 2)");
  add("settled",
      "begins in a state that the stored vector has held for so long, s, and that has lost its "
      "friction memory (default 0: at the problem's own start)");
  add("ball", "frequency n of a ball's triangulation, 10 n² + 2 surface vertices (default 8)");
  return help;
}

}  // namespace

SolverView solver_view(const Engine& engine) {
  const auto* const own = dynamic_cast<const StictionEngine*>(&engine);
  if (own == nullptr) throw NotApplicable("it looks into the solver, which a wrapper hides");
  return own->view();
}

EngineKind solver_engine() {
  return {
      .name = "stiction",
      .description = "this project's solver: tetrahedra, penalty contact, coherent static friction",
      .manifest = {.point_masses = true,
                   .boxes = true,
                   .balls = true,
                   .meshes = true,
                   .deformable = true,
                   .held_parts = true,
                   .body_contact = true,
                   .self_contact = true,
                   .moving_obstacles = true,
                   .steady_motion = true,
                   .oscillation = true,
                   .pair_friction = true,
                   .drag = true,
                   .varying_gravity = true,
                   .loads = true,
                   .spin = true,
                   .contacts = true,
                   .snapshots = true},
      .settings_help = settings_help(),
      .make = make,
      .configurations = configurations_of,
      .configuration = configuration_of,
      .idle = idle_settings,
      .without = settings_without,
      .builds = {{"single", "stiction_single"}, {"fused", "stiction_fused"}},
      .ladder = kLadder};
}

}  // namespace stiction
