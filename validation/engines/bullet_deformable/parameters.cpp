// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/bullet_deformable/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace stiction::bullet_deformable {

namespace {

bool flag(const char* name, bool fallback) { return stiction_number(name, fallback) != 0.0; }

int count(const char* name, int fallback) {
  const int value = static_cast<int>(stiction_number(name, fallback));
  if (value < 1) stiction_refuse((std::string(name) + " must be at least 1").c_str());
  return value;
}

double shortest_edge(const stiction_body& body, const Parameters& p) {
  if (body.shape == STICTION_BOX) {
    return *std::max_element(body.size, body.size + 3) / p.cells;
  }
  if (body.shape == STICTION_BALL) return body.radius / p.ball_cells;
  double least = std::numeric_limits<double>::infinity();
  for (size_t e = 0; e < body.tetrahedron_count; ++e) {
    for (int k = 0; k < 3; ++k) {
      const double* a = body.vertices[body.tetrahedra[e][k]];
      const double* b = body.vertices[body.tetrahedra[e][k + 1]];
      least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  return least;
}

double volume(const stiction_body& body) {
  if (body.shape == STICTION_BOX) return body.size[0] * body.size[1] * body.size[2];
  if (body.shape == STICTION_BALL) return 4.19 * std::pow(body.radius, 3);
  double low[3], high[3];
  for (int i = 0; i < 3; ++i) low[i] = high[i] = body.vertices[0][i];
  for (size_t k = 0; k < body.vertex_count; ++k) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], body.vertices[k][i]);
      high[i] = std::max(high[i], body.vertices[k][i]);
    }
  }
  return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
}

// A fifth of the time in which sound crosses the shortest edge.
double stable_time_step(const stiction_problem& problem, const Parameters& p) {
  double least = 1.0 / 240.0;
  for (size_t b = 0; b < problem.body_count; ++b) {
    const stiction_body& body = problem.bodies[b];
    const double nu = body.poisson_ratio;
    const double modulus = body.youngs_modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
    const double sound = std::sqrt(modulus * volume(body) / body.mass);
    least = std::min(least, 0.2 * shortest_edge(body, p) / sound);
  }
  return least;
}

}  // namespace

const stiction_setting kSettings[] = {
    {"dt", "time step, s (default 1/240; explicit: at most a fifth of sound's time over an edge)"},
    {"implicit", "1 (default): elasticity by Newton's method; 0: explicit, but for damping"},
    {"line_search", "1: of Newton's method (default 0)"},
    {"projection",
     "setUseProjection: 1 (default) by projected conjugate gradients, 0 by multipliers"},
    {"material", "linear (default): btDeformableLinearElasticityForce; neo_hookean"},
    {"iterations", "of the contacts, per step (default 100)"},
    {"residual", "m_leastSquaresResidualThreshold, m²/s² (default 0.001)"},
    {"erp", "m_deformable_erp: share of a penetration that a step takes back (default 0.3)"},
    {"max_correction", "m_deformable_maxErrorReduction, m/s (default 200)"},
    {"mass_damping", "α of damping forces −α m v, 1/s (default 0; its demos have 0.01 to 0.1)"},
    {"margin",
     "around bodies, m (default 0.0001); half-spaces stand so much lower, bodies stay two apart"},
    {"ground_size", "edge of the box that stands for a half-space, m (default 20)"},
    {"voxel", "of the distance field about it, m (default 0.25)"},
    {"cells", "along a box's longest edge (default: what the case asks for, else 2)"},
    {"ball_cells", "along the diameter of a ball (default: what the case asks for, else 4)"},
    {}};

Parameters read_parameters(const stiction_problem& problem) {
  Parameters p{};
  p.implicit = flag("implicit", true);
  p.line_search = flag("line_search", false);
  p.projection = flag("projection", true);
  const std::string material = stiction_text("material", "linear");
  if (material != "linear" && material != "neo_hookean") {
    stiction_refuse("material must be 'linear' or 'neo_hookean'");
  }
  p.neo_hookean = material == "neo_hookean";
  p.iterations = count("iterations", 100);
  p.residual = stiction_number("residual", 1e-3);
  p.erp = stiction_number("erp", 0.3);
  p.max_correction = stiction_number("max_correction", 200.0);
  p.mass_damping = stiction_number("mass_damping", 0.0);
  p.margin = stiction_number("margin", 1e-4);
  p.ground_size = stiction_number("ground_size", 20.0);
  p.voxel = stiction_number("voxel", 0.25);
  p.cells = count("cells", problem.fineness > 0 ? problem.fineness : 2);
  int ball = 4;  // 6 n² + 2 nodes on the surface
  if (problem.roundness > 0) ball = static_cast<int>(std::ceil(std::sqrt(problem.roundness / 6.0)));
  p.ball_cells = count("ball_cells", ball + ball % 2);
  double usual = p.implicit ? 1.0 / 240.0 : stable_time_step(problem, p);
  if (problem.time > 0.0) usual = std::min(usual, problem.time);
  p.time_step = stiction_number("dt", usual) / problem.finer;
  if (!(p.time_step > 0.0)) stiction_refuse("dt must be above 0");
  stiction_tell_number("dt", p.time_step);
  return p;
}

}  // namespace stiction::bullet_deformable
