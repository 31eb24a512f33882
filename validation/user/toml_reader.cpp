// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/toml_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <sstream>

#include "reports/text/names.h"
#include "reports/text/text.h"
#include "solver/demand.h"

namespace stiction {

namespace {

std::string sentence_at(const std::string& file, const toml::node& where,
                        const std::string& sentence) {
  // Keys and texts that it quotes may hold anything.
  return fmt::format("{}:{}: {}", file, where.source().begin.line, one_line(sentence));
}

}  // namespace

void refuse_at(const std::string& file, const toml::node& where, const std::string& sentence) {
  throw InputError(sentence_at(file, where, sentence));
}

bool TomlTable::has(const std::string& key) {
  known_.insert(key);
  return table_.contains(key);
}

bool TomlTable::is_table(const std::string& key) { return has(key) && table_.get(key)->is_table(); }
bool TomlTable::is_text(const std::string& key) { return has(key) && table_.get(key)->is_string(); }

std::string TomlTable::at(const std::string& key, const std::string& sentence) const {
  const toml::node* const node = table_.get(key);
  return sentence_at(file_, node ? *node : table_, sentence);
}

void TomlTable::refuse(const std::string& key, const std::string& sentence) const {
  throw InputError(at(key, sentence));
}

void TomlTable::finish() const {
  for (const auto& [key, node] : table_) {
    const std::string word(key.str());
    if (known_.count(word) > 0) continue;
    refuse_at(file_, node,
              fmt::format("{} has no key '{}'; there are: {}", what_, word, listed_names(known_)));
  }
}

const toml::node& TomlTable::need(const std::string& key) {
  if (!has(key)) refuse_at(file_, table_, fmt::format("{} lacks '{}'", what_, key));
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

double TomlTable::number_of(const toml::node& node, const std::string& key) const {
  const std::optional<double> value = node.value<double>();
  if (!node.is_number() || !value || !std::isfinite(*value)) {
    refuse_at(file_, node, fmt::format("'{}' must be a finite number", key));
  }
  return *value;
}

double TomlTable::number(const std::string& key) { return number_of(need(key), key); }

double TomlTable::number(const std::string& key, double fallback) {
  return has(key) ? number(key) : fallback;
}

Eigen::Vector3d TomlTable::vector_of(const toml::node& node, const std::string& key) const {
  const toml::array* const array = node.as_array();
  if (!array || array->size() != 3) {
    refuse_at(file_, node, fmt::format("'{}' must be three numbers, like [0, 0, 1]", key));
  }
  Eigen::Vector3d vector;
  for (int k = 0; k < 3; ++k) {
    vector[k] = number_of(*array->get(static_cast<std::size_t>(k)), key);
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

std::vector<double> TomlTable::numbers(const std::string& key) {
  std::vector<double> all;
  for (const toml::node& node : array_of(key)) all.push_back(number_of(node, key));
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

TomlTable TomlTable::table(const std::string& key) {
  const toml::table* const inner = need(key).as_table();
  if (!inner) refuse(key, fmt::format("'{}' must be a table", key));
  return {file_, *inner, "[" + key + "]"};
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) {
  std::vector<TomlTable> all;
  if (!has(key)) return all;
  for (const toml::node& node : array_of(key)) {
    const toml::table* const inner = node.as_table();
    if (!inner) refuse_at(file_, node, fmt::format("'{}' must be written as [[{}]]", key, key));
    all.emplace_back(file_, *inner, "[[" + key + "]]");
  }
  return all;
}

std::vector<std::pair<std::string, std::string>> TomlTable::all_as_text() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& [key, node] : table_) {
    const std::string word(key.str());
    known_.insert(word);
    if (node.is_string()) {
      all.emplace_back(word, node.as_string()->get());
    } else {
      // As the file spells it: 2e-4 stays a short number.
      all.emplace_back(word, fmt::format("{}", number_of(node, word)));
    }
  }
  return all;
}

}  // namespace stiction
