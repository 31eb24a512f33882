// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/frozen_step.h"

#include <cmath>

#include "solver/contact/slip.h"
#include "solver/step.h"
#include "validation/engine/settings.h"
#include "validation/engines/stiction/stiction_method.h"
#include "validation/engines/stiction/stiction_scene.h"

namespace stiction {

namespace {

constexpr int kLearning = 200;     // steps
constexpr double kNoCone = 100.0;  // times μ

// Two unit vectors of the plane normal to n.
Eigen::Matrix<double, 3, 2> tangents(const Vec3& n) {
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = n.unitOrthogonal();
  basis.col(1) = n.cross(basis.col(0));
  return basis;
}

}  // namespace

FrozenStep::FrozenStep(const EngineKind& kind, const ComparisonScene& scene,
                       const std::string& method) {
  Settings settings = scene.settings;
  settings["method"] = method;
  settings["rule"] = "fixed-point";
  settings["memory"] = "keep";
  const auto engine = kind.make(settings);
  engine->load(scene.problem, {});
  engine->restore(settled_without_memory(kind, scene, {{"method", method}}).state);
  engine->advance(kLearning);
  start_ = *static_cast<const State*>(engine->save().get());

  SettingsReader reader(settings);
  read_method(reader, options_);
  options_.time_step = engine->time_step();
  options_.friction["gain"] = 0.0;  // what is prescribed stays
  SceneDescription description =
      scene_description(scene.problem, {.cells = reader.count("cells", Discretisation{}.cells),
                                        .ball = reader.count("ball", Discretisation{}.ball)});
  description.friction *= kNoCone;
  for (HalfSpace& obstacle : description.half_spaces) obstacle.friction *= kNoCone;
  for (PairFriction& pair : description.pair_friction) pair.friction *= kNoCone;
  scene_ = build_scene(description);
  check_options(options_, scene_);

  replay("fixed-point", start_.pair_friction.value);
  const std::vector<ContactKey>& known = start_.pair_friction.key;
  std::size_t from = 0;
  for (const PairContact& contact : workspace_.pairs) {
    while (from < known.size() && known[from] < contact.key()) ++from;
    const bool persists = from < known.size() && known[from] == contact.key();
    if (persists && contact.normal_force > 0.0) place_.push_back(from);
  }
}

void FrozenStep::replay(const char* rule, const std::vector<double>& memory) const {
  Options options = options_;
  options.rule = rule;
  state_ = start_;
  state_.pair_friction.value = memory;
  step(scene_, options, state_, workspace_);
}

Vec3 FrozenStep::slip_of(const PairContact& contact) const {
  return stiction::slip_of(contact, state_.velocity);
}

Eigen::VectorXd FrozenStep::learned() const {
  Eigen::VectorXd xi(contacts());
  for (Eigen::Index k = 0; k < contacts(); ++k) {
    xi(k) = start_.pair_friction.value[place_[static_cast<std::size_t>(k)]];
  }
  return xi;
}

FrozenStep::Slip FrozenStep::slip_with(const Eigen::VectorXd& xi) const {
  std::vector<double> memory = start_.pair_friction.value;
  for (Eigen::Index k = 0; k < contacts(); ++k) memory[place_[static_cast<std::size_t>(k)]] = xi(k);
  replay("fixed-point", memory);
  Slip result{Eigen::VectorXd::Zero(contacts()), Eigen::VectorXd::Zero(contacts()),
              Eigen::VectorXd::Zero(contacts())};
  Eigen::Index k = 0;
  for (const PairContact& contact : workspace_.pairs) {
    if (k == contacts() ||
        contact.key() != start_.pair_friction.key[place_[static_cast<std::size_t>(k)]]) {
      continue;
    }
    // f = −ξ ũ/w.
    const Vec3 free = -options_.time_step * contact.inverse_mass / xi(k) * contact.friction_force;
    const Vec3 direction = free.normalized();
    const Vec3 slip = slip_of(contact);
    result.along(k) = slip.dot(direction);
    result.across(k) = slip.dot(contact.normal.cross(direction));
    result.free(k) = free.norm();
    ++k;
  }
  return result;
}

Eigen::VectorXd FrozenStep::slip_with_bias(const Eigen::VectorXd& bias) const {
  std::vector<double> memory(3 * start_.pair_friction.key.size(), 0.0);
  for (Eigen::Index k = 0, c = 0; k < contacts(); ++c) {
    const PairContact& contact = workspace_.pairs[static_cast<std::size_t>(c)];
    const std::size_t place = place_[static_cast<std::size_t>(k)];
    if (contact.key() != start_.pair_friction.key[place]) continue;
    Eigen::Map<Vec3>(memory.data() + 3 * place) = tangents(contact.normal) * bias.segment<2>(2 * k);
    ++k;
  }
  replay("bias-vector", memory);
  Eigen::VectorXd slip(2 * contacts());
  for (Eigen::Index k = 0, c = 0; k < contacts(); ++c) {
    const PairContact& contact = workspace_.pairs[static_cast<std::size_t>(c)];
    if (contact.key() != start_.pair_friction.key[place_[static_cast<std::size_t>(k)]]) continue;
    slip.segment<2>(2 * k) = tangents(contact.normal).transpose() * slip_of(contact);
    ++k;
  }
  return slip;
}

}  // namespace stiction
