// SPDX-License-Identifier: GPL-3.0-or-later
// A ball or a box meets level ground at an angle. Rigid bodies are without restitution, and their
// motion afterwards is known. How far an elastic body rebounds, and what its surface does
// meanwhile, is its elasticity's affair: of it Coulomb's law alone is claimed, that friction's
// impulse is μ times the normal one while it slides.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "validation/core/case_run.h"
#include "validation/problems/thrown_problem.h"

namespace stiction {

namespace {

const char* const kImpactSource = "Coulomb's law and the balance of momenta in an impact";

struct Impact {
  double lost = 0.0;    // of v_t, m/s
  double aside = 0.0;   // velocity across v_t, m/s
  double normal = 0.0;  // P/m, m/s
  double spin = 0.0;    // about the axis of rolling, rad/s
  double twist = 0.0;   // spin about all else, rad/s
};

Impact impact_of(CaseRun& run, const ThrownSetup& setup) {
  const auto simulation = run.simulate(thrown_problem(setup), {.roundness = 160});
  simulation->record_frames(0.001);
  simulation->advance_to(setup.gap / setup.approach + 0.1);
  const BodyMotion after = simulation->engine().body(0);
  const Vec3 along = thrown_along(setup), across = Vec3::UnitZ().cross(along);
  Impact impact;
  impact.lost = setup.along - after.velocity.dot(along);
  impact.aside = after.velocity.dot(across);
  impact.normal = setup.approach + after.velocity.z();
  impact.spin = after.angular_velocity.dot(across);
  impact.twist = (after.angular_velocity - impact.spin * across).norm();
  run.note(fmt::format("v_n' = {:+.6g} m/s, v_t' = {:.6g} m/s, ω = {:.6g} 1/s", after.velocity.z(),
                       after.velocity.dot(along), impact.spin));
  return impact;
}

Claim claim_of(const std::string& quantity, const std::string& unit, const std::string& statement,
               const std::string& formula, double expected, double scale, double tolerance,
               const std::string& reason) {
  return {.quantity = quantity,
          .unit = unit,
          .statement = statement,
          .formula = formula,
          .source = kImpactSource,
          .kind = ReferenceKind::kAnalytic,
          .expected = expected,
          .relative = true,
          .scale = scale,
          .tolerance = tolerance,
          .reason = reason};
}

constexpr double kRoundOff = 1e-12;
const char* const kExact =
    "an impact is momentum alone, which has no truncation error; round-off of some thousand steps";

void run_sliding(CaseRun& run, const ThrownSetup& setup) {
  const Impact impact = impact_of(run, setup);
  const double mu = setup.friction;
  const bool elastic = run.engine().manifest.deformable;
  const double part = setup.approach / setup.along;
  const double tolerance = elastic ? 0.5 * part * part : kRoundOff;
  const std::string reason =
      elastic ? "an elastic surface moves at up to v_n beside the body's v_t, which turns friction "
                "at its points by φ = v_n/v_t to either side: ½φ²"
              : kExact;
  run.check(claim_of("friction's impulse over the normal one", "1",
                     "what slides throughout is braked by μ times the normal impulse",
                     "(v_t − v_t')/(v_n + v_n') = μ", mu, mu, tolerance, reason),
            impact.lost / impact.normal);
  run.check(claim_of("velocity to the side", "m/s", "friction is straight against the slip",
                     "v' · (n × t) = 0", 0.0, mu * setup.approach, tolerance, reason),
            impact.aside);
  if (elastic) return;
  run.check(claim_of("rebound", "m/s", "a rigid body without restitution does not rebound",
                     "v_n' = 0", 0.0, setup.approach, kRoundOff, kExact),
            impact.normal - setup.approach);
  const double rate = mu * setup.approach / setup.size;
  run.check(claim_of("spin", "1/s",
                     setup.ball ? "what brakes the ball turns it" : "a low box stays unturned",
                     setup.ball ? "ω = 5/2 (v_t − v_t')/r" : "ω = 0 where μ h < w",
                     setup.ball ? 2.5 * impact.lost / setup.size : 0.0, rate, kRoundOff, kExact),
            impact.spin);
  run.check(claim_of("spin about other axes", "1/s", "… and about no other axis",
                     "ω · t = ω · n = 0", 0.0, rate, kRoundOff, kExact),
            impact.twist);
}

void run_sticking(CaseRun& run, const ThrownSetup& setup) {
  if (run.engine().manifest.deformable) {
    throw NotApplicable("a rigid ball: an elastic one's surface springs back along the ground too");
  }
  const Impact impact = impact_of(run, setup);
  run.check(claim_of("speed afterwards", "m/s", "a ball whose impact sticks rolls on",
                     "v_t' = 5/7 v_t where v_t < 7/2 μ v_n", setup.along * 5.0 / 7.0,
                     setup.along * 5.0 / 7.0, kRoundOff, kExact),
            setup.along - impact.lost);
  const double spin = setup.along * 5.0 / 7.0 / setup.size;
  run.check(claim_of("spin", "1/s", "… without slip", "ω = v_t'/r", spin, spin, kRoundOff, kExact),
            impact.spin);
  run.check(claim_of("velocity to the side", "m/s", "friction is straight against the slip",
                     "v' · (n × t) = 0", 0.0, setup.along, kRoundOff, kExact),
            impact.aside);
}

}  // namespace

std::vector<Case> cases_impact_oblique() {
  ThrownSetup ball;
  ThrownSetup box;
  box.ball = false;
  ThrownSetup slow = ball;  // 7/2 μ v_n = 1.05 m/s
  slow.along = 0.7;
  return {{.name = "impact/oblique/ball/slides",
           .title = "a ball meets the ground at an angle and slides",
           .set = CaseSet::kDefault,
           .run = [=](CaseRun& run) { run_sliding(run, ball); }},
          {.name = "impact/oblique/ball/sticks",
           .title = "a ball meets the ground at an angle and rolls",
           .set = CaseSet::kDefault,
           .run = [=](CaseRun& run) { run_sticking(run, slow); }},
          {.name = "impact/oblique/box",
           .title = "a box meets the ground flat and sliding",
           .set = CaseSet::kDefault,
           .run = [=](CaseRun& run) { run_sliding(run, box); }}};
}

}  // namespace stiction
