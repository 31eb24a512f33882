// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "reports/screen/screen.h"

namespace stiction {

/// What a page of --help says beside the options, which it takes from the program. It has the sections
/// of a manual page, and `man_page` makes one of it.
struct HelpPage {
  std::string name{};     ///< "stiction-compare"
  std::string summary{};  ///< what it does, in half a line
  std::vector<std::string> synopsis{};
  std::string description{};                                      ///< two sentences
  std::vector<std::pair<std::string, std::string>> exit_codes{};  ///< code, what it means
  std::vector<std::pair<std::string, std::string>> files{};       ///< path, what is in it
  std::vector<std::pair<std::string, std::string>> examples{};    ///< command, what it is for
  std::vector<std::string> see_also{};
  /// Sections of its own, before the exit codes: heading, lines as they are.
  std::vector<std::pair<std::string, std::string>> more{};
};

/// Writes that page; of options their group is a heading.
class HelpFormatter : public CLI::FormatterBase {
 public:
  explicit HelpFormatter(HelpPage page) : page_(std::move(page)) {}

  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override {
    // No wider than a page is read well.
    const std::size_t width = std::clamp<std::size_t>(screen_of(STDOUT_FILENO).width, 40, 100);
    std::string text = "NAME\n" + indented(page_.name + " - " + page_.summary, width);
    text += "\nSYNOPSIS\n";
    for (const std::string& line : page_.synopsis) text += bullet(line, width, kMargin);
    text += "\nDESCRIPTION\n" + indented(page_.description, width);
    for (const auto& [group, options] : groups_of(*app)) {
      text += "\n" + upper(group) + "\n";
      for (const CLI::Option* option : options) {
        text += kMargin + words_of(*option) + "\n" + bullet(meaning_of(*option), width, kDeep);
      }
    }
    const auto subcommands = app->get_subcommands({});
    if (!subcommands.empty()) {
      text += "\nCOMMANDS\n";
      for (const CLI::App* sub : subcommands) {
        text += kMargin + sub->get_name() + "\n" + bullet(sub->get_description(), width, kDeep);
      }
    }
    for (const auto& [heading, lines] : page_.more)
      text += "\n" + upper(heading) + "\n" + margin(lines);
    text += section("EXIT STATUS", page_.exit_codes, width) + section("FILES", page_.files, width);
    text += section("EXAMPLES", page_.examples, width);
    std::string others;
    for (const std::string& one : page_.see_also) others += (others.empty() ? "" : ", ") + one;
    return text + "\nSEE ALSO\n" + indented(others, width);
  }

 private:
  static constexpr const char* kMargin = "       ";
  static constexpr const char* kDeep = "              ";

  static std::string indented(const std::string& text, std::size_t width) {
    return bullet(text, width, kMargin);
  }

  static std::string margin(const std::string& lines) {
    std::string text;
    for (std::size_t begin = 0; begin < lines.size();) {
      const std::size_t end = std::min(lines.find('\n', begin), lines.size());
      text += (end > begin ? kMargin : "") + lines.substr(begin, end - begin) + "\n";
      begin = end + 1;
    }
    return text;
  }

  static std::string section(const char* heading,
                             const std::vector<std::pair<std::string, std::string>>& entries,
                             std::size_t width) {
    if (entries.empty()) return "";
    std::string text = std::string("\n") + heading + "\n";
    for (const auto& [what, meaning] : entries) {
      text += kMargin + what + "\n" + bullet(meaning, width, kDeep);
    }
    return text;
  }

  static std::string upper(std::string text) {
    for (char& sign : text) {
      if (sign >= 'a' && sign <= 'z') sign = static_cast<char>(sign - 'a' + 'A');
    }
    return text;
  }

  // In the order of their first option; what has no group is not told.
  static std::vector<std::pair<std::string, std::vector<const CLI::Option*>>> groups_of(
      const CLI::App& app) {
    std::vector<std::pair<std::string, std::vector<const CLI::Option*>>> groups;
    for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
      std::string group = option->get_group();
      if (group.empty()) continue;
      if (option->get_positional()) group = "Arguments";
      const auto at = std::find_if(groups.begin(), groups.end(),
                                   [&](const auto& known) { return known.first == group; });
      (at == groups.end() ? groups.emplace_back(group, std::vector<const CLI::Option*>{}) : *at)
          .second.push_back(option);
    }
    // --help, which each program has, comes last.
    std::stable_partition(groups.begin(), groups.end(),
                          [](const auto& group) { return group.first != "Options"; });
    return groups;
  }

  static std::string words_of(const CLI::Option& option) {
    if (option.get_positional()) return upper(option.get_name(true));
    std::string words;
    for (const std::string& name : option.get_snames())
      words += (words.empty() ? "-" : ", -") + name;
    for (const std::string& name : option.get_lnames())
      words += (words.empty() ? "--" : ", --") + name;
    // Behind ':' a validator says what it takes.
    const std::string type = option.get_type_name();
    return type.empty() ? words : words + " " + type.substr(0, type.find(':'));
  }

  static std::string meaning_of(const CLI::Option& option) {
    std::string text = option.get_description();
    if (!option.get_default_str().empty() && !option.get_type_name().empty()) {
      text += fmt::format(" [{}]", option.get_default_str());
    }
    if (option.get_required()) text += " (required)";
    if (!option.get_envname().empty())
      text += fmt::format(" (or the variable {})", option.get_envname());
    return text;
  }

  HelpPage page_;
};

/// Gives the program this page for --help. Groups of options are set where the options are.
inline void set_help(CLI::App& app, HelpPage page) {
  app.formatter(std::make_shared<HelpFormatter>(std::move(page)));
}

}  // namespace stiction
