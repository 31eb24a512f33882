// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/ode/parameters.h"

#include <algorithm>
#include <string>

namespace stiction::ode {

namespace {

int count(const char* name, int fallback) {
  const int value = static_cast<int>(stiction_number(name, fallback));
  if (value < 1) stiction_refuse((std::string(name) + " must be at least 1").c_str());
  return value;
}

double time_step(const stiction_problem& problem) {
  double usual = 0.01;
  if (problem.time > 0.0) usual = std::min(usual, problem.time);
  const double dt = stiction_number("dt", usual) / problem.finer;
  if (!(dt > 0.0)) stiction_refuse("dt must be above 0");
  stiction_tell_number("dt", dt);
  return dt;
}

bool exact_step() {
  const std::string step = stiction_text("step", "quick");
  if (step != "quick" && step != "exact") stiction_refuse("step must be 'quick' or 'exact'");
  return step == "exact";
}

FrictionDirection friction_direction() {
  const std::string direction = stiction_text("friction_direction", "engine");
  if (direction == "engine") return FrictionDirection::kEngine;
  if (direction == "slip") return FrictionDirection::kSlip;
  if (direction == "predicted") return FrictionDirection::kPredicted;
  stiction_refuse("friction_direction must be 'engine', 'slip' or 'predicted'");
}

}  // namespace

const stiction_setting kSettings[] = {
    {"dt", "time step, s (default 0.01)"},
    {"step", "quick (default): dWorldQuickStep; exact: dWorldStep, by Dantzig's algorithm"},
    {"iterations", "of the quick step (default 20)"},
    {"over_relaxation", "dWorldSetQuickStepW (default 1.3)"},
    {"erp", "dWorldSetERP: share of an error that a step takes back (default 0.2)"},
    {"cfm", "dWorldSetCFM: softness of all constraints, m/(N s) (default 1e-10)"},
    {"soft_cfm", "dContactSoftCFM: that of contact normals; below 0 (default): as cfm"},
    {"max_correcting_velocity", "dWorldSetContactMaxCorrectingVel, m/s (default 0: no bound)"},
    {"surface_layer", "dWorldSetContactSurfaceLayer, m (default 0)"},
    {"max_contacts", "of a pair, asked of dCollide (default 8)"},
    {"friction_direction",
     "dContactFDir1: engine (default: fixed axes), slip, or predicted (the slip at the step's end "
     "were there no contact)"},
    {"linear_damping", "dWorldSetLinearDamping, share a step (default 0)"},
    {"angular_damping", "dWorldSetAngularDamping, share a step (default 0)"},
    {"finite_rotation", "1: dBodySetFiniteRotationMode (default 0)"},
    {}};

Parameters read_parameters(const stiction_problem& problem) {
  return {.time_step = time_step(problem),
          .exact = exact_step(),
          .iterations = count("iterations", 20),
          .over_relaxation = stiction_number("over_relaxation", 1.3),
          .erp = stiction_number("erp", 0.2),
          .cfm = stiction_number("cfm", 1e-10),
          .soft_cfm = stiction_number("soft_cfm", -1.0),
          .max_correcting_velocity = stiction_number("max_correcting_velocity", 0.0),
          .surface_layer = stiction_number("surface_layer", 0.0),
          .max_contacts = count("max_contacts", 8),
          .friction_direction = friction_direction(),
          .linear_damping = stiction_number("linear_damping", 0.0),
          .angular_damping = stiction_number("angular_damping", 0.0),
          .finite_rotation = stiction_number("finite_rotation", 0.0) != 0.0};
}

}  // namespace stiction::ode
