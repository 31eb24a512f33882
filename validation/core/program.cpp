// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/program.h"

#include <fmt/format.h>

#include <cctype>
#include <cstring>

#include "solver/demand.h"

namespace stiction {

ExitCode exit_code(const std::vector<Record>& records) {
  ExitCode code = kHolds;
  for (const Record& record : records) {
    if (record.verdict == Verdict::kError) return kCouldNotRun;
    if (record.verdict == Verdict::kFail) code = kDoesNotHold;
  }
  return code;
}

Settings parse_settings(const std::vector<std::string>& words) {
  Settings settings;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw InputError("--set needs NAME=VALUE, not '" + word + "'");
    }
    settings[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return settings;
}

std::string file_stem(const std::string& case_name, std::size_t index) {
  std::string stem = fmt::format("{:03}-{}", index, case_name.substr(0, 100));
  for (char& sign : stem) {
    if (!std::isalnum(static_cast<unsigned char>(sign)) && !std::strchr("-=.", sign)) sign = '_';
  }
  return stem;
}

}  // namespace stiction
