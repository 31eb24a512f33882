// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "validation/engine/engine.h"
#include "validation/engine/protocol/dialogue.h"

namespace stiction {

/// What a program says of itself, and how to start it.
struct ProgramTraits {
  std::vector<std::string> words;  ///< the command
  ProgramLimits limits;
  Manifest manifest;
  bool tells_energies = false;  ///< else they are those of rigid bodies; momenta likewise
  bool tells_momenta = false;
  bool tells_surface = false;  ///< else a body's own shape is drawn
  bool symplectic_euler = false;
  Answers answers{};  ///< stands in for the program, in tests
};

/// The program, started.
std::unique_ptr<Dialogue> start(const ProgramTraits& traits);

/// An engine that is a program (protocol/README.md): a process for each simulation. Its functions
/// throw InputError, one sentence, for whatever the program does but answer.
std::unique_ptr<Engine> make_program_engine(const ProgramTraits& traits, const Settings& settings);

}  // namespace stiction
