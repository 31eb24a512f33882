// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/engine/kit/stiction_engine.h"

namespace stiction_mujoco {

/// Native parameters, as MuJoCo's XML names them; in-class defaults are those of its XML.
struct Parameters {
  double dt = 0.002;                 ///< s
  std::string integrator = "Euler";  ///< or implicit
  std::string cone = "pyramidal";    ///< or elliptic
  std::string solver = "Newton";     ///< or CG, PGS
  double iterations = 100.0;         ///< at most, of the solver
  double tolerance = 1e-8;           ///< dimensionless
  double noslip_iterations = 0.0;    ///< at most
  double noslip_tolerance = 1e-6;    ///< dimensionless
  double impratio = 1.0;             ///< frictional over normal impedance
  std::string solref = "0.02,1";  ///< time constant (s), damping ratio; or −stiffness, −damping
  std::string solimp = "0.9,0.95,0.001,0.5,2";
};

/// Reads the settings of this run, and so tells them. Throws on what cannot be.
Parameters read_parameters(const stiction_problem& problem);

/// The model as MJCF: a free body for each body, a plane of the world for each obstacle, in order.
/// Calls stiction_lacks where MuJoCo cannot have the problem.
///
/// Of two geoms that touch, MuJoCo takes the parameters of the one of higher priority, and of equal
/// ones the greater μ. So planes, of priority 1, give each pair with a body the obstacle's μ, and
/// bodies, of priority 0, all have that between bodies. A μ of 0 is a contact without friction
/// (condim 1), because MuJoCo raises μ to 1e-5.
std::string model_text(const stiction_problem& problem, const Parameters& parameters);

}  // namespace stiction_mujoco
