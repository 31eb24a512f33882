// SPDX-License-Identifier: BSD-3-Clause
#include "validation/engine/kit/array_json.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace stiction::kit {

namespace {

static_assert(std::endian::native == std::endian::little, "doubles are sent as they stand");

constexpr std::size_t kMostAsNumbers = 48;
constexpr char kSigns[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(const unsigned char* bytes, std::size_t count) {
  std::string text;
  text.reserve((count + 2) / 3 * 4);
  for (std::size_t k = 0; k < count; k += 3) {
    const std::size_t left = count - k;
    const std::uint32_t three = (std::uint32_t{bytes[k]} << 16) |
                                (left > 1 ? std::uint32_t{bytes[k + 1]} << 8 : 0) |
                                (left > 2 ? std::uint32_t{bytes[k + 2]} : 0);
    text += kSigns[three >> 18 & 63];
    text += kSigns[three >> 12 & 63];
    text += left > 1 ? kSigns[three >> 6 & 63] : '=';
    text += left > 2 ? kSigns[three & 63] : '=';
  }
  return text;
}

int value_of(char sign) {
  const char* const found = std::strchr(kSigns, sign);
  return found && sign != '\0' ? static_cast<int>(found - kSigns) : -1;
}

std::string bytes_of(const std::string& text, const std::string& what) {
  if (text.size() % 4 != 0) throw std::runtime_error(what + " is not base64");
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t k = 0; k < text.size(); k += 4) {
    std::size_t padding = 0;
    if (k + 4 == text.size()) {
      while (padding < 2 && text[k + 3 - padding] == '=') ++padding;
    }
    std::uint32_t four = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const int value = i + padding >= 4 ? 0 : value_of(text[k + i]);
      if (value < 0) throw std::runtime_error(what + " is not base64");
      four = four << 6 | static_cast<std::uint32_t>(value);
    }
    for (std::size_t i = 0; i < 3 - padding; ++i) {
      bytes += static_cast<char>(four >> (16 - 8 * i) & 255);
    }
  }
  return bytes;
}

}  // namespace

std::vector<double> read_array(const nlohmann::json& value, const std::string& what) {
  if (value.is_object() && value.contains("f64") && value["f64"].is_string()) {
    const std::string bytes = bytes_of(value["f64"].get<std::string>(), what);
    if (bytes.size() % sizeof(double) != 0) {
      throw std::runtime_error(what + " is not a whole number of doubles");
    }
    std::vector<double> numbers(bytes.size() / sizeof(double));
    if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
  }
  if (!value.is_array()) throw std::runtime_error(what + " is no array of numbers");
  std::vector<double> numbers;
  numbers.reserve(value.size());
  for (const nlohmann::json& one : value) {
    if (one.is_array()) {
      const std::vector<double> inner = read_array(one, what);
      numbers.insert(numbers.end(), inner.begin(), inner.end());
      continue;
    }
    if (!one.is_number()) {
      throw std::runtime_error(what + " has " + one.dump() + " where a number belongs" +
                               (one.is_null() ? ": that stands for NaN or infinity" : ""));
    }
    numbers.push_back(one.get<double>());
  }
  return numbers;
}

std::uint64_t read_count(const nlohmann::json& value, const std::string& what, std::uint64_t most) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most) {
    throw std::runtime_error(what + " is no whole number from 0 to " + std::to_string(most));
  }
  return value.get<std::uint64_t>();
}

nlohmann::json write_array(const double* values, std::size_t count) {
  if (count > kMostAsNumbers) {
    return {
        {"f64", base64(reinterpret_cast<const unsigned char*>(values), count * sizeof(double))}};
  }
  return std::vector<double>(values, values + count);
}

}  // namespace stiction::kit
