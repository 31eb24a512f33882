// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "reports/text/names.h"
#include "reports/text/text.h"
#include "solver/demand.h"
#include "validation/user/quantity.h"

namespace stiction {

namespace {

std::string place_of(const std::string& file, const toml::node& where) {
  const auto line = where.source().begin.line;
  return line > 0 ? fmt::format("{}:{}", file, line) : file;  // 0: a sweep's own value
}

std::string sentence_at(const std::string& file, const toml::node& where,
                        const std::string& sentence) {
  // Keys and texts that it quotes may hold anything.
  return fmt::format("{}: {}", place_of(file, where), one_line(sentence));
}

// "must be a finite number, or one with a unit ("3 mm"; there are: m, mm, cm)".
std::string must_be_number(const std::string& key, const std::string& unit) {
  const std::vector<std::string_view> units = units_like(unit);
  if (units.empty()) return fmt::format("'{}' must be a finite number", key);
  return fmt::format("'{}' must be a finite number, or a text of one and its unit: {}", key,
                     fmt::join(units, ", "));
}

}  // namespace

void refuse_at(const std::string& file, const toml::node& where, const std::string& sentence) {
  throw InputError(sentence_at(file, where, sentence));
}

const TomlKey& TomlTable::asked(const std::string& key) {
  const auto found = std::find_if(keys_.keys.begin(), keys_.keys.end(),
                                  [&](const TomlKey& one) { return one.name == key; });
  if (found == keys_.keys.end()) {
    throw std::logic_error(keys_.table + " is asked for '" + key + "', which nobody explains");
  }
  asked_.insert(key);
  return *found;
}

bool TomlTable::has(const std::string& key) {
  asked(key);
  return table_.contains(key);
}

bool TomlTable::is_table(const std::string& key) { return has(key) && table_.get(key)->is_table(); }

bool TomlTable::is_text(const std::string& key) { return has(key) && table_.get(key)->is_string(); }

std::string TomlTable::place() const { return place_of(file_, table_); }

std::string TomlTable::at(const std::string& key, const std::string& sentence) const {
  const toml::node* const node = table_.get(key);
  return sentence_at(file_, node ? *node : table_, sentence);
}

void TomlTable::refuse(const std::string& key, const std::string& sentence) const {
  throw InputError(at(key, sentence));
}

void TomlTable::finish() const {
  const auto name = [](const TomlKey& key) { return key.name; };
  for (const auto& [key, node] : table_) {
    const std::string word(key.str());
    if (asked_.count(word) > 0) continue;
    for (const TomlKey& one : keys_.keys) {
      if (one.name != word) continue;
      const std::string& what = one.meaning.empty() ? one.otherwise : one.meaning;
      refuse_at(file_, node,
                fmt::format("'{}' has no effect beside what else {} says{}{}", word, keys_.table,
                            what.empty() ? "" : "; it is: ", what));
    }
    for (const auto& [tried, sentence] : keys_.instead) {
      if (tried != word) continue;
      refuse_at(file_, node, fmt::format("{} has no key '{}': {}", keys_.table, word, sentence));
    }
    refuse_at(file_, node,
              fmt::format("{} has no key '{}'; there are: {}", keys_.table, word,
                          listed_names(keys_.keys, name)));
  }
}

const toml::node& TomlTable::need(const std::string& key) {
  if (!has(key)) refuse_at(file_, table_, fmt::format("{} lacks '{}'", keys_.table, key));
  return *table_.get(key);
}

std::string TomlTable::text(const std::string& key) {
  const toml::node& node = need(key);
  if (!node.is_string()) refuse(key, fmt::format("'{}' must be a text in quotes", key));
  return node.as_string()->get();
}

std::string TomlTable::text(const std::string& key, const std::string& fallback) {
  return has(key) ? text(key) : fallback;
}

bool TomlTable::flag(const std::string& key, bool fallback) {
  if (!has(key)) return fallback;
  const toml::node& node = need(key);
  if (!node.is_boolean()) refuse(key, fmt::format("'{}' must be true or false", key));
  return node.as_boolean()->get();
}

double TomlTable::number_of(const toml::node& node, const std::string& key,
                            const std::string& unit) const {
  std::optional<double> value;
  if (node.is_number()) value = node.value<double>();
  if (node.is_string()) value = quantity_in(unit, node.as_string()->get());
  if (!value || !std::isfinite(*value)) refuse_at(file_, node, must_be_number(key, unit));
  return *value;
}

double TomlTable::number(const std::string& key) { return number_in(asked(key).unit, key); }

double TomlTable::number(const std::string& key, double fallback) {
  return has(key) ? number(key) : fallback;
}

double TomlTable::number_in(const std::string& unit, const std::string& key) {
  return number_of(need(key), key, unit);
}

Eigen::Vector3d TomlTable::vector_of(const toml::node& node, const std::string& key) {
  const toml::array* const array = node.as_array();
  if (!array || array->size() != 3) {
    refuse_at(file_, node, fmt::format("'{}' must be three numbers, like [0, 0, 1]", key));
  }
  const std::string& unit = asked(key).unit;
  Eigen::Vector3d vector;
  for (int k = 0; k < 3; ++k) {
    vector[k] = number_of(*array->get(static_cast<std::size_t>(k)), key, unit);
  }
  return vector;
}

Eigen::Vector3d TomlTable::vector(const std::string& key) { return vector_of(need(key), key); }

Eigen::Vector3d TomlTable::vector(const std::string& key, const Eigen::Vector3d& fallback) {
  return has(key) ? vector(key) : fallback;
}

const toml::array& TomlTable::array_of(const std::string& key) {
  const toml::array* const array = need(key).as_array();
  if (!array) refuse(key, fmt::format("'{}' must be a list", key));
  return *array;
}

std::vector<std::string> TomlTable::texts(const std::string& key) {
  std::vector<std::string> all;
  for (const toml::node& node : array_of(key)) {
    if (!node.is_string()) {
      refuse_at(file_, node, fmt::format("'{}' must be a list of texts in quotes", key));
    }
    all.push_back(node.as_string()->get());
  }
  return all;
}

std::vector<double> TomlTable::numbers(const std::string& key) {
  return numbers_in(asked(key).unit, key);
}

std::vector<double> TomlTable::numbers_in(const std::string& unit, const std::string& key) {
  std::vector<double> all;
  for (const toml::node& node : array_of(key)) all.push_back(number_of(node, key, unit));
  return all;
}

std::vector<Eigen::Vector3d> TomlTable::vectors(const std::string& key) {
  std::vector<Eigen::Vector3d> all;
  for (const toml::node& node : array_of(key)) all.push_back(vector_of(node, key));
  return all;
}

Eigen::Matrix4Xi TomlTable::tetrahedra(const std::string& key) {
  const toml::array& list = array_of(key);
  Eigen::Matrix4Xi all(4, static_cast<Eigen::Index>(list.size()));
  Eigen::Index column = 0;
  for (const toml::node& node : list) {
    const toml::array* const four = node.as_array();
    if (!four || four->size() != 4) {
      refuse_at(file_, node, fmt::format("'{}' must hold four vertex numbers each", key));
    }
    for (int k = 0; k < 4; ++k) {
      const auto vertex = four->get(static_cast<std::size_t>(k))->value_exact<std::int64_t>();
      if (!vertex || *vertex < 0 || *vertex > 1000000000) {
        refuse_at(file_, node, fmt::format("'{}' must hold whole numbers from 0 on", key));
      }
      all(k, column) = static_cast<int>(*vertex);
    }
    ++column;
  }
  return all;
}

TomlTable TomlTable::table(const std::string& key, const TomlKeys& keys) {
  const toml::table* const inner = need(key).as_table();
  if (!inner) refuse(key, fmt::format("'{}' must be a table", key));
  return {file_, *inner, keys};
}

std::vector<TomlTable> TomlTable::tables(const std::string& key, const TomlKeys& keys) {
  std::vector<TomlTable> all;
  if (!has(key)) return all;
  for (const toml::node& node : array_of(key)) {
    const toml::table* const inner = node.as_table();
    if (!inner) refuse_at(file_, node, fmt::format("'{}' must be written as [[{}]]", key, key));
    all.emplace_back(file_, *inner, keys);
  }
  return all;
}

std::vector<std::pair<std::string, std::string>> TomlTable::settings(const std::string& key) {
  const toml::table* const inner = need(key).as_table();
  if (!inner) refuse(key, fmt::format("'{}' must be a table", key));
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& [name, node] : *inner) {
    const std::string word(name.str());
    if (node.is_string()) {
      all.emplace_back(word, node.as_string()->get());
    } else {
      // As the file spells it: 2e-4 stays a short number.
      all.emplace_back(word, fmt::format("{}", number_of(node, word, "")));
    }
  }
  return all;
}

}  // namespace stiction
