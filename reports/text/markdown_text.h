// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// `text` so that GitHub-flavoured Markdown shows it as it is, in running text and in table cells:
/// one line, without live HTML, links, emphasis, formulas, cell borders, headings or list marks.
std::string markdown_escaped(std::string_view text);

/// Distinct words, escaped, with "; " between them.
std::string markdown_joined(const std::set<std::string>& words);

/// A verdict's word; bold and in capitals when it needs attention.
std::string markdown_verdict(Verdict verdict);

/// A table whose cells are Markdown already (escaped by the caller), padded so that the source
/// reads as a table too. Columns without any content are left out.
class MarkdownTable {
 public:
  enum class Align { kLeft, kRight };
  struct Column {
    std::string heading;
    Align align = Align::kLeft;
  };

  explicit MarkdownTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// As many cells as columns; std::invalid_argument otherwise.
  void add_row(std::vector<std::string> cells);

  /// The table with an empty line behind it; empty when there is no row.
  std::string text() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};
inline constexpr auto kRight = MarkdownTable::Align::kRight;  ///< of columns of numbers

}  // namespace stiction
