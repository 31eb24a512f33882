// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/documents/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace stiction {

namespace {

constexpr std::string_view kTable = "<!-- table: ", kTableEnd = "<!-- /table -->";
constexpr std::string_view kValue = "<!-- v:", kValueEnd = "<!-- /v -->";
constexpr std::string_view kMarkerEnd = " -->";

[[noreturn]] void refuse(const std::string& name, const std::string& text, std::size_t at,
                         const std::string& sentence) {
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  throw std::runtime_error(fmt::format("{}:{}: {}", name, line, sentence));
}

std::string filled(const std::string& text, const std::string& name, const FigureTexts& figures) {
  std::string result;
  std::size_t from = 0;
  while (true) {
    const std::size_t begin = text.find("{{", from);
    if (begin == std::string::npos) return result + text.substr(from);
    const std::size_t end = text.find("}}", begin);
    if (end == std::string::npos) refuse(name, text, begin, "'{{' without '}}'");
    result += text.substr(from, begin - from);
    try {
      result += figures.of(text.substr(begin + 2, end - begin - 2));
    } catch (const std::runtime_error& error) {
      refuse(name, text, begin, error.what());
    }
    from = end + 2;
  }
}

}  // namespace

void FigureTexts::put(const std::string& name, const std::string& text) {
  if (!texts_.emplace(name, text).second) {
    throw std::runtime_error(fmt::format("two programs have a figure '{}'", name));
  }
}

void FigureTexts::add(const FigureRules& rules, const KeptFigures& kept) {
  const std::string of_program = "reports/documents/figures/" + rules.program + ".json";
  for (const FigureRule& rule : rules.figures) {
    const auto found = kept.figures.find(rule.name);
    if (found == kept.figures.end()) {
      throw std::runtime_error(fmt::format(
          "{}: figure '{}' is not in {}: ./stiction readme --update RUN adds it from a run",
          rule.where, rule.name, of_program));
    }
    put(rule.name, text_of(found->second, rule.style));
    to_be_used_.insert(rule.name);
  }
  for (const auto& [row, columns] : rules.columns) {
    std::string cells;
    for (const std::string& column : columns) {
      cells += (cells.empty() ? "" : " | ") + texts_.at(row + "@" + column);
    }
    put(row + "@*", cells);
  }
  for (const SampleRule& rule : rules.samples) {
    const auto found = kept.samples.find(rule.name);
    if (found == kept.samples.end()) {
      throw std::runtime_error(
          fmt::format("{}: sample '{}' is not in {}", rule.where, rule.name, of_program));
    }
    put(rule.name, found->second.substr(0, found->second.size() - 1));
    to_be_used_.insert(rule.name);
  }
  put(rules.program + ":revision", kept.environment.revision);
  put(rules.program + ":toolchain", kept.environment.toolchain);
  put(rules.program + ":machine", kept.environment.machine);
  put(rules.program + ":date", kept.environment.date);
}

const std::string& FigureTexts::of(const std::string& name) const {
  const auto found = texts_.find(name);
  if (found == texts_.end()) {
    throw std::runtime_error(fmt::format("there is no figure '{}'", name));
  }
  used_.insert(name);
  return found->second;
}

std::vector<std::string> FigureTexts::unused() const {
  std::vector<std::string> names;
  for (const std::string& name : to_be_used_) {
    const std::string row = name.substr(0, name.find('@')) + "@*";
    if (!used_.count(name) && !used_.count(row)) names.push_back(name);
  }
  return names;
}

bool has_markers(const std::string& document) {
  return document.find(kTable) != std::string::npos || document.find(kValue) != std::string::npos;
}

std::string written(const std::string& document, const std::string& name,
                    const FigureTexts& figures, const Templates& templates) {
  std::string result;
  std::size_t from = 0;
  while (true) {
    const std::size_t table = document.find(kTable, from), value = document.find(kValue, from);
    const std::size_t begin = std::min(table, value);
    if (begin == std::string::npos) return result + document.substr(from);
    const bool is_table = table < value;
    const std::string_view start = is_table ? kTable : kValue,
                           stop = is_table ? kTableEnd : kValueEnd;
    const std::size_t name_at = begin + start.size();
    const std::size_t name_end = document.find(kMarkerEnd, name_at);
    const std::size_t end = document.find(stop, name_at);
    // Another marker before the end: this one's own is missing.
    const std::size_t next =
        std::min(document.find(kTable, name_at), document.find(kValue, name_at));
    if (name_end == std::string::npos || end == std::string::npos || next < end) {
      refuse(name, document, begin, fmt::format("a marker without its {}", stop));
    }
    const std::string called = document.substr(name_at, name_end - name_at);
    result += document.substr(from, name_end + kMarkerEnd.size() - from);
    try {
      result +=
          is_table ? "\n" + filled(templates(called), called + ".md", figures) : figures.of(called);
    } catch (const std::runtime_error& error) {
      refuse(name, document, begin, error.what());
    }
    result += stop;
    from = end + stop.size();
  }
}

}  // namespace stiction
