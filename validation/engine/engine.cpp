// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/engine.h"

#include <algorithm>

#include "reference/process/child.h"
#include "reports/text/names.h"
#include "solver/demand.h"
#include "validation/engine/protocol/program_kind.h"

namespace stiction {

CalledConfiguration called_configuration(const EngineKind& kind, const std::string& case_name,
                                         const Settings& settings) {
  std::vector<Configuration> known;
  if (kind.configuration) {
    known = {kind.configuration(settings)};
  } else if (kind.configurations) {
    known = kind.configurations(case_name);
  }
  const Configuration* nearest = nullptr;
  for (const Configuration& one : known) {
    const bool among =
        std::includes(settings.begin(), settings.end(), one.settings.begin(), one.settings.end());
    if (one.name.empty() || !among) continue;
    if (nearest == nullptr || one.settings.size() > nearest->settings.size()) nearest = &one;
  }
  CalledConfiguration called{.name = nearest ? nearest->name : "default", .differs = settings};
  if (nearest == nullptr) return called;
  for (const auto& [name, value] : nearest->settings) called.differs.erase(name);
  return called;
}

std::string missing(const Manifest& manifest, const Problem& problem) {
  std::string words;
  const auto need = [&](bool needed, bool has, const char* what) {
    if (!needed || has) return;
    const std::string seen = ", " + words;
    if (seen.find(std::string(", ") + what) == std::string::npos) {
      words += (words.empty() ? "" : ", ") + std::string(what);
    }
  };
  for (const ProblemBody& body : problem.bodies) {
    const bool point = std::holds_alternative<PointShape>(body.shape);
    need(point, manifest.point_masses, "point masses");
    need(std::holds_alternative<BoxShape>(body.shape), manifest.boxes, "boxes");
    need(std::holds_alternative<BallShape>(body.shape), manifest.balls, "balls");
    if (const auto* const mesh = std::get_if<MeshShape>(&body.shape)) {
      need(true, manifest.meshes || (mesh->convex && manifest.convex_meshes),
           "bodies given as meshes");
    }
    need(!body.angular_velocity.isZero(0.0), manifest.spin, "bodies that turn");
    need(body.must_deform, manifest.deformable, "bodies that deform");
    need(body.held.has_value(), manifest.held_parts, "held parts");
    need(!body.motion.velocity.isZero(0.0), manifest.steady_motion, "steadily moving supports");
    need(body.motion.oscillation.moves(), manifest.oscillation, "sines over time");
    need(body.self_collision, manifest.self_contact, "a body's contact with itself");
  }
  need(problem.bodies.size() > 1, manifest.body_contact, "contact between bodies");
  for (const Obstacle& obstacle : problem.obstacles) {
    need(obstacle.motion.moves(), manifest.moving_obstacles, "moving obstacles");
    need(!obstacle.motion.velocity.isZero(0.0), manifest.steady_motion, "steadily moving supports");
    need(obstacle.motion.oscillation.moves(), manifest.oscillation, "sines over time");
  }
  for (const Load& load : problem.loads) {
    need(load.force.oscillation.moves() || load.couple.oscillation.moves(), manifest.oscillation,
         "sines over time");
  }
  need(problem.gravity.oscillation.moves(), manifest.oscillation, "sines over time");
  need(!problem.pair_friction.empty(), manifest.pair_friction, "friction of single pairs");
  need(problem.restitution > 0.0, manifest.restitution, "restitution");
  need(problem.drag.rate > 0.0, manifest.drag, "a medium that damps");
  need(!problem.loads.empty() || !problem.springs.empty(), manifest.loads, "loads on bodies");
  need(problem.gravity.time.size() > 1 || problem.gravity.oscillation.moves(),
       manifest.varying_gravity, "gravity that changes");
  return words;
}

EngineKind find_engine(const std::string& words) {
  const std::vector<EngineKind> all = engine_catalog();
  for (const EngineKind& kind : all) {
    if (kind.name == words) return kind;
  }
  const std::vector<std::string> program = program_words(words);
  // A lone word that is no program is rather a name mistyped.
  if (program.size() == 1 && program[0].find('/') == std::string::npos &&
      reference::find_program(program[0], reference::folders_of_path()).empty()) {
    throw InputError(
        "unknown engine '" + words + "'; there are: " +
        listed_names(all, [](const EngineKind& kind) { return kind.name; }) + "; programs: " +
        listed_names(engine_programs(), [](const EngineProgram& one) { return one.name; }) +
        "; or a command that speaks the protocol");
  }
  EngineKind found = program_kind(program, program_limits());
  // What names itself as one of the build's is not taken for that.
  for (const EngineKind& kind : all) {
    if (kind.name == found.name) {
      throw InputError("the engine '" + found.program + "' calls itself '" + kind.name +
                       "', which is an engine of this project: it needs another name");
    }
  }
  return found;
}

}  // namespace stiction
