// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/properties/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "solver/demand.h"
#include "validation/observe/passage_watch.h"

namespace stiction::test {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// Δt is a fourth of what the solver takes by itself, ≤ 0.8 of the stability limit Δt ω = 2.
constexpr double kFiner = 4.0;

// Symplectic Euler conserves H − ½Δt v·∇U of an oscillator, and |½Δt v·∇U| ≤ ½Δt ω H: its energy
// swings by (1 + a)/(1 − a), a = ½ Δt ω ≤ 0.8/kFiner.
constexpr double kShare = 0.8 / kFiner;
constexpr double kSwing = (1.0 + kShare) / (1.0 - kShare);

class Claims {
 public:
  Claims(const RandomScene& scene, const Settings& settings)
      : problem_(problem_of(scene)),
        method_(settings.at("method")),
        engine_(find_engine("stiction").make(settings)),
        watch_(problem_),
        friction_(friction_of(scene)),
        held_(scene.ground == 2) {
    engine_->load(problem_, {.finer = kFiner});
    for (const ProblemBody& body : problem_.bodies) {
      mass_ += body.mass;
      lightest_ = std::min(lightest_, body.mass);
    }
    for (const Load& load : problem_.loads) {
      for (const Vec3& force : load.force.value) load_ = std::max(load_, force.norm());
    }
    for (const Mesh& mesh : engine_->meshes()) {
      terms_ = std::max(terms_, static_cast<double>(mesh.vertices));
    }
    terms_ *= static_cast<double>(problem_.bodies.size());
    start_ = before_ = engine_->energies();
    momentum_ = engine_->momenta().linear;
  }

  void step() {
    std::vector<Vec3> centres;
    for (const Load& load : problem_.loads) centres.push_back(engine_->body(load.body).position);
    const double time = static_cast<double>(engine_->steps_done()) * engine_->time_step();
    engine_->advance(1);
    const std::vector<ContactSample> contacts = engine_->contacts();
    outcome.contacts += contacts.size();
    energies_ = engine_->energies();
    for (std::size_t k = 0; k < centres.size(); ++k) {
      const Load& load = problem_.loads[k];
      work_ += load.force.at(time).dot(engine_->body(load.body).position - centres[k]);
    }
    claim_finite();
    claim_momentum(time, contacts);
    claim_cone(contacts);
    claim_dissipation(contacts);
    claim_energy();
    before_ = energies_;
    if (engine_->steps_done() >= watch_.due_step()) claim_no_passage(false);
  }

  void end() {
    claim_no_passage(true);
    // A sum of as many terms, each of some roundings.
    const double round_off = 8.0 * kEpsilon * friction_scale_;
    outcome.friction_work = friction_work_;
    if (method_ == "quiet" && sliding_work_ > round_off) {
      breaks("contacts that slide have given {:.3g} J (round-off: {:.1g} J)", sliding_work_,
             round_off);
    }
  }

  Outcome outcome;

 private:
  template <class... Values>
  void breaks(fmt::format_string<Values...> words, Values&&... values) {
    if (!outcome.broken.empty()) return;
    outcome.broken = fmt::format("step {}: ", engine_->steps_done()) +
                     fmt::format(words, std::forward<Values>(values)...);
  }

  void claim_finite() {
    if (std::isfinite(energies_.kinetic + energies_.elastic + energies_.gravity)) return;
    breaks("an energy is not finite");
  }

  // A term of Σ m v is rounded as it is added, `terms_` times; so are the impulses that a step adds
  // to a vertex, those of remembered forces too, which it then corrects: of as much as the force of the
  // step before was, of which the paper's method keeps 0.3 for the next. Those of elasticity are not told: Δt |f| ≤ Δt √(2 U k) with Δt² k ≤ 4 m, hence
  // below 2 √(2 U m), and of damping below that of velocities.
  void claim_momentum(double time, const std::vector<ContactSample>& contacts) {
    const double dt = engine_->time_step();
    const Vec3 now = engine_->momenta().linear;
    Vec3 force = mass_ * problem_.gravity.at(time) - problem_.drag.at(time) * momentum_;
    double scale = force.norm();
    for (const Load& load : problem_.loads) {
      force += load.force.at(time);
      scale += load.force.at(time).norm();
    }
    bool exact = !held_;
    for (const ContactSample& contact : contacts) {
      const Vec3 one = contact.normal_force * contact.normal + contact.friction_force;
      scale += one.norm();
      if (!contact.against_body) force += one;
      exact = exact && (method_ != "old" || !contact.against_body);
    }
    const double energy =
        std::max(energies_.kinetic, before_.kinetic) + std::max(energies_.elastic, before_.elastic);
    const double impulse = std::max(dt * scale, remembered_impulse_);
    remembered_impulse_ = std::max(dt * scale, 0.3 * remembered_impulse_);
    const double tolerance =
        16.0 * terms_ * kEpsilon * (impulse + 3.0 * std::sqrt(2.0 * mass_ * energy));
    const double error = (now - momentum_ - dt * force).norm();
    if (exact && !(error <= tolerance)) {
      breaks("momentum is off by {:.3g} kg m/s (round-off: {:.1g})", error, tolerance);
    }
    momentum_ = now;
  }

