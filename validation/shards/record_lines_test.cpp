// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/record_lines.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

TEST(RunFolders, AreLaterByTheirTimeAndThenByTheirNumber) {
  const char* const in_order[] = {"b/2026-01-01T00-00-01Z",    "a/2026-01-01T00-00-02Z",
                                  "c/2026-01-01T00-00-02Z-2",  "a/2026-01-01T00-00-02Z-9",
                                  "a/2026-01-01T00-00-02Z-11", "a/2026-01-01T00-00-10Z"};
  for (std::size_t k = 0; k < std::size(in_order); ++k) {
    for (std::size_t other = 0; other < std::size(in_order); ++other) {
      EXPECT_EQ(is_later(in_order[k], in_order[other]), k > other)
          << in_order[k] << ", " << in_order[other];
    }
  }
}

}  // namespace
}  // namespace stiction
