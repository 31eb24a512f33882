// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/vary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "validation/core/digest.h"
#include "validation/user/problem_keys.h"
#include "validation/user/quantity.h"

namespace stiction {

namespace {

// A number of the file, a vector or keyframes of them: where it stands in its tables, and its unit.
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

// The only table of a list whose `key` is this text.
toml::table* only_in(toml::table& root, const char* list, const char* key,
                     const std::string& text) {
  toml::array* const all = root[list].as_array();
  if (all == nullptr) return nullptr;
  toml::table* only = nullptr;
  for (toml::node& one : *all) {
    toml::table* const table = one.as_table();
    if (table == nullptr || (*table)[key].value<std::string>() != text) continue;
    if (only != nullptr) return nullptr;
    only = table;
  }
  return only;
}

// Of an obstacle, a body, or the load on a body.
std::optional<Place> place_of(toml::table& root, const std::string& name, const std::string& key) {
  auto* const obstacle = only_in(root, "obstacle", "name", name);
  auto* const body = only_in(root, "body", "name", name);
  if (obstacle != nullptr && body != nullptr) return std::nullopt;  // which of them?
  if (obstacle != nullptr) return known_place(obstacle, problem_keys::obstacle(), key);
  if (key != "force" && key != "couple") return known_place(body, problem_keys::body(), key);
  auto* const load = body != nullptr ? only_in(root, "load", "body", name) : nullptr;
  return known_place(load, problem_keys::load(), key);
}

// "duration", "drag.rate", "engine.dt", "ramp.slope_deg", "table.motion.frequency": names may hold
// points, keys none.
std::optional<Place> find_place(toml::table& root, const std::string& what) {
  const std::size_t point = what.rfind('.');
  if (point == std::string::npos) return known_place(&root, problem_keys::file(), what);
  const std::string name = what.substr(0, point), key = what.substr(point + 1);
  if (name == "engine" && !key.empty()) {
    return Place{&root.insert("engine", toml::table{}).first->second.ref<toml::table>(), key, ""};
  }
  if (name == "drag") return known_place(root["drag"].as_table(), problem_keys::drag(), key);
  if (name == "gravity")
    return known_place(root["gravity"].as_table(), problem_keys::gravity(), key);
  if (const std::optional<Place> found = place_of(root, name, key)) return found;
  // In a table of its own: NAME.motion.KEY, NAME.force.KEY.
  const std::size_t before = name.rfind('.');
  if (before == std::string::npos) return std::nullopt;
  const std::string inner = name.substr(before + 1);
  for (const TomlKeys* const keys :
       {&problem_keys::motion(), &problem_keys::force(), &problem_keys::couple()}) {
    const std::optional<Place> outer = place_of(root, name.substr(0, before), inner);
    if (!outer || keys->table != "[" + inner + "]") continue;
    return known_place((*outer->table)[inner].as_table(), *keys, key);
  }
  return std::nullopt;
}

using Vectors = std::vector<Eigen::Vector3d>;

std::optional<Eigen::Vector3d> vector_in(const toml::node& node, const std::string& unit) {
  const toml::array* const array = node.as_array();
  if (array == nullptr || array->size() != 3) return std::nullopt;
  Eigen::Vector3d vector;
  for (int k = 0; k < 3; ++k) {
    const toml::node& one = *array->get(static_cast<std::size_t>(k));
    const std::optional<double> value =
        one.is_string() ? quantity_in(unit, one.as_string()->get()) : one.value<double>();
    if (!value || !std::isfinite(*value)) return std::nullopt;
    vector[k] = *value;
  }
  return vector;
}

// A vector, or those of keyframes; empty where no length of them can vary: places have none, nor
// have edges, nor times.
Vectors vectors_in(const toml::node& node, const Place& place) {
  if (!node.is_array() || place.unit == "s") return {};
  Vectors all;
  if (const auto one = vector_in(node, place.unit)) {
    if (place.unit == "m" && place.key != "amplitude") return {};
    all = {*one};
  } else {
    for (const toml::node& inner : *node.as_array()) {
      const auto vector = vector_in(inner, place.unit);
      if (!vector) return {};
      all.push_back(*vector);
    }
  }
  const bool zero =
      std::all_of(all.begin(), all.end(), [](const auto& v) { return v.isZero(0.0); });
  return zero ? Vectors{} : all;
}

// Whether a value can take its place.
bool varies(const Place& place) {
  const toml::node* const now = place.table->get(place.key);
  return now != nullptr &&
         (now->is_number() || now->is_string() || !vectors_in(*now, place).empty());
}

// Of a key that there is, for people.
std::string why_not(const Place& place) {
  if (place.table->get(place.key) == nullptr) return ": the file does not give it";
  if (place.table->get(place.key)->is_table()) return ": it is a table, whose keys can";
  return ": it is no number, and no vector with a length";
}

void set(const Place& place, double value) {
  const toml::node* const now = place.table->get(place.key);
  const Vectors vectors = now != nullptr ? vectors_in(*now, place) : Vectors{};
  if (vectors.empty()) {
    place.table->insert_or_assign(place.key, value);
    return;
  }
  double longest = 0.0;
  for (const Eigen::Vector3d& one : vectors) longest = std::max(longest, one.stableNorm());
  toml::array scaled;
  for (const Eigen::Vector3d& one : vectors) {
    const Eigen::Vector3d v = one / longest * value;
    scaled.push_back(toml::array{v.x(), v.y(), v.z()});
  }
  if (now->as_array()->get(0)->is_array()) {
    place.table->insert_or_assign(place.key, std::move(scaled));
  } else {
    place.table->insert_or_assign(place.key, std::move(*scaled.get(0)->as_array()));
  }
}

}  // namespace

std::string surface_words(const ParsedFile& problem) {
  std::string words;
  const toml::array* const bodies = problem.root["body"].as_array();
  if (bodies == nullptr) return words;
  for (const toml::node& one : *bodies) {
    const toml::table* const body = one.as_table();
    const auto file = body != nullptr ? (*body)["file"].value<std::string>() : std::nullopt;
    if (!file) continue;
    const auto path = std::filesystem::path(problem.file).parent_path() / *file;
    words += *file + " " + hash_of_file(path) + "\n";
  }
  return words;
}

void set_value(toml::table& root, const std::string& what, double value) {
  set(*find_place(root, what), value);
}

UserVariation read_variation(TomlTable& table, const std::shared_ptr<const ParsedFile>& parsed) {
  const std::string what = table.text("vary");
  toml::table copy = parsed->root;
  const std::optional<Place> place = find_place(copy, what);
  // Settings of an engine have values of their own.
  const bool setting = place && what.starts_with("engine.") && !place->table->contains(place->key);
  if (!setting && !(place && varies(*place))) {
    table.refuse("vary", fmt::format("'{}' cannot vary{}; it is to be {}", what,
                                     place ? why_not(*place) : "", problem_keys::kVaries));
  }
  const std::string unit = place->unit;
  return {what, unit, [parsed, what, unit](double value) {
            toml::table root = parsed->root;
            set_value(root, what, value);
            try {
              return read_parsed(parsed->file, root);
            } catch (const NotMeshed&) {
              throw;
            } catch (const InputError& error) {
              throw InputError("at " + value_text(what, unit, value) + ": " + error.what());
            }
          }};
}

}  // namespace stiction
