// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stiction {

/// Text that comes from records is not trusted: a TOML file, another engine or a broken disk wrote
/// it. Every readable output passes it through `one_line` before its own escaping, and what is
/// printed passes through `printable` at last (show, reports/screen/program.h).

/// One line of valid UTF-8: line breaks and tabs become spaces, other control characters (terminal
/// escapes among them), characters that turn the direction of text and those that XML forbids are
/// dropped, broken UTF-8 becomes U+FFFD.
std::string one_line(std::string_view text);

/// The lines of `text`, each as `one_line` has it. `styled`: the terminal styles that this project
/// gives (bold, colours of verdicts) stay.
std::string printable(std::string_view text, bool styled = false);

/// Terminal columns that valid UTF-8 takes: code points, combining marks not counted. East Asian
/// wide characters count as one, which can misalign a table and nothing else.
std::size_t display_width(std::string_view text);

/// `text`, or, when it is wider than `width`, its two ends around "…": the end of a case name tells
/// more than its middle.
std::string shortened(std::string_view text, std::size_t width);

/// `text` filled with spaces up to `width` columns; longer text is left as it is.
std::string padded_right(std::string_view text, std::size_t width);
std::string padded_left(std::string_view text, std::size_t width);

/// "1 scene", "7 scenes".
std::string counted(std::size_t count, const std::string& what);

/// `text` broken at spaces into lines of at most `width` columns (a longer word stays whole).
/// Empty text gives no line.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

}  // namespace stiction
