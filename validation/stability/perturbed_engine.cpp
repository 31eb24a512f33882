// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/stability/perturbed_engine.h"

#include <cmath>
#include <utility>

#include "solver/demand.h"
#include "validation/engine/build_of.h"
#include "validation/engine/kit/rounding.h"
#include "validation/engine/own_process.h"

namespace stiction {

namespace {

class PerturbedEngine final : public Engine, public OwnProcess {
 public:
  PerturbedEngine(const EngineKind& kind, Settings settings, const Perturbation& how,
                  std::shared_ptr<PerturbedTrace> trace)
      : kind_(kind),
        settings_(std::move(settings)),
        how_(how),
        mode_(kit::rounding_mode(kind.program.empty() ? how.rounding : kit::kNearest)),
        trace_(std::move(trace)) {
    const auto dt = settings_.find("dt");
    if (dt != settings_.end() && how_.frame.time != 1.0) {
      throw NotApplicable("the time step is set by hand, so that it does not follow other units");
    }
    inner_ = kind_.make(settings_);
  }

  ~PerturbedEngine() override {
    if (!trace_ || !loaded_) return;
    try {
      PerturbedTrace::End end;
      for (std::size_t b = 0; b < here_.bodies.size(); ++b) {
        end.bodies.push_back(body(b));
        end.sizes.push_back(longest_edge(here_.bodies[b].shape));
      }
      end.length = length_;
      end.speed = speed_;
      end.steps = steps_done();
      trace_->ends.push_back(std::move(end));
    } catch (const std::exception&) {
      // A program that is gone: its simulation has told so already.
    }
  }

  void load(const Problem& problem, const Accuracy& accuracy) override {
    here_ = problem;
    Accuracy asked = accuracy;
    int fineness = 0;
    double time_step = 0.0;
    if (how_.meshed || how_.frame.time != 1.0) {
      const std::unique_ptr<Engine> plain = kind_.make(settings_);
      plain->load(problem, accuracy);
      fineness = plain->fineness();
      time_step = plain->time_step();
    }
    if (how_.frame.time != 1.0) {
      asked.time = time_step * how_.frame.time;
      asked.finer = 1.0;
    }
    Perturbation how = how_;
    // A rigid body is its shape, whatever meshes it.
    how.meshed = how.meshed && kind_.manifest.deformable;
    PerturbedProblem there = perturbed(problem, how, fineness);
    order_ = std::move(there.order);
    const std::string lacking = missing(kind_.manifest, there.problem);
    if (!lacking.empty()) throw NotApplicable("the engine has no " + lacking);
    {
      const kit::Rounds rounds(mode_);
      inner_->load(there.problem, asked);
    }
    if (how_.frame.time != 1.0 && std::abs(inner_->time_step() / asked.time - 1.0) > 1e-9) {
      throw NotApplicable("the engine's time step does not follow other units");
    }
    measure();
    loaded_ = true;
  }

  double time_step() const override { return inner_->time_step() / how_.frame.time; }
  std::uint64_t steps_done() const override { return inner_->steps_done(); }
  bool symplectic_euler() const override { return inner_->symplectic_euler(); }

  void advance(std::uint64_t steps) override {
    const kit::Rounds rounds(mode_);
    if (!how_.rewinds) return inner_->advance(steps);
    for (std::uint64_t k = 0; k < steps; ++k) {
      const Snapshot before = inner_->save();
      inner_->advance(1);
      const std::uint64_t first = inner_->state_hash();
      inner_->restore(before);
      inner_->advance(1);
      if (!trace_) continue;
      ++trace_->rewound;
      if (inner_->state_hash() != first) ++trace_->unlike;
    }
  }

  BodyMotion body(std::size_t index) const override {
    const BodyMotion seen = inner_->body(order_.bodies.at(index));
    const ReferenceFrame& frame = how_.frame;
    return {frame.position_back(seen.position, seen_time()), frame.velocity_back(seen.velocity),
            frame.rotation_back(seen.rotation),
            frame.axial_back(seen.angular_velocity) * frame.time};
  }

  std::vector<ContactSample> contacts() const override {
    std::vector<ContactSample> samples = inner_->contacts();
    const ReferenceFrame& frame = how_.frame;
    for (ContactSample& one : samples) {
      one.obstacle = place_here(one.against_body ? order_.bodies : order_.obstacles, one.obstacle);
      one.body = place_here(order_.bodies, one.body);
      one.normal = frame.turned_back(one.normal);
      one.gap /= frame.length;
      one.normal_force /= frame.force();
      one.friction_force = frame.turned_back(one.friction_force) / frame.force();
      one.slip = frame.turned_back(one.slip) / (frame.length / frame.time);
      one.position = frame.position_back(one.position, seen_time());
      one.arm = frame.turned_back(one.arm) / frame.length;
    }
    return samples;
  }

  Eigen::Matrix3Xi surface(std::size_t index) const override {
    Eigen::Matrix3Xi triangles = inner_->surface(order_.bodies.at(index));
    if (how_.frame.mirrors() && triangles.cols() > 0) triangles.row(1).swap(triangles.row(2));
    return triangles;
  }

