// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/markdown_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "reports/text/text.h"

namespace stiction {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Bytes of multi-byte characters count: an underscore between letters of any script is plain text.
bool is_word(char c) {
  return is_digit(c) || std::isalpha(static_cast<unsigned char>(c)) != 0 ||
         (static_cast<unsigned char>(c) & 0x80u) != 0;
}

// Where a character at the start of the text would make a heading, list, quote or rule of it;
// npos when none does.
std::size_t block_mark(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return first;
  if (std::string_view("#+-=").find(text[first]) != std::string_view::npos) return first;
  std::size_t end = first;
  while (end < text.size() && is_digit(text[end])) ++end;
  const bool numbered = end > first && end < text.size() &&
                        (text[end] == '.' || text[end] == ')') &&
                        (end + 1 == text.size() || text[end + 1] == ' ');
  return numbered ? end : std::string_view::npos;
}

}  // namespace

std::string markdown_escaped(std::string_view raw) {
  const std::string text = one_line(raw);
  const std::size_t mark = block_mark(text);
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool inside_word =
        i > 0 && i + 1 < text.size() && is_word(text[i - 1]) && is_word(text[i + 1]);
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (i == mark || std::string_view("\\`*[]|~$").find(c) != std::string_view::npos ||
               (c == '_' && !inside_word)) {
      result += {'\\', c};
    } else {
      result += c;
    }
  }
  return result;
}

std::string markdown_joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "; ") + markdown_escaped(word);
  return text;
}

std::string markdown_verdict(Verdict verdict) {
  switch (verdict) {
    case Verdict::kFail:
      return "**FAIL**";
    case Verdict::kError:
      return "**ERROR**";
    case Verdict::kShortfall:
      return "*expected shortfall*";
    case Verdict::kRefuted:
      return "*refuted*";
    case Verdict::kNotApplicable:
      return "not applicable";
    case Verdict::kPass:
    case Verdict::kForInformation:
      break;
  }
  return to_string(verdict);
}

void MarkdownTable::add_row(std::vector<std::string> cells) {
  if (cells.size() != columns_.size()) throw std::invalid_argument("a row of another length");
  rows_.push_back(std::move(cells));
}

std::string MarkdownTable::text() const {
  std::string heading = "|";
  std::string rule = "|";
  std::vector<std::string> lines(rows_.size(), "|");
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    constexpr std::size_t kShortestRule = 3;
    std::size_t width = std::max(kShortestRule, display_width(columns_[column].heading));
    bool empty = true;
    for (const auto& row : rows_) {
      width = std::max(width, display_width(row[column]));
      empty = empty && row[column].empty();
    }
    if (empty) continue;
    const bool right = columns_[column].align == Align::kRight;
    const auto cell = [&](const std::string& content) {
      return fmt::format(" {} |",
                         right ? padded_left(content, width) : padded_right(content, width));
    };
    heading += cell(columns_[column].heading);
    rule += cell(right ? std::string(width - 1, '-') + ":" : std::string(width, '-'));
    for (std::size_t row = 0; row < rows_.size(); ++row) lines[row] += cell(rows_[row][column]);
  }
  if (rows_.empty()) return "";
  std::string table = heading + "\n" + rule + "\n";
  for (const std::string& line : lines) table += line + "\n";
  return table + "\n";
}

}  // namespace stiction
