// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace stiction {

/// A key of a table in a file, as it is read and as it is explained.
struct TomlKey {
  std::string name;
  std::string unit;       ///< of its numbers, as in quantity.h; "": it has none, or it depends
  std::string form;       ///< what stands behind "=": "3", "\"text\"", "[x, y, z]"
  std::string otherwise;  ///< when it is left out: a value, "must be given", or what then holds
  std::string meaning;
};

/// All keys of a table.
struct TomlKeys {
  std::string table;  ///< how messages call it: "[[body]]"
  std::string meaning;
  std::vector<TomlKey> keys;
  /// What people try, and a sentence that says what does it instead.
  std::vector<std::pair<std::string, std::string>> instead{};
};

/// Throws InputError "FILE:LINE: SENTENCE".
[[noreturn]] void refuse_at(const std::string& file, const toml::node& where,
                            const std::string& sentence);

/// A table read key by key: every value is checked for its type, every mistake names the line, and
/// `finish` refuses the keys that were not read. A number of a key with a unit may be given as a text
/// with one ("5 MPa"). Asking for a key that `keys` does not explain is a mistake of the program
/// (std::logic_error).
class TomlTable {
 public:
  /// `file` and `keys` must outlive it.
  TomlTable(const std::string& file, const toml::table& table, const TomlKeys& keys)
      : file_(file), table_(table), keys_(keys) {}

  bool has(const std::string& key);
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& fallback);
  bool flag(const std::string& key, bool fallback);
  double number(const std::string& key);
  double number(const std::string& key, double fallback);
  double number_in(const std::string& unit,
                   const std::string& key);  ///< of no unit of its own
  Eigen::Vector3d vector(const std::string& key);
  Eigen::Vector3d vector(const std::string& key, const Eigen::Vector3d& fallback);
  std::vector<std::string> texts(const std::string& key);
  std::vector<double> numbers(const std::string& key);
  std::vector<double> numbers_in(const std::string& unit, const std::string& key);
  std::vector<Eigen::Vector3d> vectors(const std::string& key);
  Eigen::Matrix4Xi tetrahedra(const std::string& key);  ///< a list of four whole numbers each
  TomlTable table(const std::string& key, const TomlKeys& keys);
  std::vector<TomlTable> tables(const std::string& key,
                                const TomlKeys& keys);  ///< may be absent
  /// The keys of a table that takes any, each with its value as text.
  std::vector<std::pair<std::string, std::string>> settings(const std::string& key);

  /// Of the file: relative paths in it start here.
  std::filesystem::path folder() const { return std::filesystem::path(file_).parent_path(); }

  bool is_table(const std::string& key);
  bool is_text(const std::string& key);

  std::string place() const;  ///< "FILE:LINE" of the table
  /// "FILE:LINE: SENTENCE", with the key's line (or the table's, when absent).
  std::string at(const std::string& key, const std::string& sentence) const;
  /// Throws InputError with that.
  [[noreturn]] void refuse(const std::string& key, const std::string& sentence) const;
  /// Throws InputError if the table has a key that it cannot have, or one that nobody asked for
  /// because of the others: what has no effect shall not look as if it had.
  void finish() const;

 private:
  const TomlKey& asked(const std::string& key);
  const toml::node& need(const std::string& key);
  double number_of(const toml::node& node, const std::string& key, const std::string& unit) const;
  Eigen::Vector3d vector_of(const toml::node& node, const std::string& key);
  const toml::array& array_of(const std::string& key);

  const std::string& file_;
  const toml::table& table_;
  const TomlKeys& keys_;
  std::set<std::string> asked_;
};

}  // namespace stiction