  // Clamped to μ fⁿ, by a norm, a quotient and three products.
  void claim_cone(const std::vector<ContactSample>& contacts) {
    for (const ContactSample& contact : contacts) {
      const double bound = friction_ * contact.normal_force;
      if (!(contact.normal_force >= 0.0)) breaks("a contact pulls");
      if (!(contact.friction_force.norm() <= bound * (1.0 + 16.0 * kEpsilon))) {
        breaks("friction {:.17g} N is outside its cone, {:.17g} N", contact.friction_force.norm(),
               bound);
      }
    }
  }

  void claim_dissipation(const std::vector<ContactSample>& contacts) {
    std::map<std::pair<bool, std::int64_t>, int> touching;  // contacts of a point
    bool between_bodies = false;
    for (const ContactSample& contact : contacts) {
      ++touching[{false, contact.point}];
      between_bodies = between_bodies || contact.against_body;
    }
    // Of any vertex, before or after the step: what a contact stops is gone afterwards. And in those
    // before, whose force a contact remembers and corrects: the rounding of that force is slip, of
    // which the paper's method takes away g = 0.7 a step.
    double now =
        std::sqrt(2.0 * std::max(energies_.kinetic, before_.kinetic) * terms_ / lightest_) +
        engine_->time_step() * (problem_.gravity.scale() + load_ / lightest_);
    for (const ContactSample& contact : contacts) now = std::max(now, contact.slip.norm());
    const double fastest = std::max(now, remembered_);
    remembered_ = std::max(now, 0.3 * remembered_);
    for (const ContactSample& contact : contacts) {
      const double power = contact.friction_force.dot(contact.slip);
      friction_work_ += engine_->time_step() * power;
      const double force = contact.friction_force.norm(), slip = contact.slip.norm();
      friction_scale_ += engine_->time_step() * force * fastest;
      if (!contact.sticks) sliding_work_ += engine_->time_step() * power;
      const double round_off = 16.0 * kEpsilon * fastest;  // of u, m/s
      if (between_bodies || touching[{false, contact.point}] > 1) continue;
      if (power > force * round_off) breaks("friction gives {:.3g} W at a half-space", power);
      if (!contact.sticks && force > 0.0 && slip > 1e6 * round_off &&
          power > -(1.0 - 1e-6) * force * slip) {
        breaks("friction is not against the slip, but f·u = {:.9g} |f||u|", power / (force * slip));
      }
    }
  }

  void claim_energy() {
    if (method_ != "quiet") return;
    const double given = start_.gravity - energies_.gravity + work_;
    most_given_ = std::max(most_given_, given);
    const double own = energies_.kinetic + energies_.elastic;
    const double there = start_.kinetic + start_.elastic;
    const double allowed = there + given + (kSwing - 1.0) * (there + most_given_);
    // Of numbers that are differences of potentials, whose zero is anywhere.
    const double round_off =
        terms_ * kEpsilon *
        (own + std::abs(start_.gravity) + std::abs(energies_.gravity) + std::abs(work_));
    if (own > allowed + round_off) {
      breaks("energy is {:.6g} J where {:.6g} J were there or given", own, there + given);
    }
  }

  void claim_no_passage(bool at_end) {
    if (method_ != "quiet") return;
    watch_.look(*engine_, at_end);
    if (!watch_.found().empty()) breaks("not refused: {}", watch_.found().front());
  }

  Problem problem_;
  std::string method_;
  std::unique_ptr<Engine> engine_;
  PassageWatch watch_;
  double friction_;
  bool held_;
  double mass_ = 0.0;                                          // of all bodies, kg
  double lightest_ = std::numeric_limits<double>::infinity();  // of one, kg
  double load_ = 0.0;                                          // strongest, N
  double terms_ = 1.0;                                         // vertices, at least
  Energies start_, before_, energies_;
  Vec3 momentum_ = Vec3::Zero();
  double remembered_impulse_ = 0.0;                                         // N s
  double remembered_ = 0.0;                                                 // m/s
  double work_ = 0.0, most_given_ = 0.0;                                    // J
  double friction_work_ = 0.0, sliding_work_ = 0.0, friction_scale_ = 0.0;  // J
};

}  // namespace

Outcome outcome_of(const RandomScene& scene, const Settings& settings, int steps) {
  Claims claims(scene, settings);
  try {
    for (int k = 0; k < steps && claims.outcome.broken.empty(); ++k) claims.step();
    claims.end();
  } catch (const InputError& refusal) {
    claims.outcome.refused = refusal.what();
  }
  return claims.outcome;
}

}  // namespace stiction::test
