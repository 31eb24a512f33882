// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/quantity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace stiction {
namespace {

using testing::Optional;

TEST(Quantity, IsTheNumberInTheUnitAskedFor) {
  EXPECT_THAT(quantity_in("Pa", "5 MPa"), Optional(5e6));
  EXPECT_THAT(quantity_in("m", "3 mm"), Optional(0.003));
  EXPECT_THAT(quantity_in("m", "-7mm"), Optional(-0.007));
  EXPECT_THAT(quantity_in("m", " +1.5e2 um "), Optional(150e-6));
  EXPECT_THAT(quantity_in("deg", "20 deg"), Optional(20.0));
  EXPECT_THAT(quantity_in("deg", "20°"), Optional(20.0));
  EXPECT_THAT(quantity_in("rad/s", "30 rpm"), Optional(testing::DoubleEq(std::numbers::pi)));
  EXPECT_THAT(quantity_in("Hz", "60 rpm"), Optional(1.0));
  EXPECT_THAT(quantity_in("m/s", "36 km/h"), Optional(10.0));
  EXPECT_THAT(quantity_in("N m", "2 N mm"), Optional(0.002));
  EXPECT_THAT(quantity_in("1", "30 %"), Optional(0.3));
}

TEST(Quantity, OfAnotherKindOrOfNoneIsNone) {
  for (const char* text : {"", "5", "mm", "5 MPa", "5 Mm", "5 mm mm", "nan mm", "inf mm",
                           "1e400 mm", "0x5 mm", "5,3 mm", "5 mm\n", "1e308 km"}) {
    EXPECT_FALSE(quantity_in("m", text)) << text;
  }
}

TEST(Quantity, TellsWhichUnitsItTakes) {
  EXPECT_THAT(units_like("kg"), testing::ElementsAre("kg", "g", "mg", "t"));
  EXPECT_TRUE(units_like("furlong").empty());
}

}  // namespace
}  // namespace stiction
