// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/program.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <string_view>

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

TableStyle terminal_style() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string_view(value ? value : "");
  };
  TableStyle style;
  style.colour =
      isatty(STDOUT_FILENO) && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
  winsize size{};
  const long told = std::strtol(std::string(variable("COLUMNS")).c_str(), nullptr, 10);
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    style.width = size.ws_col;
  } else if (told > 0 && told < 10000) {
    style.width = static_cast<std::size_t>(told);
  }
  return style;
}

std::size_t terminal_height() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_row : 0;
}

std::string file_stem(const std::string& case_name, std::size_t index) {
  std::string stem = fmt::format("{:03}-{}", index, case_name.substr(0, 100));
  for (char& sign : stem) {
    if (!std::isalnum(static_cast<unsigned char>(sign)) && !std::strchr("-=.", sign)) sign = '_';
  }
  return stem;
}

}  // namespace stiction
