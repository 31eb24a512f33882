// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "reports/record/judgement.h"
#include "reports/screen/screen.h"

namespace stiction {

inline constexpr std::size_t kVerdictWidth = 7;  // "refuted"

/// Words as seen on the terminal: what needs attention is in capitals, with or without colour.
std::string_view verdict_word(Verdict verdict);

/// The word filled to kVerdictWidth columns, coloured where the screen is.
std::string verdict_cell(Verdict verdict, const Screen& screen);

}  // namespace stiction
