// SPDX-License-Identifier: GPL-3.0-or-later
// This project's own solver as a program behind the engine protocol. For the tests of `engine check`
// a fault of an adapter can be planted in it: --set fault=…
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/demand.h"
#include "validation/engine/engine.h"
#include "validation/engine/serve/serve.h"

namespace stiction {

namespace {

constexpr std::string_view kFaults[] = {"none",  "sign",   "degrees",  "gravity-twice", "swapped",
                                        "clock", "forget", "friction", "half-step",     "nan",
                                        "exit",  "finer",  "stands",   "hoards"};

// An engine whose adapter has one fault.
class FaultyEngine final : public Engine {
 public:
  FaultyEngine(std::unique_ptr<Engine> engine, std::string fault)
      : engine_(std::move(engine)), fault_(std::move(fault)) {
    if (std::find(std::begin(kFaults), std::end(kFaults), fault_) == std::end(kFaults)) {
      throw InputError("there is no such fault");
    }
  }

  void load(const Problem& problem, const Accuracy& accuracy) override {
    problem_ = problem;
    Accuracy asked = accuracy;
    if (fault_ == "degrees") {
      for (ProblemBody& body : problem_.bodies) body.angular_velocity *= std::numbers::pi / 180.0;
    } else if (fault_ == "gravity-twice") {
      for (Eigen::Vector3d& a : problem_.gravity.acceleration) a *= 2.0;
    } else if (fault_ == "friction") {
      for (Obstacle& obstacle : problem_.obstacles) obstacle.friction *= 1.02;
    } else if (fault_ == "finer") {
      asked.finer = 1.0;
    }
    engine_->load(problem_, asked);
  }

  void advance(std::uint64_t steps) override {
    forgotten_ = false;
    if (fault_ == "clock") return;
    if (fault_ == "exit" && engine_->steps_done() > 100) std::exit(0);
    if (fault_ == "half-step") steps = (steps + 1) / 2;
    engine_->advance(steps);
    if (fault_ == "hoards") hoard_.insert(hoard_.end(), steps, 1.0);
  }

  BodyMotion body(std::size_t index) const override {
    if (fault_ == "swapped") index = problem_.bodies.size() - 1 - index;
    BodyMotion motion = engine_->body(index);
    if (fault_ == "stands" && !problem_.obstacles.empty()) {
      motion.position = problem_.bodies[index].position;
    }
    if (forgotten_) motion.velocity.setZero();
    if (fault_ == "nan" && engine_->steps_done() > 100) {
      motion.position[1] = std::numeric_limits<double>::quiet_NaN();
    }
    return motion;
  }

  std::vector<ContactSample> contacts() const override {
    std::vector<ContactSample> all = engine_->contacts();
    if (fault_ == "sign") {
      for (ContactSample& one : all) {
        one.normal_force = -one.normal_force;
        one.friction_force = -one.friction_force;
      }
    }
    return all;
  }

  void restore(const Snapshot& snapshot) override {
    engine_->restore(snapshot);
    forgotten_ = fault_ == "forget";
  }

  double time_step() const override { return engine_->time_step(); }
  std::uint64_t steps_done() const override { return engine_->steps_done(); }
  // Its word also where another integrator is set.
  bool symplectic_euler() const override { return true; }
  Eigen::Matrix3Xi surface(std::size_t index) const override { return engine_->surface(index); }
  Eigen::Matrix3Xd vertices(std::size_t index) const override { return engine_->vertices(index); }
  Energies energies() const override { return engine_->energies(); }
  Momenta momenta() const override { return engine_->momenta(); }
  Settings settings() const override { return engine_->settings(); }
  Cost cost() const override { return engine_->cost(); }
  std::uint64_t state_hash() const override { return engine_->state_hash(); }
  Snapshot save() const override { return engine_->save(); }

 private:
  std::unique_ptr<Engine> engine_;
  std::string fault_;
  Problem problem_{};
  std::vector<double> hoard_{};  // a number a step
  bool forgotten_ = false;       // velocities are told as 0 until the next step
};

EngineKind hosted_kind() {
  EngineKind kind = find_engine("stiction");
  kind.name = "hosted";
  kind.description = "this project's solver behind the engine protocol";
  kind.settings_help["fault"] = "one of an adapter, planted for tests (default none)";
  kind.make = [make = kind.make](const Settings& settings) -> std::unique_ptr<Engine> {
    Settings own = settings;
    const auto fault = own.extract("fault");
    return std::make_unique<FaultyEngine>(make(own), fault ? fault.mapped() : "none");
  };
  return kind;
}

}  // namespace

}  // namespace stiction

int main(int argc, char** argv) {
  return stiction::serve_engine(stiction::hosted_kind(), {}, argc, argv);
}
