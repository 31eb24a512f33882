// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/protocol/program_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "reports/text/names.h"
#include "reports/text/text.h"
#include "solver/demand.h"
#include "validation/engine/kit/stiction_engine.h"
#include "validation/engine/protocol/manifest_words.h"
#include "validation/engine/protocol/program_engine.h"

namespace stiction {

namespace {

ProgramLimits& limits_of_all() {
  static ProgramLimits limits;
  return limits;
}

// Words of `can`, each with what it stands for.
std::map<std::string, bool*> words_of(ProgramTraits& traits) {
  std::map<std::string, bool*> words{{"energies", &traits.tells_energies},
                                     {"momenta", &traits.tells_momenta},
                                     {"surface", &traits.tells_surface}};
  for (const ManifestWord& one : kManifestWords) words[one.word] = &(traits.manifest.*one.has);
  return words;
}

// What an engine says of itself is printed.
std::string words_of(const JsonField& field) { return one_line(field.text()); }

// Names and values are told back to it, so that they are not changed.
Settings settings_of(const JsonField& field) {
  Settings settings = field.map([](const JsonField& one) { return one.text(); });
  for (const auto& [name, value] : settings) {
    if (name == one_line(name) && value == one_line(value)) continue;
    field.fail("its names and values must be one line of plain text each");
  }
  return settings;
}

Settings settings_help_of(const JsonField& field) {
  Settings help = field.map([](const JsonField& one) { return words_of(one); });
  for (const auto& [name, meaning] : help) {
    if (name != one_line(name)) field.fail("its names must be one line of plain text each");
  }
  return help;
}

bool is_name(const std::string& name) {
  return !name.empty() && name.size() <= 40 && std::all_of(name.begin(), name.end(), [](char sign) {
    return std::isalnum(static_cast<unsigned char>(sign)) || sign == '-' || sign == '_' ||
           sign == '.' || sign == ' ';
  });
}

void refuse_unknown(const EngineKind& kind, const Settings& settings) {
  for (const auto& [name, value] : settings) {
    if (kind.settings_help.count(name) > 0) continue;
    throw InputError(
        fmt::format("engine '{}' has no setting '{}'; there are: {}", kind.name, name,
                    listed_names(kind.settings_help, [](const auto& one) { return one.first; })));
  }
}

EngineKind kind_of(ProgramTraits traits) {
  EngineKind kind;
  std::vector<Configuration> configurations;
  try {
    const std::unique_ptr<Dialogue> dialogue = start(traits);
    const nlohmann::json answer = dialogue->ask("hello", {{"protocol", STICTION_PROTOCOL}});
    const JsonField told = dialogue->fields(answer, "hello");
    if (told["protocol"].count() != STICTION_PROTOCOL) {
      told["protocol"].fail(fmt::format("this suite speaks version {}", int{STICTION_PROTOCOL}));
    }
    kind.name = told["name"].text();
    if (!is_name(kind.name)) {
      told["name"].fail("must be 1 to 40 letters, digits, '-', '_', '.' or spaces");
    }
    kind.description = words_of(told["description"]);
    const std::string version = words_of(told["version"]);
    if (!version.empty()) kind.description += " (" + version + ")";
    const auto known = words_of(traits);
    told["can"].list([&](const JsonField& word) {
      const auto found = known.find(word.text());
      if (found == known.end()) {
        word.fail(fmt::format("'{}' is no word of the protocol; there are: {}", word.text(),
                              listed_names(known, [](const auto& one) { return one.first; })));
      }
      return *found->second = true;
    });
    if (told.has("symplectic_euler")) traits.symplectic_euler = told["symplectic_euler"].boolean();
    if (told.has("settings")) kind.settings_help = settings_help_of(told["settings"]);
    if (told.has("ladder")) kind.ladder = told["ladder"].list(settings_of);
    if (told.has("configurations")) {
      configurations = told["configurations"].list([](const JsonField& one) {
        return Configuration{.settings = settings_of(one["settings"]),
                             .name = words_of(one["name"]),
                             .source = words_of(one["source"])};
      });
    }
  } catch (const std::runtime_error& what) {
    throw InputError(what.what());
  }
  for (const Configuration& one : configurations) refuse_unknown(kind, one.settings);
  for (const Settings& one : kind.ladder) refuse_unknown(kind, one);
  kind.manifest = traits.manifest;
  for (const std::string& word : traits.words)
    kind.program += (kind.program.empty() ? "" : " ") + word;
  kind.make = [traits, kind](const Settings& settings) {
    refuse_unknown(kind, settings);
    return make_program_engine(traits, settings);
  };
  if (!configurations.empty()) {
    kind.configurations = [configurations](const std::string&) { return configurations; };
  }
  return kind;
}

}  // namespace

EngineKind program_kind(const std::vector<std::string>& words, const ProgramLimits& limits) {
  return kind_of({.words = words, .limits = limits, .manifest = {}});
}

EngineKind program_kind(const std::vector<std::string>& words, const Answers& answers) {
  return kind_of({.words = words, .limits = {}, .manifest = {}, .answers = answers});
}

void set_program_limits(const ProgramLimits& limits) {
  if (!(limits.reply_seconds > 0.0) || !(limits.memory_gib > 0.0)) {
    throw InputError("the limits of an engine's time and memory must be above 0");
  }
  limits_of_all() = limits;
}

ProgramLimits program_limits() { return limits_of_all(); }

}  // namespace stiction
