// SPDX-License-Identifier: BSD-3-Clause
// Requests to an engine's program: each line has an answer of one line, whatever it is. The engine
// behind reads all of its problem.
#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "fuzz/property.h"
#include "validation/engine/kit/session.h"

namespace {

// Free points: all that it is told, and nothing that can diverge in words of its own.
struct Points {
  const stiction_problem* problem;
  std::uint64_t steps;
};

void* load(const stiction_problem* problem) {
  if (problem->body_count == 0) stiction_lacks("bodies");
  double sum = stiction_number("dt", 0.01) + problem->friction + problem->drag_rate;
  for (std::size_t k = 0; k < problem->body_count; ++k) {
    const stiction_body& body = problem->bodies[k];
    for (std::size_t v = 0; v < body.vertex_count; ++v) sum += body.vertices[v][2];
    for (std::size_t e = 0; e < body.tetrahedron_count; ++e) {
      for (int i = 0; i < 4; ++i) sum += body.vertices[body.tetrahedra[e][i]][0];
    }
    sum += static_cast<double>(std::string(body.name).size());
  }
  for (std::size_t k = 0; k < problem->obstacle_count; ++k) sum += problem->obstacles[k].normal[2];
  stiction_tell_number("sum", sum);
  return new Points{problem, 0};
}

double time_step(void*) { return 0.01; }
void advance(void* self, std::uint64_t steps) { static_cast<Points*>(self)->steps += steps; }

void body(void* self, std::size_t index, stiction_body_state* state) {
  const Points& points = *static_cast<Points*>(self);
  const double time = 0.01 * static_cast<double>(points.steps);
  double gravity[3], force[3], couple[3];
  stiction_at(&points.problem->gravity, time, gravity);
  stiction_load(points.problem, index, time, points.problem->bodies[index].position, force, couple);
  const double drag = stiction_drag(points.problem, time);
  for (int i = 0; i < 3; ++i) state->position[i] = gravity[i] + force[i] + drag * couple[i];
}

void* save(void* self) { return new Points(*static_cast<Points*>(self)); }
void restore(void* self, const void* saved) {
  *static_cast<Points*>(self) = *static_cast<const Points*>(saved);
}
void forget(void*, void* saved) { delete static_cast<Points*>(saved); }
void end(void* self) { delete static_cast<Points*>(self); }

stiction_engine engine() {
  static const stiction_setting settings[] = {{"dt", "time step, s"}, {nullptr, nullptr}};
  stiction_engine one{};
  one.name = "points";
  one.can = "points";
  one.settings = settings;
  one.load = load;
  one.time_step = time_step;
  one.advance = advance;
  one.body = body;
  one.save = save;
  one.restore = restore;
  one.forget = forget;
  one.end = end;
  return one;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream lines(std::string(data, data + size));
  const stiction_engine points = engine();
  stiction::kit::Session session(points);
  for (std::string line; !session.over() && std::getline(lines, line);) {
    const std::string reply = session.reply(line);
    stiction::fuzz::hold(reply.find('\n') == std::string::npos, "an answer is one line");
    stiction::fuzz::hold(nlohmann::json::parse(reply).is_object(), "an answer is an object");
  }
  return 0;
}
