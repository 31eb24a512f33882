// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "validation/engine/engine.h"
#include "validation/stability/reference_frame.h"

namespace stiction {

/// Something that must not change what is measured, done to a whole scene and its engine. It knows
/// no case, and cases know nothing of it.
struct Perturbation {
  std::string name{};   ///< as on the command line: "turned/1"
  std::string group{};  ///< a row of a table of digits: "turned"
  std::string words;    ///< "turned by 40° about (1, 2, 3)"
  ReferenceFrame frame{};
  bool meshed = false;                      ///< boxes and balls are given as meshes
  std::optional<std::uint64_t> bodies{};    ///< bodies and obstacles in another order, of a seed
  std::optional<std::uint64_t> vertices{};  ///< vertices and tetrahedra of meshes likewise
  std::optional<std::uint64_t> ulp{};       ///< each number a unit in the last place off, or not
  std::string rounding = "nearest";         ///< of the engine's arithmetic (kit/rounding.h)
  bool rewinds = false;                     ///< each step is taken, taken back and taken again
  std::string build{};                      ///< another build of the engine (EngineKind::builds)
};

/// What is claimed of the digits that survive the perturbations of a group.
struct PerturbationGroup {
  std::string name;
  std::string against{};  ///< the perturbation that they are held against; empty: the case as it is
  double tolerance;       ///< of σ/scale
  double at_rest;         ///< … of a case at the end of which nothing moves
  std::string reason;
  std::string statement;
};

/// All there are, group after group.
const std::vector<Perturbation>& perturbations();
const std::vector<PerturbationGroup>& perturbation_groups();

/// By name, or InputError that lists them.
const Perturbation& find_perturbation(const std::string& name);

/// Which body and obstacle of the problem stands where in the perturbed one.
struct Order {
  std::vector<std::size_t> bodies{};     ///< place there of each here
  std::vector<std::size_t> obstacles{};  ///< likewise
};

struct PerturbedProblem {
  Problem problem;
  Order order;
};

/// The problem as the engine gets it. Where it is asked for, boxes and balls become meshes, of
/// `fineness` cells along the longest edge. Throws NotApplicable where the scene has nothing to
/// perturb.
PerturbedProblem perturbed(const Problem& problem, const Perturbation& how, int fineness);

}  // namespace stiction
