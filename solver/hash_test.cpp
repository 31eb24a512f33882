// SPDX-License-Identifier: BSD-3-Clause
#include "solver/hash.h"

#include <gtest/gtest.h>

#include <string_view>

namespace stiction {
namespace {

std::uint64_t hash_of_text(std::string_view text) {
  Fnv1a hash;
  hash.add(text.data(), text.size());
  return hash.value();
}

// External: the test vectors of the FNV authors (draft-eastlake-fnv, appendix C).
TEST(Fnv1a, GivesThePublishedValues) {
  EXPECT_EQ(hash_of_text(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hash_of_text("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hash_of_text("foobar"), 0x85944171f73967e8u);
}

TEST(Fnv1a, GoesOnWhereItStood) {
  Fnv1a hash;
  hash.add("foo", 3);
  hash.add("bar", 3);
  EXPECT_EQ(hash.value(), hash_of_text("foobar"));
}

}  // namespace
}  // namespace stiction
