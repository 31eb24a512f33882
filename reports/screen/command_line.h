// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <sstream>
#include <string>

#include "reports/screen/program.h"
#include "reports/text/exit_code.h"

namespace stiction {

/// Refuses what is no finite number above 0, or from 0 on.
inline CLI::Validator finite_number(bool may_be_zero) {
  return {[may_be_zero](const std::string& text) {
            char* end = nullptr;
            const double value = std::strtod(text.c_str(), &end);
            const bool is_large_enough = may_be_zero ? value >= 0.0 : value > 0.0;
            if (is_large_enough && std::isfinite(value) && *end == '\0') return std::string();
            return fmt::format("must be a finite number {}, not '{}'",
                               may_be_zero ? "from 0 on" : "above 0", text);
          },
          ""};
}

/// Lets `parse` read the words of a program. A code ends it: --help was asked for and is printed,
/// or the words are refused and it is said why.
inline std::optional<int> ended_by(const CLI::App& app, const std::function<void()>& parse) {
  try {
    parse();
  } catch (const CLI::ParseError& error) {
    std::ostringstream shown, said;
    const bool fine = app.exit(error, shown, said) == 0;
    show(shown.str());
    if (fine) return kHolds;
    tell(error.what());
    tell("Run with --help for more information.");
    return kCouldNotRun;
  }
  return std::nullopt;
}

/// A whole program: reads its words, then runs `body` unless they end it (run_program, program.h).
inline int run_program(const CLI::App& app, const std::function<void()>& parse,
                       const ProgramBody& body) {
  return run_program(app.get_name(), [&] {
    const std::optional<int> code = ended_by(app, parse);
    return code ? *code : body();
  });
}

inline int run_program(CLI::App& app, int argc, char** argv, const ProgramBody& body) {
  return run_program(
      app, [&] { app.parse(argc, argv); }, body);
}

}  // namespace stiction
