// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "reports/documents/figure_rule.h"
#include "reports/documents/kept_figures.h"

namespace stiction {

/// All that documents can name, as text.
class FigureTexts {
 public:
  /// Adds the figures of a program: "rest-poses@quiet"; "rest-poses@*", all columns of a row with
  /// " | " between them; its samples; and its run: "validate:revision", ":machine", ":date",
  /// ":toolchain". Throws std::runtime_error for a name that another program has too.
  void add(const FigureRules& rules, const KeptFigures& kept);

  /// Throws std::runtime_error when nothing is called so.
  const std::string& of(const std::string& name) const;

  /// Names of rules and samples that were never asked for.
  std::vector<std::string> unused() const;

 private:
  void put(const std::string& name, const std::string& text);

  std::map<std::string, std::string> texts_;
  std::set<std::string> to_be_used_;
  mutable std::set<std::string> used_;
};

/// Text of a table's template. Throws std::runtime_error when there is none.
using Templates = std::function<std::string(const std::string& name)>;

/// A Markdown document with all between its markers written anew:
///
///   <!-- table: who-holds -->          the template, in which {{name}} stands for a figure
///   <!-- /table -->
///   <!-- v:rest-poses@quiet -->32<!-- /v -->          one figure in running text
///
/// Throws std::runtime_error "NAME:LINE: SENTENCE" for an unknown name or a marker without end.
std::string written(const std::string& document, const std::string& name,
                    const FigureTexts& figures, const Templates& templates);

/// Whether a document has any marker.
bool has_markers(const std::string& document);

}  // namespace stiction
