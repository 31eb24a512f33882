// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace stiction {

/// Throws InputError "FILE:LINE: SENTENCE".
[[noreturn]] void refuse_at(const std::string& file, const toml::node& where,
                            const std::string& sentence);

/// A table read key by key: every value is checked for its type, every mistake names the line, and
/// `finish` refuses keys that nobody asked for.
class TomlTable {
 public:
  /// `what` names the table in messages, e.g. "[[body]]".
  TomlTable(const std::string& file, const toml::table& table, std::string what)
      : file_(file), table_(table), what_(std::move(what)) {}

  bool has(const std::string& key);
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& fallback);
  bool flag(const std::string& key, bool fallback);
  double number(const std::string& key);
  double number(const std::string& key, double fallback);
  Eigen::Vector3d vector(const std::string& key);
  Eigen::Vector3d vector(const std::string& key, const Eigen::Vector3d& fallback);
  std::vector<double> numbers(const std::string& key);
  std::vector<Eigen::Vector3d> vectors(const std::string& key);
  Eigen::Matrix4Xi tetrahedra(const std::string& key);  ///< a list of four whole numbers each
  TomlTable table(const std::string& key);
  std::vector<TomlTable> tables(const std::string& key);  ///< [[key]], may be absent
  /// Every key of the table with its value as text.
  std::vector<std::pair<std::string, std::string>> all_as_text();

  /// Of the file: relative paths in it start here.
  std::filesystem::path folder() const { return std::filesystem::path(file_).parent_path(); }

  bool is_table(const std::string& key);
  bool is_text(const std::string& key);

  /// "FILE:LINE: SENTENCE", with the key's line (or the table's, when absent).
  std::string at(const std::string& key, const std::string& sentence) const;
  /// Throws InputError with that.
  [[noreturn]] void refuse(const std::string& key, const std::string& sentence) const;
  /// Throws InputError if the table has a key that was never asked for.
  void finish() const;

 private:
  const toml::node& need(const std::string& key);
  double number_of(const toml::node& node, const std::string& key) const;
  Eigen::Vector3d vector_of(const toml::node& node, const std::string& key) const;
  const toml::array& array_of(const std::string& key);

  std::string file_;
  const toml::table& table_;
  std::string what_;
  std::set<std::string> known_;
};

}  // namespace stiction
