// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/configuration_text.h"

#include <cstring>

#include "reports/text/check_text.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

// As a word of a shell.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char sign : one_line(text)) {
    word += sign == '\'' ? std::string("'\\''") : std::string(1, sign);
  }
  return word + "'";
}

// A case's name is a pattern: what has a meaning in one stands for any sign.
std::string pattern(std::string name) {
  for (char& sign : name) {
    if (std::strchr("[]*?\\", sign) != nullptr) sign = '?';
  }
  return name;
}

}  // namespace

std::string configuration_name(const Record& record) {
  if (!record.configuration.empty()) return one_line(record.configuration);
  const std::string settings = settings_text(record.settings);
  return settings.empty() ? "default" : settings;
}

std::string configuration_text(const Record& record) {
  const std::string more = record.configuration.empty() ? "" : settings_text(record.differs);
  return configuration_name(record) + (more.empty() ? "" : ", " + more);
}

std::string rerun_command(const Record& record, const std::vector<std::string>& problems,
                          const std::string& engine) {
  std::string command = "./stiction validate";
  for (const std::string& file : problems) command += " " + quoted(file);
  // The record does not tell the file of a user's own problem.
  if (problems.empty() && record.case_name.starts_with("user/")) command += " PROBLEM.toml";
  command += " --case " + quoted(pattern(record.case_name));
  const std::string& words = engine.empty() ? record.engine : engine;
  if (words != "stiction") command += " --engine " + quoted(words);
  if (!record.configuration.empty()) {
    command += " --configuration " + quoted(record.configuration);
  }
  for (const auto& [name, value] : record.differs) {
    // These are no settings of the engine.
    command += name == kPerturbedSetting ? " --perturb " + quoted(value)
               : name == kFinerSetting   ? " --finer " + quoted(value)
                                         : " --set " + quoted(name + "=" + value);
  }
  return command;
}

}  // namespace stiction
