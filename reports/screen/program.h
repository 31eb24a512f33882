// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace stiction {

/// Prints text of several lines. Whatever it quotes, a terminal gets nothing but text and, where it has
/// colour, this project's styles (printable, reports/text/text.h). What cannot be written is known at
/// the end (run_program).
void show(std::string_view text);

/// Prints a line: its text made one line, so that nothing it quotes can look like another.
void show_line(std::string_view text);

/// A line on the standard error: its text made one line, as it may quote what others wrote. Where
/// nobody can read it, it is lost and nothing else happens.
void tell(std::string_view text);

/// The rest of a program, once its words are understood. Returns its exit code (exit_code.h).
using ProgramBody = std::function<int()>;

/// What is alike in all programs: whatever `body` throws becomes one sentence behind `name` on the
/// standard error and exit code 2, and so does output that could not be written; where whoever read
/// it has gone, the exit code alone. A pipe without a reader and a file size limit are errors of the
/// write then, not the end of the program.
int run_program(const std::string& name, const ProgramBody& body);

}  // namespace stiction
