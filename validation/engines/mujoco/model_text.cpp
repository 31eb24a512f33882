// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/mujoco/model_text.h"

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <stdexcept>

namespace stiction_mujoco {

namespace {

std::string one_of(const char* name, const std::string& fallback,
                   std::initializer_list<const char*> words) {
  std::string value = stiction_text(name, fallback.c_str());
  if (std::find(words.begin(), words.end(), value) != words.end()) return value;
  std::string all;
  for (const char* word : words) all += std::string(all.empty() ? "" : ", ") + word;
  throw std::runtime_error("setting '" + std::string(name) + "' is one of " + all + ", not '" +
                           value + "'");
}

// All digits of a double.
std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string numbers(const double* values, std::size_t count) {
  std::string all;
  for (std::size_t k = 0; k < count; ++k) all += (k ? " " : "") + number(values[k]);
  return all;
}

// name="value", with a space before.
std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

std::string spaced(std::string list) {
  std::replace(list.begin(), list.end(), ',', ' ');
  return list;
}

std::string friction(double mu) {
  return attribute("condim", mu > 0.0 ? "3" : "1") + attribute("friction", number(mu) + " 0 0");
}

std::string options(const Parameters& p) {
  return "<option" + attribute("timestep", number(p.dt)) + attribute("integrator", p.integrator) +
         attribute("cone", p.cone) + attribute("solver", p.solver) +
         attribute("iterations", number(p.iterations)) +
         attribute("tolerance", number(p.tolerance)) +
         attribute("noslip_iterations", number(p.noslip_iterations)) +
         attribute("noslip_tolerance", number(p.noslip_tolerance)) +
         attribute("impratio", number(p.impratio)) + "/>\n";
}

std::string shape(const stiction_body& body) {
  if (body.shape == STICTION_BALL) {
    return attribute("type", "sphere") + attribute("size", number(body.radius));
  }
  const double half[3] = {0.5 * body.size[0], 0.5 * body.size[1], 0.5 * body.size[2]};
  return attribute("type", "box") + attribute("size", numbers(half, 3));
}

std::string free_body(const stiction_body& body, double mu) {
  if (body.shape == STICTION_POINT) stiction_lacks("points");
  if (body.shape == STICTION_MESH) stiction_lacks("bodies given as meshes");
  if (body.held) stiction_lacks("held parts of bodies");
  const double inertia[3] = {body.inertia[0][0], body.inertia[1][1], body.inertia[2][2]};
  return "<body" + attribute("pos", numbers(body.position, 3)) +
         attribute("quat", numbers(body.rotation, 4)) + "><freejoint/><inertial pos=\"0 0 0\"" +
         attribute("mass", number(body.mass)) + attribute("diaginertia", numbers(inertia, 3)) +
         "/><geom" + shape(body) + friction(mu) + "/></body>\n";
}

std::string plane(const stiction_obstacle& obstacle) {
  if (stiction_moves(&obstacle.motion)) stiction_lacks("moving obstacles");
  return "<geom type=\"plane\" size=\"1 1 1\" priority=\"1\"" +
         attribute("pos", numbers(obstacle.point, 3)) +
         attribute("zaxis", numbers(obstacle.normal, 3)) + friction(obstacle.friction) + "/>\n";
}

}  // namespace

Parameters read_parameters(const stiction_problem& problem) {
  Parameters p;
  if (problem.time > 0.0) p.dt = std::min(p.dt, problem.time);
  p.dt = stiction_number("dt", p.dt) / problem.finer;
  if (!(p.dt > 0.0)) stiction_refuse("setting 'dt' must be above 0");
  stiction_tell_number("dt", p.dt);
  p.integrator = one_of("integrator", p.integrator, {"Euler", "implicit"});
  p.cone = one_of("cone", p.cone, {"pyramidal", "elliptic"});
  p.solver = one_of("solver", p.solver, {"Newton", "CG", "PGS"});
  p.iterations = stiction_number("iterations", p.iterations);
  p.tolerance = stiction_number("tolerance", p.tolerance);
  p.noslip_iterations = stiction_number("noslip_iterations", p.noslip_iterations);
  p.noslip_tolerance = stiction_number("noslip_tolerance", p.noslip_tolerance);
  p.impratio = stiction_number("impratio", p.impratio);
  p.solref = stiction_text("solref", p.solref.c_str());
  p.solimp = stiction_text("solimp", p.solimp.c_str());
  stiction_tell_number("margin", 0.0);  // contacts begin where shapes touch
  return p;
}

std::string model_text(const stiction_problem& problem, const Parameters& parameters) {
  std::string text = "<mujoco><compiler inertiafromgeom=\"false\"/>\n" + options(parameters) +
                     "<default><geom" + attribute("solref", spaced(parameters.solref)) +
                     attribute("solimp", spaced(parameters.solimp)) + "/></default>\n<worldbody>\n";
  for (std::size_t o = 0; o < problem.obstacle_count; ++o) text += plane(problem.obstacles[o]);
  for (std::size_t b = 0; b < problem.body_count; ++b) {
    text += free_body(problem.bodies[b], problem.friction);
  }
  return text + "</worldbody></mujoco>\n";
}

}  // namespace stiction_mujoco
