// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace stiction::fuzz {

/// Takes values off the front of an input; zeros once it is used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }

  template <class Value>
  Value take() {
    Value value{};
    const std::size_t count = std::min(size_, sizeof value);
    std::memcpy(&value, data_, count);
    data_ += count;
    size_ -= count;
    return value;
  }

  std::uint8_t byte() { return take<std::uint8_t>(); }
  bool coin() { return byte() % 2 == 1; }

  /// Mostly a plain number of few digits, so that what is meant to be sound often is; else any
  /// double at all.
  double number() {
    const std::uint8_t kind = byte();
    if (kind >= 250) return take<double>();
    return static_cast<double>(take<std::int16_t>()) / (kind % 2 == 0 ? 64.0 : 1024.0);
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace stiction::fuzz
