// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/fingerprint.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {

Machine machine_of(const Environment& environment) {
  Machine machine;
  const std::size_t comma = environment.machine.rfind(", ");
  machine.processor = environment.machine.substr(0, comma);
  if (comma != std::string::npos) {
    machine.cores = std::atoll(environment.machine.c_str() + comma + 2);
  }
  const std::size_t behind = environment.toolchain.find(", ");
  machine.compiler = environment.toolchain.substr(0, behind);
  if (behind != std::string::npos) machine.flags = environment.toolchain.substr(behind + 2);
  return machine;
}

std::optional<Machine> told_machine(const Tree& tree) {
  const Ended ended = run({tree.program("bench").string(), "--machine"});
  if (ended.code != 0) return std::nullopt;
  try {
    const auto told = nlohmann::json::parse(last_line(ended.output));
    Environment environment;
    told.at("machine").get_to(environment.machine);
    told.at("toolchain").get_to(environment.toolchain);
    return machine_of(environment);
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace stiction::track
