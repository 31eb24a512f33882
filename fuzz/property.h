// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

namespace stiction::fuzz {

/// Ends the process where a property doesn't hold, whatever the build: a counterexample for
/// libFuzzer and for ctest.
inline void hold(bool holds, const std::string& property) {
  if (holds) return;
  std::fprintf(stderr, "the property doesn't hold: %s\n", property.c_str());
  std::abort();
}

/// What `read` reads; nothing where it throws a `Refusal`, which must be one sentence in one line.
/// Any other exception is a counterexample.
template <class Refusal, class Read>
auto value_or_sentence(Read read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const Refusal& refusal) {
    const std::string sentence = refusal.what();
    hold(!sentence.empty() && sentence.find_first_of("\r\n") == std::string::npos,
         "a refusal is one line: " + sentence);
    return std::nullopt;
  }
}

}  // namespace stiction::fuzz