  Eigen::Matrix3Xd vertices(std::size_t index) const override {
    Eigen::Matrix3Xd all = inner_->vertices(order_.bodies.at(index));
    for (Eigen::Index v = 0; v < all.cols(); ++v) {
      all.col(v) = how_.frame.position_back(all.col(v), seen_time());
    }
    return all;
  }

  Energies energies() const override {
    const ReferenceFrame& frame = how_.frame;
    Energies all = inner_->energies();
    if (!frame.drift.isZero(0.0)) {
      const Vec3 linear = inner_->momenta().linear;
      all.kinetic += frame.drift.dot(0.5 * seen_mass() * frame.drift - linear);
    }
    all.kinetic /= frame.energy();
    all.elastic /= frame.energy();
    // −Σ m g·x over there, and g·(x' − offset) is what is meant here.
    const Vec3 gravity = frame.force() / frame.mass * frame.turned(here_.gravity.at(time()));
    all.gravity += seen_mass() * gravity.dot(offset());
    all.gravity /= frame.energy();
    return all;
  }

  Momenta momenta() const override {
    const ReferenceFrame& frame = how_.frame;
    const Momenta seen = inner_->momenta();
    const Vec3 linear = seen.linear - seen_mass() * frame.drift;
    // About the origin of here, without the drift of what is there.
    Vec3 first_moment = Vec3::Zero();  // Σ m (x' − offset)
    for (std::size_t b = 0; b < here_.bodies.size(); ++b) {
      first_moment +=
          frame.mass * here_.bodies[b].mass * (inner_->body(order_.bodies[b]).position - offset());
    }
    const Vec3 angular =
        seen.angular - offset().cross(seen.linear) - first_moment.cross(frame.drift);
    return {frame.turned_back(linear) / frame.momentum(),
            frame.axial_back(angular) / (frame.momentum() * frame.length)};
  }

  std::vector<Mesh> meshes() const override { return inner_->meshes(); }
  int fineness() const override { return inner_->fineness(); }
  Settings settings() const override {
    Settings all = inner_->settings();
    all[kPerturbedSetting] = how_.name;
    return all;
  }
  Cost cost() const override { return inner_->cost(); }
  std::optional<std::int64_t> resident_memory() const override {
    const auto* const process = dynamic_cast<const OwnProcess*>(inner_.get());
    return process ? process->resident_memory() : std::nullopt;
  }
  std::uint64_t state_hash() const override { return inner_->state_hash(); }
  Snapshot save() const override { return inner_->save(); }
  void restore(const Snapshot& snapshot) override { inner_->restore(snapshot); }

 private:
  double time() const { return static_cast<double>(steps_done()) * time_step(); }
  double seen_time() const { return static_cast<double>(steps_done()) * inner_->time_step(); }
  Vec3 offset() const { return how_.frame.shift + how_.frame.drift * seen_time(); }
  double seen_mass() const {
    double mass = 0.0;
    for (const ProblemBody& body : here_.bodies) mass += body.mass;
    return mass * how_.frame.mass;
  }

  static std::size_t place_here(const std::vector<std::size_t>& places, std::size_t there) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (places[k] == there) return k;
    }
    return there;
  }

  // What digits of positions and velocities count from: the scene's width, for coordinates round as
  // it is wide, and its fastest speed, or that of a fall over its width.
  void measure() {
    for (const ProblemBody& body : here_.bodies) speed_ = std::max(speed_, body.velocity.norm());
    length_ = bounds_of(here_).sizes().maxCoeff();
    if (length_ == 0.0) length_ = 1.0;  // a point mass has no size: a metre
    speed_ = std::max(speed_, std::sqrt(here_.gravity.scale() * length_));
    if (speed_ == 0.0) speed_ = 1.0;  // weightless and at rest: a metre a second
  }

  EngineKind kind_;
  Settings settings_;
  Perturbation how_;
  int mode_;  // in which this thread rounds while the engine is at work
  std::shared_ptr<PerturbedTrace> trace_;
  std::unique_ptr<Engine> inner_;
  Problem here_;
  Order order_;
  double length_ = 0.0, speed_ = 0.0;
  bool loaded_ = false;
};

Settings without_name(Settings settings) {
  settings.erase(kPerturbedSetting);
  return settings;
}

}  // namespace

EngineKind perturbed(const EngineKind& kind, const Perturbation& how,
                     std::shared_ptr<PerturbedTrace> trace) {
  const EngineKind inner = how.build.empty() ? kind : build_of(kind, how.build);
  if (how.rewinds && !inner.manifest.snapshots) throw NotApplicable("the engine has no snapshots");
  const bool rounds_itself = how.rounding != kit::kNearest && !inner.program.empty();
  if (rounds_itself && inner.settings_help.count(kit::kRounding) == 0) {
    throw NotApplicable("the engine's program has no setting 'rounding'");
  }
  EngineKind outer = kind;
  outer.manifest = inner.manifest;
  outer.expectations.clear();
  outer.studies = nullptr;
  outer.make = [=](const Settings& settings) -> std::unique_ptr<Engine> {
    Settings given = without_name(settings);
    if (rounds_itself) given[kit::kRounding] = how.rounding;
    return std::make_unique<PerturbedEngine>(inner, std::move(given), how, trace);
  };
  if (kind.idle) {
    outer.idle = [idle = kind.idle](const Settings& settings) {
      return idle(without_name(settings));
    };
  }
  return outer;
}

}  // namespace stiction
