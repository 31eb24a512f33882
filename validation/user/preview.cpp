// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/preview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/screen/screen.h"
#include "reports/text/text.h"
#include "validation/user/user_run.h"

namespace stiction {

namespace {

using Eigen::Vector3d;

std::string text(const Vector3d& v) {
  // −0 is 0 to a reader.
  const Vector3d told = v.unaryExpr([](double x) { return x == 0.0 ? 0.0 : x; });
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", told.x(), told.y(), told.z());
}

struct ShapeText {
  std::string operator()(const BoxShape& box) const {
    return fmt::format("a box of {:g} × {:g} × {:g} m", box.size.x(), box.size.y(), box.size.z());
  }
  std::string operator()(const BallShape& ball) const {
    return fmt::format("a ball of {:g} m radius", ball.radius);
  }
  std::string operator()(const PointShape&) const { return "a point"; }
  std::string operator()(const MeshShape& shape) const {
    const Vector3d size =
        shape.mesh.vertices.rowwise().maxCoeff() - shape.mesh.vertices.rowwise().minCoeff();
    return fmt::format("{} tetrahedra that span {:.3g} × {:.3g} × {:.3g} m",
                       shape.mesh.tetrahedra.cols(), size.x(), size.y(), size.z());
  }
};

std::string over_time_text(bool moves, const Oscillation& swings, const char* how) {
  std::string words = moves ? how : "";
  if (swings.moves()) {
    words += fmt::format("{}swings by {} at {:g} Hz", words.empty() ? "" : ", ",
                         text(swings.amplitude), swings.frequency);
  }
  return words;
}

std::string motion_text(const Motion& motion) {
  const std::string words = over_time_text(!motion.time.empty() || !motion.velocity.isZero(0.0),
                                           motion.oscillation, "moves");
  return words.empty() ? "" : "; " + words;
}

std::string standing(const UserProblem& user, std::size_t body) {
  const UserSupport& support = user.supports[body];
  if (support.body) return "on '" + user.problem.bodies[*support.body].name + "', ";
  if (support.obstacle) return "on '" + user.problem.obstacles[*support.obstacle].name + "', ";
  return "";
}

std::string body_text(const UserProblem& user, std::size_t number) {
  const ProblemBody& body = user.problem.bodies[number];
  std::string words =
      fmt::format("body '{}': {}, {:g} kg, E = {:g} Pa; {}centre at {} m", body.name,
                  std::visit(ShapeText{}, body.shape), body.mass, body.elasticity.youngs_modulus,
                  standing(user, number), text(body.position));
  if (!body.velocity.isZero(0.0)) words += ", velocity " + text(body.velocity) + " m/s";
  if (!body.angular_velocity.isZero(0.0)) {
    words += ", spin " + text(body.angular_velocity) + " rad/s";
  }
  if (body.held) words += "; a part is held";
  if (body.self_collision) words += "; it may touch itself";
  return words + motion_text(body.motion);
}

std::string obstacle_text(const UserProblem& user, std::size_t number) {
  const Obstacle& obstacle = user.problem.obstacles[number];
  const double cosine = std::clamp(obstacle.normal.z(), -1.0, 1.0);
  const double slope = std::acos(cosine) * 180.0 / std::numbers::pi;
  const std::string down =
      slope > 0.0 ? ", downhill along " + text(user.downhill[number]) : std::string();
  return fmt::format("obstacle '{}': a half-space through {} m, {:.4g}° steep{}, μ = {:g}",
                     obstacle.name, text(obstacle.point), slope, down, obstacle.friction) +
         motion_text(obstacle.motion);
}

std::string gravity_text(const Gravity& gravity) {
  std::string words = "gravity ";
  for (std::size_t k = 0; k < gravity.time.size(); ++k) {
    words += fmt::format("{}{}", k == 0 ? "" : " → ", text(gravity.acceleration[k]));
  }
  words += " m/s²";
  if (gravity.time.size() > 1) {
    words += fmt::format(" from {:g} s to {:g} s", gravity.time.front(), gravity.time.back());
  }
  const std::string swings = over_time_text(false, gravity.oscillation, "");
  return words + (swings.empty() ? "" : ", " + swings);
}

std::string check_text(const UserProblem& user, const UserCheck& one) {
  const Observable& observable = *one.watch.observable;
  std::string words = "check '" + one_line(one.claim.quantity) + "': " + extreme_word(one.extreme) +
                      observable.name;
  if (observable.subject != Subject::kScene) {
    words += " of '" + user.problem.bodies[one.watch.body].name + "'";
  }
  words += partner_words(one.watch, user.problem);
  if (observable.in_direction) words += " along " + text(one.watch.direction);
  words += one.over_window() ? fmt::format(" from {:g} s to {:g} s", one.from, one.at)
                             : fmt::format(" at {:g} s", one.at);
  words += fmt::format(" is {:g} {} within {:g}{}: ", one.claim.expected, one.claim.unit,
                       one.claim.tolerance, one.claim.relative ? " of it" : "");
  return words + one_line(one.claim.reason);
}

std::string load_text(const UserProblem& user, const Load& load) {
  std::string words = "load on '" + user.problem.bodies[load.body].name + "':";
  const auto add = [&](const VectorOverTime& one, const char* what, const char* unit) {
    if (one.time.empty() && !one.oscillation.moves()) return;
    const Vector3d last = one.value.empty() ? Vector3d(Vector3d::Zero()) : one.value.back();
    const std::string swings = over_time_text(false, one.oscillation, "");
    words += fmt::format(" {} {}{} {}{}{}", what, one.time.size() > 1 ? "up to " : "", text(last),
                         unit, swings.empty() ? "" : ", ", swings);
  };
  add(load.force, "force", "N");
  add(load.couple, "couple", "N m");
  return words;
}

std::string variation_text(const UserProblem& user) {
  if (user.sweep) {
    return fmt::format("sweep: {} = {:g}", user.sweep->vary.what,
                       fmt::join(user.sweep->values, ", "));
  }
  const UserThreshold& one = *user.threshold;
  return fmt::format("threshold of {}: holds at {:g}, fails at {:g}, to {:g}; is {:g} within {:g}",
                     one.vary.what, one.holds_at, one.fails_at, one.within, one.claim.expected,
                     one.claim.tolerance);
}

}  // namespace

std::string time_text(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.2g} s", std::max(seconds, 0.01));
  if (seconds < 6000.0) return fmt::format("{:.0f} min", seconds / 60.0);
  if (seconds < 360000.0) return fmt::format("{:.0f} h", seconds / 3600.0);
  return fmt::format("{:.3g} days", seconds / 86400.0);
}

