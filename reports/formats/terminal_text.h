// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "reports/record/judgement.h"

namespace stiction {

/// How text is drawn on a terminal or into a file.
struct TableStyle {
  std::size_t width = 100;  ///< terminal columns; below 77 lines grow longer than asked for
  bool colour = false;      ///< ANSI colours; nothing is said by colour alone
};

inline constexpr std::size_t kVerdictWidth = 7;  // "refuted"

/// Words as seen on the terminal: what needs attention is in capitals, with or without colour.
std::string_view verdict_word(Verdict verdict);

/// The word filled to kVerdictWidth columns, coloured where the style is.
std::string verdict_cell(Verdict verdict, const TableStyle& style);

/// Lines behind a label, the continuation lines aligned with the first. No line for empty text.
std::string block(std::string_view label, std::string_view text, std::size_t indent,
                  const TableStyle& style);

}  // namespace stiction
