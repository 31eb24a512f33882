// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "reference/meshes/box_mesh.h"
#include "validation/observe/observe.h"
#include "validation/problems/free_boxes.h"

namespace stiction {

namespace {

// What symplectic Euler does to the angular momentum L = Σ x × m v. With Δp what a step adds to a
// vertex's momentum, and x_{n+1} = x_n + Δt v_{n+1}:
//
//   L_{n+1} = Σ x_n × m v_{n+1} + Δt Σ v_{n+1} × m v_{n+1} = L_n + Σ x_n × Δp          exactly,
//
// since L_n may be written with x_n and v_n. Internal forces are computed at x_n and have no moment
// there: they drop out. A contact adds Δt f at its vertex i and −Δt hⱼ f at its partners j, hence
//
//   L_{n+1} − L_n = Δt Σ_contacts r × f,   r = xᵢ − Σ hⱼ xⱼ at the start of the step,
//
// with f its normal and friction force together. r = 0 for weights that reproduce xᵢ.

constexpr double kDuration = 0.06;  // s; a collision takes some 10 ms

constexpr double kDamping = 1e-3;  // β, s

// The collision is off the centres and 45° off the normal, the upper box turned about a direction
// that is none of the mesh's.
Problem two_boxes() {
  const Eigen::Quaterniond turn(
      Eigen::AngleAxisd(std::numbers::pi / 9.0, Vec3(1.0, 0.6, 0.3).normalized()));
  return free_problem(
      "two free boxes",
      {free_cube("lower", {-0.013, 0.009, -0.052}, {-0.5, -0.15, 0.5}, kDamping),
       free_cube("upper", {0.013, -0.009, 0.075}, {0.5, 0.15, -0.5}, kDamping, turn)},
      kDuration);
}

// A bar falls across another, turning about its own axis: edges meet edges, and no vertex is near
// the crossing, each bar having three cells along its length.
Problem crossed_bars() {
  Problem problem = two_boxes();
  problem.name = "crossed bars";
  problem.bodies = {free_cube("lower", {0.0, 0.0, -0.0105}, {-0.2, -0.1, 0.3}, kDamping),
                    free_cube("upper", {0.004, -0.003, 0.0105}, {0.2, 0.1, -0.3}, kDamping,
                              Eigen::Quaterniond(Eigen::AngleAxisd(1.2, Vec3::UnitZ())))};
  for (ProblemBody& body : problem.bodies) {
    body.shape = MeshShape{reference::box_mesh(Vec3(0.12, 0.02, 0.02), {3, 1, 1})};
  }
  return problem;
}

// Friction that never worked proves nothing.
double above_zero(double friction_work) {
  return friction_work == 0.0 ? std::nan("") : std::max(0.0, friction_work);
}

// Two boxes lie on each other without load; a third strikes the upper one.
Problem struck_stack() {
  Problem problem = two_boxes();
  problem.name = "a stack struck by a box";
  const Eigen::Quaterniond turn = problem.bodies[1].rotation;
  problem.bodies = {free_cube("lower", {-0.011, 0.006, -0.1}, {-0.2, -0.1, 0.3}, kDamping),
                    free_cube("middle", {0.0, 0.0, 0.0}, {-0.2, -0.1, 0.3}, kDamping),
                    free_cube("striker", {0.021, -0.013, 0.127}, {0.4, 0.2, -0.6}, kDamping, turn)};
  return problem;
}

// What one step's contacts add, by the formula above.
struct Contacts {
  Vec3 moment = Vec3::Zero();  // kg m²/s
  double friction_work = 0.0;  // J: Δt f · slip, the displacement of a step being Δt v_{n+1}
  double cone = 0.0;           // largest |f|/fⁿ
};

Contacts contacts_of(const Engine& engine) {
  Contacts sum;
  const double dt = engine.time_step();
  for (const ContactSample& contact : engine.contacts()) {
    const Vec3 force = contact.normal_force * contact.normal + contact.friction_force;
    sum.moment += dt * contact.arm.cross(force);
    sum.friction_work += dt * contact.friction_force.dot(contact.slip);
    if (contact.normal_force > 0.0) {
      sum.cone = std::max(sum.cone, contact.friction_force.norm() / contact.normal_force);
    }
  }
  return sum;
}

struct Audit {
  double linear_error = 0.0;  // largest |P_n − P_0|, kg m/s
  bool symplectic_euler = false;
  double linear_scale = 0.0;   // Σ m|v| at the start, kg m/s
  double defect = 0.0;         // largest |L_{n+1} − L_n|, kg m²/s
  double formula_error = 0.0;  // largest difference of that from the formula, kg m²/s
  double drift = 0.0;          // |L_end − L_0|, kg m²/s
  double unexplained = 0.0;    // largest |L_n − L_0 − Σ formula|, kg m²/s
  double explained = 0.0;      // Σ_steps |formula|, kg m²/s
  double friction_work = 0.0;  // of all steps, J
  double most_given = 0.0;     // largest work that friction gave back in a step, J
  double contact_steps = 0.0;  // contacts summed over the steps
  double cone = 0.0;           // largest |f|/fⁿ of a contact in a step
};

Audit audit(CaseRun& run, const Problem& problem, const Settings& extra, bool keep_series) {
  const CaseRun::Running simulation = simulate_free(run, problem, extra);
  const Engine& engine = simulation->engine();
  Audit audit;
  audit.symplectic_euler = simulation->engine().symplectic_euler();
  audit.linear_scale = momentum_scale(problem);
  const Momenta start = engine.momenta();
  Series kinetic{"kinetic energy", "J", "time", "s", {}, {}};
  Series slip{"fastest contact slip", "m/s", "time", "s", {}, {}};
  Series lost{"angular momentum gained", "kg m²/s", "time", "s", {}, {}};
  Momenta before = start;
  Vec3 sum = Vec3::Zero();
  while (simulation->time() < problem.duration - 0.5 * engine.time_step()) {
    simulation->advance(1);
    const Momenta now = engine.momenta();
    const Contacts contacts = contacts_of(engine);
    const Vec3 defect = now.angular - before.angular;
    audit.linear_error = std::max(audit.linear_error, (now.linear - start.linear).norm());
    audit.defect = std::max(audit.defect, defect.norm());
    audit.formula_error = std::max(audit.formula_error, (defect - contacts.moment).norm());
    sum += contacts.moment;
    audit.unexplained = std::max(audit.unexplained, (now.angular - start.angular - sum).norm());
    audit.explained += contacts.moment.norm();
    audit.friction_work += contacts.friction_work;
    audit.most_given = std::max(audit.most_given, contacts.friction_work);
    audit.cone = std::max(audit.cone, contacts.cone);
    before = now;
    if (engine.steps_done() % 3 != 0) continue;
    for (Series* series : {&kinetic, &slip, &lost}) series->x.push_back(simulation->time());
    kinetic.y.push_back(engine.kinetic_energy());
    slip.y.push_back(fastest_slip(engine));
    lost.y.push_back((now.angular - start.angular).norm());
  }
  audit.drift = (before.angular - start.angular).norm();
  audit.contact_steps = static_cast<double>(engine.cost().contact_updates);
  if (keep_series) {
    run.add(std::move(kinetic));
    run.add(std::move(slip));
    run.add(std::move(lost));
  }
  return audit;
}

// Σ x × m v is of |x| ≤ 0.2 m, 1 m/s and 3 kg: 0.6 kg m²/s · 1.1e-16 a rounding, ten of them a
// term.
constexpr double kAngularRoundOff = 0.6 * 1.1e-16 * 10.0;  // kg m²/s

void note_audit(CaseRun& run, const Audit& found) {
  run.note(fmt::format(
      "friction work {:.3e} J; largest gift of a step {:.1e} J (contacts solved later in the sweep "
      "move those before). Angular momentum: largest defect of a step {:.2e}, over the run {:.2e} "
      "kg m²/s, formula met to {:.1e}. {:.0f} contact updates.",
      found.friction_work, found.most_given, found.defect, found.drift, found.formula_error,
      found.contact_steps));
}

void run_momentum(CaseRun& run, const Problem& problem) {
  const Audit found = audit(run, problem, {}, true);
  run.check({.quantity = "linear momentum, largest change",
             .unit = "kg m/s",
             .statement = "contact forces and their reactions cancel: linear momentum is conserved",
             .formula = "Σ m v(t) = Σ m v(0)",
             .source = "[Lazarevych2009], appendix A: ΣF = 0 after post-correction",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .relative = true,
             .scale = found.linear_scale,
             .tolerance = 1e-12,
             .reason = "round-off: 300 steps of some 100 vertices at 1e-16 of a vertex's momentum "
                       "give 1e-15, and three decades for the strong forces of the impact",
             .headline = "linear momentum, change"},
            found.linear_error);
  // The formulas are those of symplectic Euler.
  if (found.symplectic_euler && run.configuration().keeps_angular_momentum) {
    run.check({.quantity = "angular momentum, largest change in a step",
               .unit = "kg m²/s",
               .statement = "with tetrahedral weights the reaction acts where the force does",
               .formula = "r = xᵢ − Σ hⱼ xⱼ = 0 at the start of the step, so L_{n+1} = L_n",
               .source = "symplectic Euler, derived above",
               .kind = ReferenceKind::kAnalytic,
               .expected = 0.0,
               .tolerance = kAngularRoundOff,
               .reason = "round-off of Σ x × m v: 0.6 kg m²/s · 1.1e-16, ten roundings a term"},
              found.defect);
  } else if (found.symplectic_euler) {
    run.check(
        {.quantity = "angular momentum, defect of a step against the formula",
         .unit = "kg m²/s",
         .statement = "what a step adds to the angular momentum is what the contacts' arms say",
         .formula = "L_{n+1} − L_n = Δt Σ (xᵢ − Σ hⱼ xⱼ) × (fⁿ n + f), positions at t0",
         .source = "symplectic Euler, derived above",
         .kind = ReferenceKind::kAnalytic,
         .expected = 0.0,
         .tolerance = kAngularRoundOff,
         .reason = "round-off of Σ x × m v: 0.6 kg m²/s · 1.1e-16, ten roundings a term"},
        found.formula_error);
    run.check(
        {.quantity = "angular momentum, defect so far against the formula",
         .unit = "kg m²/s",
         .statement = "… and so at every time what it has gained",
         .formula = "L_n − L_0 = Σ_steps Δt Σ (xᵢ − Σ hⱼ xⱼ) × (fⁿ n + f), relative to Σ_steps |…|",
         .source = "symplectic Euler, derived above",
         .kind = ReferenceKind::kAnalytic,
         .expected = 0.0,
         .relative = true,
         .scale = found.explained > 0.0 ? found.explained : std::nan(""),
         .tolerance = 1e-9,
         .reason = "round-off of L, some 1e-15 kg m²/s, beside defects of 1e-5 … 1e-4"},
        found.unexplained);
  }
  run.check({.quantity = "friction work, if above 0",
             .unit = "J",
             .statement = "friction only takes energy",
             .formula = "Σ_steps Δt Σ_contacts f · u ≤ 0",
             .source = "Coulomb's law: f points against the slip",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-16,
             .reason = "an inequality; round-off of 1 J"},
            above_zero(found.friction_work));
  run.check(
      {.quantity = "largest friction over normal force",
       .unit = "1",
       .statement = "friction reaches Coulomb's cone, where contacts slip, and never leaves it",
       .formula = "max over steps and contacts of |f|/fⁿ = μ",
       .source = "Coulomb's law, [Lazarevych2009], (7), (8)",
       .kind = ReferenceKind::kAnalytic,
       .expected = problem.friction,
       .relative = true,
       .tolerance = 1e-12,
       .reason = "round-off of a vector clamped to μ fⁿ, of its norm and of the quotient, "
                 "some ten roundings, and three decades for light contacts"},
      found.cone);
  const std::optional<Settings> off = run.settings_without(Without::kPostCorrection);
  if (!off) return note_audit(run, found);
  const Audit bare = audit(run, problem, *off, false);
  run.check({.quantity = "the same without post-correction",
             .unit = "J",
             .statement = "… and that doesn't hang on the post-correction",
             .formula = "Σ_steps Δt Σ_contacts f · u ≤ 0",
             .source = "Coulomb's law: f points against the slip",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-16,
             .reason = "an inequality; round-off of 1 J"},
            above_zero(bare.friction_work));
  note_audit(run, found);
  run.note(fmt::format(
      "without post-correction: linear momentum off by {:.2g} of Σ m|v|, friction work {:.3e} J, "
      "largest gift of a step {:.1e} J",
      bare.linear_error / bare.linear_scale, bare.friction_work, bare.most_given));
}

Case audit_case(const char* name, const char* title, CaseSet set, Problem (*problem)()) {
  return {.name = name, .title = title, .set = set, .run = [problem](CaseRun& run) {
            run_momentum(run, problem());
          }};
}

}  // namespace

std::vector<Case> cases_momentum() {
  return {audit_case("paper/appendix-a-momentum/two-boxes",
                     "momenta in an oblique frictional collision of two free boxes",
                     CaseSet::kQuick, two_boxes),
          audit_case("paper/appendix-a-momentum/stack",
                     "momenta in a free stack of boxes that a third one strikes", CaseSet::kDefault,
                     struck_stack),
          audit_case("paper/appendix-a-momentum/crossed-bars",
                     "momenta when a bar falls across another: edges on edges", CaseSet::kDefault,
                     crossed_bars)};
}

}  // namespace stiction