UserEstimate estimate(const UserProblem& user, const EngineKind& kind, const Settings& settings,
                      double finer) {
  constexpr double kTried = 0.1;  // s of CPU
  const std::string lacking = missing(kind.manifest, user.problem);
  if (!lacking.empty()) throw NotApplicable("the engine has no " + lacking);
  const std::unique_ptr<Engine> engine = kind.make(settings);
  engine->load(user.problem, {.finer = finer});
  UserEstimate out;
  out.time_step = engine->time_step();
  out.steps = steps_of(user, out.time_step);
  out.simulations = simulations_of(user);
  for (const Mesh& mesh : engine->meshes()) out.tetrahedra += mesh.tetrahedra;
  for (std::uint64_t next = 1; engine->steps_done() < out.steps; next *= 2) {
    engine->advance(std::min(next, out.steps - engine->steps_done()));
    if (engine->cpu_seconds() > kTried) break;
  }
  out.cpu_seconds = engine->cpu_seconds() / static_cast<double>(engine->steps_done()) *
                    static_cast<double>(out.steps) * out.simulations;
  return out;
}

std::string estimate_text(const UserEstimate& one) {
  const std::string times =
      one.simulations > 1 ? fmt::format("{} simulations of ", one.simulations) : std::string();
  return fmt::format("{}{} steps of {:g} ms, {} tetrahedra: about {} of CPU time", times, one.steps,
                     1e3 * one.time_step, one.tetrahedra, time_text(one.cpu_seconds));
}

std::string explained(const UserProblem& user, std::size_t width) {
  const Problem& problem = user.problem;
  std::vector<std::string> lines;
  lines.push_back(fmt::format("{:g} s; {}", problem.duration, gravity_text(problem.gravity)));
  if (problem.drag.rate > 0.0) {
    lines.push_back(
        fmt::format("a medium damps by {:g}/s, fades from {:g} s on, and is gone at "
                    "{:g} s",
                    problem.drag.rate, problem.drag.full_until, problem.drag.ends));
  }
  for (std::size_t k = 0; k < problem.obstacles.size(); ++k)
    lines.push_back(obstacle_text(user, k));
  for (std::size_t k = 0; k < problem.bodies.size(); ++k) lines.push_back(body_text(user, k));
  if (problem.bodies.size() > 1) {
    lines.push_back(fmt::format("between bodies μ = {:g}", problem.friction));
  }
  for (const PairFriction& pair : problem.pair_friction) {
    lines.push_back(fmt::format(
        "between '{}' and '{}' μ = {:g}", problem.bodies[pair.body].name,
        pair.against_body ? problem.bodies[pair.other].name : problem.obstacles[pair.other].name,
        pair.friction));
  }
  if (problem.restitution > 0.0) {
    lines.push_back(
        fmt::format("every contact gives back {:g} of the normal speed", problem.restitution));
  }
  for (const Load& load : problem.loads) lines.push_back(load_text(user, load));
  for (const Spring& spring : problem.springs) {
    lines.push_back(fmt::format("spring on '{}': {:g} N/m along {} to {} m",
                                problem.bodies[spring.body].name, spring.stiffness,
                                text(spring.axis), text(spring.anchor)));
  }
  for (const UserCheck& one : user.checks) lines.push_back(check_text(user, one));
  if (user.sweep || user.threshold) lines.push_back(variation_text(user));
  std::string out;
  for (const std::string& line : lines) out += bullet(line, width);
  return out;
}

}  // namespace stiction
