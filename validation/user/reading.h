// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numbers>
#include <string>
#include <unordered_map>
#include <vector>

#include "validation/user/toml_reader.h"
#include "validation/user/user_problem.h"

namespace stiction {

inline constexpr double kDegree = std::numbers::pi / 180.0;  ///< rad

/// The names of things of one kind, in the order of the file.
class Names {
 public:
  /// The next one, from the table's `name`; refuses one that is taken or not a line of text.
  std::string add(TomlTable& table);
  /// The number of the one that the key names; refuses others, telling those that there are. `what`
  /// they are: "body".
  std::size_t find(TomlTable& table, const std::string& key, const std::string& what) const;
  /// None: it is not there.
  const std::size_t* find(const std::string& name) const;
  std::string listed() const;

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> numbers_;
};

/// A problem while it is read.
struct Reading {
  UserProblem user{};
  Names obstacles{}, bodies{};
};

/// The obstacle, or the body read before it, that the key names; refuses others, and names of both.
Partner find_partner(TomlTable& table, const std::string& key, const Reading& reading);

/// Refuses the key where the body is a point, which does not turn.
void refuse_point(TomlTable& table, const Reading& reading, const std::string& key,
                  std::size_t body);

/// The table's `friction`; refuses a negative one.
double read_friction(TomlTable& table);

/// A vector's direction, unit; refuses zero.
Eigen::Vector3d read_direction(TomlTable& table, const std::string& key);

// Each adds what a table describes to what was read before it, and throws InputError with file and
// line.

void read_obstacle(TomlTable table, Reading& reading);
/// Throws NotMeshed where the mesher fails.
void read_body(TomlTable table, Reading& reading);
void read_load(TomlTable table, Reading& reading);
void read_spring(TomlTable table, Reading& reading);
void read_pair(TomlTable table, Reading& reading);
void read_check(TomlTable table, Reading& reading);
void read_series(TomlTable table, Reading& reading);
/// Gives checks and series that are called the same names of their own: of their bodies, windows,
/// numbers.
void name_apart(UserProblem& user);

}  // namespace stiction
