// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/nesting.h"

#include <fmt/format.h>

#include <cctype>
#include <cstddef>

#include "solver/demand.h"

namespace stiction {

namespace {

constexpr int kMostParts = 64;

// Behind a text in quotes that begins at `at`, or at the end of its line.
std::size_t behind_text(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (++at; at < text.size() && text[at] != '\n'; ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (text[at] == quote) {
      return at + 1;
    }
  }
  return at;
}

}  // namespace

void refuse_deep_keys(std::string_view text, const std::string& file) {
  // Points between words, quoted or not, with nothing but spaces around them.
  int points = 0;
  std::size_t line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char sign = text[at];
    if (sign == '"' || sign == '\'') {
      at = behind_text(text, at);
      continue;
    }
    if (sign == '.' && ++points >= kMostParts) {
      throw InputError(fmt::format("{}:{}: a key has more than {} parts", file, line, kMostParts));
    }
    const bool goes_on = sign == '.' || sign == ' ' || sign == '\t' || sign == '_' || sign == '-' ||
                         std::isalnum(static_cast<unsigned char>(sign)) != 0;
    if (!goes_on) points = 0;
    if (sign == '\n') ++line;
    ++at;
  }
}

}  // namespace stiction
