// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/screen/screen.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "reports/text/text.h"

namespace stiction {

namespace {

constexpr long kLeastColumns = 20, kMostColumns = 10000;  // columns that are believed

winsize size_of(int descriptor) {
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0) return {};
  return size;
}

std::size_t width_of(const winsize& size) {
  if (const char* const told = std::getenv("COLUMNS")) {
    char* end = nullptr;
    const long columns = std::strtol(told, &end, 10);
    if (end != told && *end == '\0' && columns >= kLeastColumns && columns <= kMostColumns) {
      return static_cast<std::size_t>(columns);
    }
  }
  if (size.ws_col >= kLeastColumns) return size.ws_col;
  return Screen{}.width;
}

std::string without_end_spaces(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

Screen screen_of(int descriptor) {
  const char* const terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || *terminal == '\0' || std::strcmp(terminal, "dumb") == 0;
  const char* const no_colour = std::getenv("NO_COLOR");
  const winsize size = size_of(descriptor);
  Screen screen;
  screen.width = width_of(size);
  screen.height = size.ws_row;
  screen.moving = isatty(descriptor) == 1 && !dumb;
  screen.colour = screen.moving && (no_colour == nullptr || *no_colour == '\0');
  return screen;
}

std::string bullet(const std::string& text, std::size_t width, const std::string& mark) {
  constexpr std::size_t kLeastRoom = 20;
  const std::size_t indent = display_width(mark);
  const std::size_t room = width > indent + kLeastRoom ? width - indent : kLeastRoom;
  std::string lines;
  for (const std::string& line : wrapped(one_line(text), room)) {
    lines += (lines.empty() ? mark : std::string(indent, ' ')) + line + "\n";
  }
  return lines;
}

std::string plain_table(const Cells& rows, const std::set<std::size_t>& texts, std::size_t width,
                        std::size_t gap) {
  if (rows.empty()) return "";
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t c = 0; c < row.size(); ++c) {
      widths[c] = std::max(widths[c], display_width(row[c]));
    }
  }
  const auto cell = [&](const std::vector<std::string>& row, std::size_t c) {
    return texts.contains(c) ? padded_right(row[c], widths[c]) : padded_left(row[c], widths[c]);
  };
  std::string text;
  for (std::size_t begin = 1; begin == 1 || begin < widths.size();) {
    std::size_t end = begin, used = widths[0];
    while (end < widths.size() && (end == begin || used + gap + widths[end] <= width)) {
      used += gap + widths[end++];
    }
    const bool blank = std::all_of(widths.begin() + begin, widths.begin() + end,
                                   [](std::size_t w) { return w == 0; });
    if (blank && begin > 1) {
      begin = end;
      continue;
    }
    if (!text.empty()) text += "\n";
    for (const auto& row : rows) {
      std::string line = cell(row, 0);
      for (std::size_t c = begin; c < std::min(end, row.size()); ++c) {
        line += std::string(gap, ' ') + cell(row, c);
      }
      text += without_end_spaces(line) + "\n";
    }
    if (end == begin) break;  // a table of one column
    begin = end;
  }
  return text;
}

std::string bold(const std::string& text, const Screen& screen) {
  return screen.colour ? "\033[1m" + text + "\033[0m" : text;
}

}  // namespace stiction
