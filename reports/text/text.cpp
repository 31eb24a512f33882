// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/text.h"

#include <algorithm>
#include <cstdint>

namespace stiction {
namespace {

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 1;  // taken from the input; 1 when broken, so that reading goes on behind it
  bool valid = false;
};

CodePoint code_point_at(std::string_view text, std::size_t position) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(position);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || position + bytes > text.size()) return {};
  char32_t value = lead & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(position + i) & 0xC0u) != 0x80u) return {};
    value = (value << 6) | (byte(position + i) & 0x3Fu);
  }
  // Overlong forms, surrogates and what lies beyond Unicode.
  constexpr char32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (value < kSmallest[bytes] || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF)) {
    return {};
  }
  return {value, bytes, true};
}

// Marks and overrides of direction, which can disguise text.
bool turns_direction(char32_t c) {
  return c == 0x061C || c == 0x200E || c == 0x200F || (c >= 0x202A && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069);
}

// Those, control characters (C0, DEL, C1), and the two non-characters that XML 1.0 excludes.
bool is_dropped(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c <= 0x9F) || turns_direction(c) || c == 0xFFFE || c == 0xFFFF;
}

// Length of the style of a terminal that `text` begins with, one of those that this project gives; 0
// if of none.
std::size_t style_length(std::string_view text) {
  for (const std::string_view style :
       {"\033[0m", "\033[1m", "\033[2m", "\033[32m", "\033[33m", "\033[1;31m"}) {
    if (text.starts_with(style)) return style.size();
  }
  return 0;
}

bool is_combining(char32_t c) {
  return (c >= 0x0300 && c <= 0x036F) || (c >= 0x20D0 && c <= 0x20FF) ||
         (c >= 0x200B && c <= 0x200D) || (c >= 0xFE00 && c <= 0xFE0F);
}

// Byte position behind the first `width` columns of `text`, combining marks included.
std::size_t position_of_column(std::string_view text, std::size_t width) {
  std::size_t columns = 0;
  std::size_t position = 0;
  while (position < text.size()) {
    const CodePoint c = code_point_at(text, position);
    if (!is_combining(c.value) && ++columns > width) break;
    position += c.bytes;
  }
  return position;
}

std::string fill(std::string_view text, std::size_t width) {
  const std::size_t taken = display_width(text);
  return std::string(width > taken ? width - taken : 0, ' ');
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  for (std::size_t position = 0; position < text.size();) {
    const CodePoint c = code_point_at(text, position);
    if (!c.valid) {
      line += "\uFFFD";
    } else if (c.value == '\n' || c.value == '\t' || c.value == 0x2028 || c.value == 0x2029) {
      line += ' ';
    } else if (!is_dropped(c.value)) {
      line += text.substr(position, c.bytes);
    }
    position += c.bytes;
  }
  return line;
}

std::string printable(std::string_view text, bool styled) {
  std::string lines;
  std::size_t begin = 0;  // of what is not yet in `lines`
  for (std::size_t end = 0; end < text.size();) {
    const std::size_t style = styled ? style_length(text.substr(end)) : 0;
    const std::size_t kept = style > 0 ? style : text[end] == '\n' ? 1 : 0;
    if (kept > 0) {
      lines += one_line(text.substr(begin, end - begin));
      lines += text.substr(end, kept);
      begin = end + kept;
    }
    end += std::max<std::size_t>(kept, 1);
  }
  return lines + one_line(text.substr(begin));
}

std::size_t display_width(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t position = 0; position < text.size();) {
    const CodePoint c = code_point_at(text, position);
    if (!is_combining(c.value)) ++columns;
    position += c.bytes;
  }
  return columns;
}

std::string shortened(std::string_view text, std::size_t width) {
  const std::size_t taken = display_width(text);
  if (taken <= width) return std::string(text);
  if (width == 0) return "";
  const std::size_t head = (width - 1) / 2;
  const std::size_t tail = width - 1 - head;
  std::string result(text.substr(0, position_of_column(text, head)));
  result += "…";
  result += text.substr(position_of_column(text, taken - tail));
  return result;
}

std::string padded_right(std::string_view text, std::size_t width) {
  return std::string(text) + fill(text, width);
}

std::string padded_left(std::string_view text, std::size_t width) {
  return fill(text, width) + std::string(text);
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    begin = end + 1;
    if (word.empty()) continue;
    if (!lines.empty() && display_width(lines.back()) + 1 + display_width(word) <= width) {
      lines.back() += ' ';
      lines.back() += word;
    } else {
      lines.emplace_back(word);
    }
  }
  return lines;
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace stiction
