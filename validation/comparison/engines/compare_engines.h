// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/text/exit_code.h"
#include "validation/engine/protocol/program_kind.h"
#include "validation/shards/portion.h"

namespace stiction {

struct EngineComparison {
  std::vector<std::string> engines{};    ///< names or commands; empty: all that are built
  std::vector<std::string> questions{};  ///< globs of their ids; empty: all
  bool quick = false;
  bool list = false;
  bool no_page = false;
  bool verbose = false;  ///< the matrix as well
  std::string out = "engine-report";
  bool json = false;  ///< with list: the jobs, for other drivers
  int jobs = 1;
  double cpu_limit = 20.0;  ///< for an answer, s
  ProgramLimits limits{};
  PortionWords portion{};
};

/// `./stiction compare engines`: asks every engine every question, prints the matrix, and writes
/// records and report. Throws InputError.
ExitCode compare_engines(const EngineComparison& asked);

}  // namespace stiction
