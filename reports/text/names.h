// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace stiction {

/// "a, b, c" of what a container holds; `name_of` gives each one's name. For sentences that tell
/// what there is.
template <typename Container, typename NameOf>
std::string listed_names(const Container& all, NameOf name_of) {
  std::string list;
  for (const auto& one : all) {
    if (!list.empty()) list += ", ";
    list += name_of(one);
  }
  return list;
}

template <typename Container>
std::string listed_names(const Container& names) {
  return listed_names(names, [](const auto& name) { return name; });
}

}  // namespace stiction
