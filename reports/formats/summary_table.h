// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include "reports/screen/screen.h"

namespace stiction {

// What the parts of the summary screen look like.

inline constexpr std::size_t kMostSummaryRows = 8;  ///< of a part
inline constexpr std::size_t kRoomy = 90;  ///< columns from which on there is room between columns
inline constexpr std::string_view kSummaryIndent = "  ";

/// Indented rows, the first a heading; columns of `texts` to the left.
inline std::string summary_table(Cells rows, const std::set<std::size_t>& texts,
                                 const Screen& screen) {
  for (auto& row : rows) row.front().insert(0, kSummaryIndent);
  return plain_table(rows, texts, screen.width, screen.width < kRoomy ? 1 : 2);
}

}  // namespace stiction
