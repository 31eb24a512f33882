// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/features.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace stiction::bench {
namespace {

// STICTION_FEATURES: their names, from solver/CMakeLists.txt.
TEST(OptionalFeatures, AreAllThatTheSolverCanLeaveOut) {
  std::vector<std::string> listed, measured;
  std::istringstream names(STICTION_FEATURES);
  for (std::string name; names >> name;) listed.push_back(name);
  for (const OptionalFeature& feature : optional_features()) measured.push_back(feature.name);
  EXPECT_FALSE(listed.empty());
  EXPECT_THAT(measured, testing::UnorderedElementsAreArray(listed));
}

}  // namespace
}  // namespace stiction::bench
