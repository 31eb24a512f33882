// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/trend_records.h"

#include <gtest/gtest.h>

namespace stiction::track {
namespace {

TEST(TrendRecords, OneASubjectWithASeriesAMetric) {
  const std::vector<Trend> trends = {
      {{"a", "digits: creep", "1", Kind::kDigits}, {1, 4}, {5.0, 4.0}},
      {{"a", "time", "s", Kind::kTime}, {1, 4, 5}, {2e-8, 3e-8, 4e-8}},
      {{"b", "time", "s", Kind::kTime}, {5}, {1e-9}}};
  const std::vector<Record> records = trend_records(trends, {});
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].case_name, "trend/a");
  EXPECT_EQ(records[1].case_name, "trend/b");
  ASSERT_EQ(records[0].series.size(), 2u);
  const Series& time = records[0].series[1];
  EXPECT_EQ(time.unit, "ns");
  EXPECT_EQ(time.x_name, "run");
  EXPECT_EQ(time.x, (std::vector<double>{1.0, 4.0, 5.0}));
  ASSERT_EQ(time.y.size(), 3u);
  EXPECT_DOUBLE_EQ(time.y[2], 40.0);
  EXPECT_EQ(records[0].series[0].y, (std::vector<double>{5.0, 4.0}));
  EXPECT_EQ(records[0].notes,
            (std::vector<std::string>{"digits: creep: higher is better", "time: lower is better"}));
}

}  // namespace
}  // namespace stiction::track
