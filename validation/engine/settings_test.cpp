// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/settings.h"

#include <gtest/gtest.h>

#include "solver/testing/test_refusal.h"

namespace stiction {
namespace {

using test::refusal;

TEST(SettingsReader, GivesWhatIsSetAndElseTheFallback) {
  const Settings settings{{"rule", "none"}, {"dt", "2.5e-4"}, {"cells", "3"}};
  SettingsReader reader(settings);
  EXPECT_EQ(reader.text("rule", "x"), "none");
  EXPECT_EQ(reader.number("dt", 1.0), 2.5e-4);
  EXPECT_EQ(reader.count("cells", 1), 3);
  EXPECT_TRUE(reader.has("dt"));
  EXPECT_FALSE(reader.has("gain"));
  EXPECT_EQ(reader.text("name", "x"), "x");
  EXPECT_EQ(reader.number("gain", 0.7), 0.7);
  EXPECT_EQ(reader.count("sweeps", 0), 0);  // whatever the fallback is
}

class BadNumber : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(BadNumber, IsRefusedInWords) {
  const std::string word = GetParam().second;
  const Settings settings{{"dt", word}};
  SettingsReader reader(settings);
  EXPECT_EQ(refusal([&] { reader.number("dt", 1.0); }),
            "setting 'dt' needs a finite number, not '" + word + "'");
}

INSTANTIATE_TEST_SUITE_P(Words, BadNumber,
                         testing::Values(std::pair{"Empty", ""}, std::pair{"Word", "fast"},
                                         std::pair{"Unit", "1e-4 s"}, std::pair{"Comma", "0,1"},
                                         std::pair{"NaN", "nan"}, std::pair{"Inf", "inf"},
                                         std::pair{"Overflow", "1e999"},
                                         std::pair{"LeadingSpace", " 1"}),
                         [](const auto& one) { return one.param.first; });

TEST(SettingsReader, WantsWholeNumbersOfAtLeastOneAsCounts) {
  for (const std::string word : {"0", "-1", "2.5", "1e7"}) {
    const Settings settings{{"cells", word}};
    SettingsReader reader(settings);
    EXPECT_EQ(refusal([&] { reader.count("cells", 2); }),
              "setting 'cells' needs a whole number from 1 to 1000000, not '" + word + "'");
  }
}

TEST(SettingsReader, RefusesASettingThatNobodyAskedForAndNamesTheKnownOnes) {
  const Settings settings{{"dt", "1"}, {"sped", "2"}};
  SettingsReader reader(settings);
  reader.number("dt", 1.0);
  reader.text("rule", "none");
  EXPECT_EQ(refusal([&] { reader.refuse_unknown("stiction"); }),
            "engine 'stiction' has no setting 'sped'; there are: dt, rule");
  reader.has("sped");
  EXPECT_EQ(refusal([&] { reader.refuse_unknown("stiction"); }), "");
}

}  // namespace
}  // namespace stiction
