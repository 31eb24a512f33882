// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "validation/engine/engine.h"
#include "validation/stability/perturbation.h"

namespace stiction {

/// What a perturbed engine leaves behind, one entry a simulation, in the frame of the problem as it
/// was given.
struct PerturbedTrace {
  struct End {
    std::vector<BodyMotion> bodies{};
    std::vector<double> sizes{};  ///< longest edge of each body, m; of a point 0
    double length = 1.0;          ///< of the scene, m
    double speed = 1.0;  ///< of the fastest body at the start, or of a fall over that length, m/s
    std::uint64_t steps = 0;
  };
  std::vector<End> ends{};
  std::uint64_t rewound = 0;  ///< steps that were taken twice
  std::uint64_t unlike = 0;   ///< of them, those of which the second differs from the first
};

/// An engine that simulates each problem perturbed and tells what it sees of it unperturbed: nobody
/// outside can tell but by digits. The settings with which it is made may name the perturbation
/// under kPerturbedSetting; its expectations are gone. `trace` may be null. Throws NotApplicable
/// where the engine lacks what it takes.
EngineKind perturbed(const EngineKind& kind, const Perturbation& how,
                     std::shared_ptr<PerturbedTrace> trace = nullptr);

}  // namespace stiction
