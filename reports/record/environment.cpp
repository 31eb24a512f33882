// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/environment.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <thread>

#include "revision.h"

namespace stiction {

namespace {

std::string processor() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

}  // namespace

Environment current_environment() {
  static const std::string machine =
      fmt::format("{}, {} cores", processor(), std::thread::hardware_concurrency());
  static const std::string host = host_name();
  Environment environment;
  environment.revision = kRevision;
  environment.toolchain = fmt::format("GCC {}, {}", __VERSION__, kBuildFlags);
  environment.machine = machine;
  environment.host = host;
  environment.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  return environment;
}

}  // namespace stiction
