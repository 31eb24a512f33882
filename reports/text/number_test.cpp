// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/number.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "reports/record/test_records.h"

namespace stiction {
namespace {

TEST(Number, SignificantDigits) {
  EXPECT_EQ(format_value(0.30001234), "0.300012");
  EXPECT_EQ(format_value(-1.234567e-5), "-1.23457e-05");
  EXPECT_EQ(format_value(300000.0), "300000");
  EXPECT_EQ(format_error(-1.249e-5), "-1.2e-05");
  EXPECT_EQ(format_error(0.033), "0.033");
  EXPECT_EQ(format_digits(4.44), "4.4");
}

TEST(Number, OfTables) {
  EXPECT_EQ(spaced_count(999), "999");
  EXPECT_EQ(spaced_count(1234567), "1 234 567");
  EXPECT_EQ(format_nanoseconds(9.94), "9.9");
  EXPECT_EQ(format_nanoseconds(9.96), "10");
  EXPECT_EQ(format_nanoseconds(1234.5), "1234");
}

TEST(Number, WhatIsNoPlainNumber) {
  for (const auto format :
       {format_value, format_error, format_digits, format_seconds, format_exact}) {
    EXPECT_EQ(format(test::kNan), "nan");
    EXPECT_EQ(format(-test::kNan), "nan");
    EXPECT_EQ(format(test::kInf), "inf");
    EXPECT_EQ(format(-test::kInf), "-inf");
  }
  EXPECT_EQ(format_value(-0.0), "0");
  EXPECT_EQ(format_error(-0.0), "0");
}

TEST(Number, Seconds) {
  EXPECT_EQ(format_seconds(0.0), "0");
  EXPECT_EQ(format_seconds(0.0123456), "0.0123");
  EXPECT_EQ(format_seconds(12.345), "12.3");
  EXPECT_EQ(format_seconds(999.4), "999");
  EXPECT_EQ(format_seconds(123456.7), "123457");
}

TEST(Number, Counts) {
  EXPECT_EQ(format_count(0), "0");
  EXPECT_EQ(format_count(999), "999");
  EXPECT_EQ(format_count(1000), "1,000");
  EXPECT_EQ(format_count(123456), "123,456");
  EXPECT_EQ(format_count(std::numeric_limits<std::uint64_t>::max()), "18,446,744,073,709,551,615");
}

TEST(Number, ExactReadsBack) {
  for (const double value : {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, -2.5, 1e22}) {
    EXPECT_EQ(std::strtod(format_exact(value).c_str(), nullptr), value);
  }
  EXPECT_EQ(format_exact(0.1), "0.1");
}

TEST(Number, Units) {
  EXPECT_EQ(with_unit("2", "m/s"), "2 m/s");
  EXPECT_EQ(with_unit("2", "1"), "2");
  EXPECT_EQ(with_unit("2", ""), "2");
}

}  // namespace
}  // namespace stiction
