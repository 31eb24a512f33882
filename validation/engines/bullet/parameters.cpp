// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/bullet/parameters.h"

#include <algorithm>

namespace stiction::bullet {

namespace {

bool flag(const char* name, bool fallback) { return stiction_number(name, fallback) != 0.0; }

int count(const char* name, int fallback) {
  return static_cast<int>(stiction_number(name, fallback));
}

double time_step(const stiction_problem& problem) {
  double usual = 1.0 / 60.0;
  if (problem.time > 0.0) usual = std::min(usual, problem.time);
  const double dt = stiction_number("dt", usual) / problem.finer;
  if (!(dt > 0.0)) stiction_refuse("dt must be above 0");
  stiction_tell_number("dt", dt);
  return dt;
}

}  // namespace

const stiction_setting kSettings[] = {
    {"dt", "time step, s (default 1/60)"},
    {"iterations", "of the solver, per step (default 10)"},
    {"solver",
     "sequential_impulse (default), nncg, dantzig or projected_gauss_seidel: Bullet's classes"},
    {"erp", "m_erp2: share of a contact's penetration that a step takes back (default 0.2)"},
    {"friction_erp", "m_frictionERP: the same of a slipped friction anchor (default 0.2)"},
    {"cfm", "m_globalCfm: softness of all contacts, 1/kg s (default 0)"},
    {"split_threshold",
     "m_splitImpulsePenetrationThreshold, m, not above 0: deeper penetrations are corrected apart "
     "from velocities (default -0.04)"},
    {"warm_start", "m_warmstartingFactor: share of the last impulses to begin with (default 0.85)"},
    {"friction_directions", "1 (default) or 2: SOLVER_USE_2_FRICTION_DIRECTIONS, a pyramid"},
    {"directions_along_slip",
     "1 (default): the first friction direction is that of the slip; 0: "
     "SOLVER_DISABLE_VELOCITY_DEPENDENT_FRICTION_DIRECTION"},
    {"random_order", "1: SOLVER_RANDMIZE_ORDER (default 0)"},
    {"friction_anchors",
     "1: CF_HAS_FRICTION_ANCHOR, contacts remember where they stuck (default 0)"},
    {"interleaved", "1: SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS (default 0)"},
    {"ground", "half-spaces are each a box (default) or a plane (btStaticPlaneShape)"},
    {"ground_size", "edge of such a box, m (default 100)"},
    {"plane_points",
     "with ground=plane: setPlaneConvexMultipointIterations; 0 (default): one new contact a step"},
    {"contact_breaking", "gContactBreakingThreshold, m (default 0.02)"},
    {"hull_margin",
     "around convex meshes, m (default 0; Bullet's own is 0.04); boxes and balls have the size "
     "given"},
    {}};

Parameters read_parameters(const stiction_problem& problem) {
  Parameters p{.time_step = time_step(problem),
               .iterations = count("iterations", 10),
               .solver = stiction_text("solver", "sequential_impulse"),
               .erp = stiction_number("erp", 0.2),
               .friction_erp = stiction_number("friction_erp", 0.2),
               .cfm = stiction_number("cfm", 0.0),
               .split_threshold = stiction_number("split_threshold", -0.04),
               .warm_start = stiction_number("warm_start", 0.85),
               .friction_directions = count("friction_directions", 1),
               .directions_along_slip = flag("directions_along_slip", true),
               .random_order = flag("random_order", false),
               .friction_anchors = flag("friction_anchors", false),
               .interleaved = flag("interleaved", false),
               .ground_is_box = true,
               .ground_size = stiction_number("ground_size", 100.0),
               .plane_points = count("plane_points", 0),
               .contact_breaking = stiction_number("contact_breaking", 0.02),
               .hull_margin = stiction_number("hull_margin", 0.0)};
  const std::string ground = stiction_text("ground", "box");
  if (ground != "plane" && ground != "box") stiction_refuse("ground must be 'plane' or 'box'");
  p.ground_is_box = ground == "box";
  if (p.iterations < 1) stiction_refuse("iterations must be at least 1");
  if (p.friction_directions != 1 && p.friction_directions != 2) {
    stiction_refuse("friction_directions must be 1 or 2");
  }
  return p;
}

}  // namespace stiction::bullet
