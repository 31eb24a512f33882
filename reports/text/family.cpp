// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/family.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <tuple>
#include <utility>

#include "reports/text/check_text.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

// A name as numbers and characters. Numbers sort before characters, so that the order is total.
using Token = std::tuple<bool, double, char>;  // is a character, the number, the character

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  for (std::size_t position = 0; position < text.size();) {
    const char c = text[position];
    double number = 0.0;
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
      const char* end = text.data() + text.size();
      const auto parsed = std::from_chars(text.data() + position, end, number);
      if (parsed.ec == std::errc()) {
        tokens.emplace_back(false, number, '\0');
        position = static_cast<std::size_t>(parsed.ptr - text.data());
        continue;
      }
    }
    tokens.emplace_back(true, 0.0, c);
    ++position;
  }
  return tokens;
}

std::map<std::string, std::string> settings_with_engine(const Record& record) {
  std::map<std::string, std::string> settings = record.settings;
  settings.emplace("engine", record.engine);
  return settings;
}

std::map<std::string, std::string> common_settings_of(const std::vector<const Record*>& records) {
  std::map<std::string, std::string> common = settings_with_engine(*records.front());
  for (const Record* record : records) {
    const auto settings = settings_with_engine(*record);
    std::erase_if(common, [&](const auto& entry) {
      const auto found = settings.find(entry.first);
      return found == settings.end() || found->second != entry.second;
    });
  }
  return common;
}

}  // namespace

std::string Family::label(const Record& record) const {
  std::string text = one_line(record.case_name);
  const std::string prefix = one_line(name) + "/";
  if (text.starts_with(prefix)) text.erase(0, prefix.size());
  auto settings = settings_with_engine(record);
  std::erase_if(settings, [&](const auto& entry) { return common_settings.contains(entry.first); });
  const std::string differing = settings_text(settings);
  return differing.empty() ? text : text + " " + differing;
}

std::string family_name(const std::string& case_name) {
  const std::size_t first = case_name.find('/');
  if (first == std::string::npos) return case_name;
  const std::size_t second = case_name.find('/', first + 1);
  const std::string_view two = std::string_view(case_name).substr(0, second);
  const bool second_is_parameter = two.find('=', first) != std::string_view::npos;
  return case_name.substr(0, second_is_parameter ? first : two.size());
}

std::vector<Family> families_of(const std::vector<Record>& records) {
  std::map<std::string, std::vector<const Record*>, decltype(&natural_less)> by_name(&natural_less);
  for (const Record& record : records) by_name[family_name(record.case_name)].push_back(&record);

  std::vector<Family> families;
  for (auto& [name, members] : by_name) {
    std::stable_sort(members.begin(), members.end(), [](const Record* a, const Record* b) {
      if (a->case_name != b->case_name) return natural_less(a->case_name, b->case_name);
      return natural_less(a->engine + " " + settings_text(a->settings),
                          b->engine + " " + settings_text(b->settings));
    });
    families.push_back({name, members, common_settings_of(members)});
  }
  return families;
}

bool natural_less(std::string_view a, std::string_view b) {
  const auto tokens_a = tokens_of(a);
  const auto tokens_b = tokens_of(b);
  // Equal by value but not by spelling (1.0, 1.00): the spelling decides.
  return tokens_a != tokens_b ? tokens_a < tokens_b : a < b;
}

}  // namespace stiction
