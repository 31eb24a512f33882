// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/vary.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "validation/user/problem_keys.h"

namespace stiction {

namespace {

// A number of the file: where it stands in its tables, and its unit.
struct Place {
  toml::table* table = nullptr;
  std::string key;
  std::string unit;
};

std::optional<Place> known_place(toml::table* table, const TomlKeys& keys, const std::string& key) {
  const auto known = std::find_if(keys.keys.begin(), keys.keys.end(),
                                  [&](const TomlKey& one) { return one.name == key; });
  if (table == nullptr || known == keys.keys.end() || known->unit.empty()) return std::nullopt;
  return Place{table, key, known->unit};
}

toml::table* named_in(toml::table& root, const char* list, const std::string& name) {
  toml::array* const all = root[list].as_array();
  if (all == nullptr) return nullptr;
  for (toml::node& one : *all) {
    toml::table* const table = one.as_table();
    if (table != nullptr && (*table)["name"].value<std::string>() == name) return table;
  }
  return nullptr;
}

// "duration", "drag.rate", "engine.dt", "ramp.slope_deg": names may hold points, keys none.
std::optional<Place> find_place(toml::table& root, const std::string& what) {
  const std::size_t point = what.rfind('.');
  if (point == std::string::npos) return known_place(&root, problem_keys::file(), what);
  const std::string name = what.substr(0, point), key = what.substr(point + 1);
  if (name == "engine" && !key.empty()) {
    return Place{&root.insert("engine", toml::table{}).first->second.ref<toml::table>(), key, ""};
  }
  if (name == "drag") return known_place(root["drag"].as_table(), problem_keys::drag(), key);
  if (auto* const obstacle = named_in(root, "obstacle", name)) {
    return known_place(obstacle, problem_keys::obstacle(), key);
  }
  return known_place(named_in(root, "body", name), problem_keys::body(), key);
}

}  // namespace

UserVariation read_variation(TomlTable& table, const std::shared_ptr<const ParsedFile>& parsed) {
  const std::string what = table.text("vary");
  toml::table copy = parsed->root;
  const std::optional<Place> place = find_place(copy, what);
  const toml::node* const now = place ? place->table->get(place->key) : nullptr;
  const bool given = now != nullptr && (now->is_number() || now->is_string());
  // Settings of an engine have values of their own.
  if (!given && !(now == nullptr && what.starts_with("engine.") && place)) {
    table.refuse("vary", fmt::format("'{}' is no number of this file; it is to be KEY, drag.KEY, "
                                     "engine.KEY, or NAME.KEY of an obstacle or body",
                                     what));
  }
  return {what, place->unit, [parsed, what](double value) {
            toml::table root = parsed->root;
            const Place there = *find_place(root, what);
            there.table->insert_or_assign(there.key, value);
            return read_parsed(parsed->file, root);
          }};
}

}  // namespace stiction
