// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reports/documents/figure_rule.h"
#include "reports/documents/figure_value.h"
#include "reports/record/record.h"

namespace stiction {

/// The figures of a program as they were last measured: committed, so that documents can be written
/// and tested without a run. reports/documents/figures/<program>.json.
struct KeptFigures {
  Environment environment{};  ///< of the run
  std::map<std::string, FigureValue> figures{};
  std::map<std::string, std::string> samples{};  ///< printed lines
};

/// Takes them from a run's records. Throws std::runtime_error as value_of() does.
KeptFigures figures_of(const FigureRules& rules, const std::vector<std::vector<Record>>& runs);

/// The records of runs; what a later run has measured again replaces the earlier.
std::vector<Record> records_of(const std::vector<std::vector<Record>>& runs);

/// Throws std::runtime_error that names the file when it cannot be read or is no such file.
KeptFigures read_kept_figures(const std::filesystem::path& file);
std::string to_json(const KeptFigures& kept);

/// A sentence for each figure of a run that no longer agrees with the kept one.
std::vector<std::string> disagreements(const FigureRules& rules, const KeptFigures& kept,
                                       const KeptFigures& fresh);

}  // namespace stiction
