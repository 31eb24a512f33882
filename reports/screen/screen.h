// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stiction {

/// What a program prints on: a terminal, a pipe or a file.
struct Screen {
  std::size_t width = 80;  ///< columns
  bool colour = false;     ///< ANSI colours; nothing is said by colour alone
  bool moving = false;     ///< lines may be written over: a terminal that is not dumb
};

/// Of the file descriptor. Its width is COLUMNS where that is set, else the terminal's, else 80;
/// no colour with NO_COLOR, on a dumb terminal, or where it is none.
Screen screen_of(int descriptor);

/// "- text" in lines of at most `width` columns; further lines stand under the text.
std::string bullet(const std::string& text, std::size_t width, const std::string& mark = "- ");

/// Cells of a table without rules, two spaces apart: the first `texts` columns to the left, the rest
/// to the right. Cells are never cut: columns behind the first that do not fit into `width` stand in a
/// second table below, under the first column again.
using Cells = std::vector<std::vector<std::string>>;
std::string plain_table(const Cells& rows, std::size_t texts, std::size_t width);

/// "1 scene", "7 scenes".
std::string counted(std::size_t count, const std::string& what);

/// `text` in bold where the screen has that.
std::string bold(const std::string& text, const Screen& screen);

}  // namespace stiction
