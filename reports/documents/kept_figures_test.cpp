// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/documents/kept_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "reports/record/test_message.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

std::filesystem::path file_with(const std::string& content) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) /
      (testing::UnitTest::GetInstance()->current_test_info()->name() + std::string(".json"));
  std::ofstream(file) << content;
  return file;
}

TEST(KeptFigures, ReadBackAsTheyWere) {
  KeptFigures kept;
  kept.environment = {"4f2a9c1+", "g++ 12", "Example \"CPU\"", "2026-01-01"};
  kept.figures = {{"a", {0.1, 0.1, Verdict::kPass}},
                  {"b", {7.0, test::kInf, Verdict::kForInformation}},
                  {"c", {test::kNan, test::kNan, Verdict::kShortfall}}};
  kept.samples = {{"sample", "one\n  μ \"two\"\n"}};
  const KeptFigures back = read_kept_figures(file_with(to_json(kept)));
  EXPECT_EQ(to_json(back), to_json(kept));
  EXPECT_EQ(back.figures.at("a").low, 0.1);
  EXPECT_EQ(back.figures.at("b").high, test::kInf);
  EXPECT_TRUE(std::isnan(back.figures.at("c").low));
  EXPECT_EQ(back.figures.at("c").verdict, Verdict::kShortfall);
  EXPECT_EQ(back.samples.at("sample"), "one\n  μ \"two\"\n");
}

TEST(KeptFigures, SayWhyAFileIsNone) {
  EXPECT_THAT(test::message_of([] { read_kept_figures("/nowhere/kept.json"); }),
              testing::HasSubstr("is missing: ./stiction readme --update RUN makes it"));
  EXPECT_THAT(test::message_of([] { read_kept_figures(file_with("{")); }),
              testing::HasSubstr("is no file of figures:"));
  EXPECT_THAT(test::message_of([] { read_kept_figures(file_with("{\"run\": {}}")); }),
              testing::HasSubstr("is no file of figures:"));
}

TEST(KeptFigures, AreThoseOfTheRun) {
  FigureRules rules;
  rules.figures.push_back({.name = "slope", .case_glob = "a", .quantity = "critical slope, tan θ"});
  Record record = test::passing_record("a");
  const KeptFigures kept = figures_of(rules, {{record}});
  EXPECT_EQ(kept.figures.at("slope").low, 0.300012);
  EXPECT_EQ(kept.environment.revision, "4f2a9c1+");
  EXPECT_TRUE(disagreements(rules, kept, figures_of(rules, {{record}})).empty());
  record.checks[0].verdict = Verdict::kFail;
  EXPECT_THAT(disagreements(rules, kept, figures_of(rules, {{record}})),
              testing::ElementsAre(testing::HasSubstr("'slope' is now fail")));
  EXPECT_THAT(disagreements(rules, {}, kept), testing::ElementsAre("'slope' has no kept figure"));
}

}  // namespace
}  // namespace stiction
