// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace stiction {

/// What a program prints on: a terminal, a pipe or a file.
struct Screen {
  std::size_t width = 80;  ///< columns
  bool colour = false;     ///< ANSI colours; nothing is said by colour alone
  std::size_t height = 0;  ///< lines; 0: any number
  bool moving = false;     ///< lines may be written over: a terminal that is not dumb
};

/// Of the file descriptor. Its width is COLUMNS where that is set, else the terminal's, else 80, its
/// height the terminal's; no colour with NO_COLOR that is not empty, on a dumb terminal, or where it is none.
Screen screen_of(int descriptor);

/// "- text", made one line, in lines of at most `width` columns, but of 20 at least; further lines
/// stand under the text. No line for empty text.
std::string bullet(const std::string& text, std::size_t width, const std::string& mark = "- ");

/// Cells of a table without rules, `gap` spaces apart: columns of `texts` to the left, the rest to the
/// right. Cells are never cut: columns behind the first that do not fit into `width` stand in a second
/// table below, under the first column again.
using Cells = std::vector<std::vector<std::string>>;
std::string plain_table(const Cells& rows, const std::set<std::size_t>& texts, std::size_t width,
                        std::size_t gap = 2);

/// `text` in bold where the screen has that.
std::string bold(const std::string& text, const Screen& screen);

}  // namespace stiction
