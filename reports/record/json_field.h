// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reports/text/text.h"

namespace stiction {

/// A JSON value together with the way to it, so that every complaint names its place: each function
/// throws std::runtime_error "<where>: <path>: <what is wrong>" when the value is of another type.
/// The JSON must outlive it.
class JsonField {
 public:
  JsonField(const nlohmann::json& json, std::string where, std::string path)
      : json_(&json), where_(std::move(where)), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& message) const {
    // Of keys and words of the JSON, which may hold anything.
    throw std::runtime_error(one_line(path_.empty()
                                          ? fmt::format("{}: {}", where_, message)
                                          : fmt::format("{}: {}: {}", where_, path_, message)));
  }

  bool has(const char* name) const { return json_->contains(name); }

  JsonField operator[](const char* name) const {
    if (!json_->is_object()) expected("an object");
    const JsonField field(has(name) ? json_->at(name) : *json_, where_,
                          path_.empty() ? name : path_ + "." + name);
    if (!has(name)) field.fail("the required field is missing");
    return field;
  }

  std::string text() const {
    if (!json_->is_string()) expected("a string");
    return json_->get<std::string>();
  }

  bool boolean() const {
    if (!json_->is_boolean()) expected("true or false");
    return json_->get<bool>();
  }

  std::uint64_t count() const {
    if (!json_->is_number_unsigned()) expected("a whole number from 0 to 2^64 − 1");
    return json_->get<std::uint64_t>();
  }

  // An object that nobody looks into, as one line of JSON.
  std::string object_text() const {
    if (!json_->is_object()) expected("an object");
    return json_->dump();
  }

  double real() const {
    if (json_->is_number()) return json_->get<double>();
    if (json_->is_string()) {
      const auto& word = json_->get_ref<const std::string&>();
      if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
      if (word == "inf") return std::numeric_limits<double>::infinity();
      if (word == "-inf") return -std::numeric_limits<double>::infinity();
    }
    expected("a number, \"nan\", \"inf\" or \"-inf\"");
  }

  // Of a field that may be missing.
  std::string optional_text(const char* name) const {
    return has(name) ? (*this)[name].text() : std::string();
  }
  std::optional<double> optional_real(const char* name) const {
    return has(name) ? std::optional((*this)[name].real()) : std::nullopt;
  }

  template <typename Read>
  auto list(Read read) const {
    if (!json_->is_array()) expected("a list");
    std::vector<decltype(read(*this))> elements;
    elements.reserve(json_->size());
    for (std::size_t i = 0; i < json_->size(); ++i) {
      elements.push_back(read(JsonField((*json_)[i], where_, fmt::format("{}[{}]", path_, i))));
    }
    return elements;
  }

  template <typename Read>
  auto map(Read read) const {
    if (!json_->is_object()) expected("an object");
    std::map<std::string, decltype(read(*this))> entries;
    for (const auto& [key, value] : json_->items()) {
      entries.emplace(key, read(JsonField(value, where_, path_ + "." + key)));
    }
    return entries;
  }

  // A word of an enumeration.
  template <typename Parse>
  auto word(Parse parse) const {
    const auto value = parse(text());
    if (!value) fail("unknown word \"" + text() + "\"");
    return *value;
  }

 private:
  [[noreturn]] void expected(const std::string& what) const {
    fail(fmt::format("expected {}, found {}", what,
                     json_->is_number() ? json_->dump() : json_->type_name()));
  }

  const nlohmann::json* json_;
  std::string where_;
  std::string path_;
};

}  // namespace stiction
