// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/digest.h"

#include <fmt/format.h>

#include <fstream>

#include "solver/hash.h"

namespace stiction {

std::string hash_of_words(const std::string& words) {
  Fnv1a hash;
  hash.add(words.data(), words.size());
  return fmt::format("{:016x}", hash.value());
}

std::string hash_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Fnv1a hash;
  for (char block[1 << 16]; stream.read(block, sizeof block), stream.gcount() > 0;) {
    hash.add(block, static_cast<std::size_t>(stream.gcount()));
  }
  return fmt::format("{:016x}", hash.value());
}

}  // namespace stiction
