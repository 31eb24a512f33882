// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/documents/figure_rule.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "reports/record/test_message.h"

namespace stiction {
namespace {

class FigureRuleFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  FigureRules read(const std::string& content) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "validate.toml") << content;
    return read_figure_rules(folder_ / "validate.toml");
  }
  std::string refusal(const std::string& content) {
    return test::message_of([&] { read(content); });
  }

 private:
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(FigureRuleFile, HasAFigureAColumn) {
  const FigureRules rules = read(R"(
[columns]
old = {method = "old"}
quiet = {method = "quiet"}
[figure.drift]
case = "slab/rest"
quantity = "drift"
each = ["quiet", "old"]
settings = {dt = "1e-4"}
above = {"0.01" = "slips"}
within = "most"
)");
  EXPECT_EQ(rules.program, "validate");
  ASSERT_EQ(rules.figures.size(), 2u);
  EXPECT_EQ(rules.figures[0].name, "drift@quiet");
  EXPECT_EQ(rules.figures[0].settings.at("method"), "quiet");
  EXPECT_EQ(rules.figures[0].settings.at("dt"), "1e-4");
  EXPECT_EQ(rules.figures[0].within, Taken::kMost);
  EXPECT_EQ(rules.figures[0].style.above.at(0.01), "slips");
  EXPECT_EQ(rules.columns.at("drift"), (std::vector<std::string>{"quiet", "old"}));
}

TEST_F(FigureRuleFile, HasAFigureAPlaceInASeries) {
  const FigureRules rules = read(R"(
[figure.step]
case = "bench/slab/scaling"
series = "step per contact"
at = [100, 1e6]
[figure.one]
case = "bench/slab/scaling"
series = "step per contact"
at = 1000
)");
  ASSERT_EQ(rules.figures.size(), 3u);
  EXPECT_EQ(rules.figures[0].name, "one");
  EXPECT_EQ(rules.figures[0].at, 1000.0);
  EXPECT_EQ(rules.figures[1].name, "step@100");
  EXPECT_EQ(rules.figures[2].name, "step@1000000");
  EXPECT_EQ(rules.figures[2].at, 1e6);
  EXPECT_EQ(rules.columns.at("step"), (std::vector<std::string>{"100", "1000000"}));
}

TEST_F(FigureRuleFile, RefusesWithTheLine) {
  EXPECT_EQ(refusal("[figure.step]\ncase = \"a\"\nseries = \"s\"\n"),
            "validate.toml:1: 'step' needs 'at' with a series, and with nothing else");
  EXPECT_EQ(refusal("[figure.step]\ncase = \"a\"\nquantity = \"q\"\nat = 1\n"),
            "validate.toml:1: 'step' needs 'at' with a series, and with nothing else");
  EXPECT_EQ(refusal("[figure.step]\ncase = \"a\"\nseries = \"s\"\nat = [1, \"x\"]\n"),
            "validate.toml:4: 'at' is a number or a list of numbers");
  EXPECT_EQ(refusal("[columns]\nc = {}\n[figure.step]\ncase = \"a\"\nseries = \"s\"\nat = [1, 2]\n"
                    "each = [\"c\"]\n"),
            "validate.toml:3: 'step' has columns by 'at' and by 'each'");
  EXPECT_EQ(refusal("[figure.drift]\nquantity = \"drift\"\n"),
            "validate.toml:1: 'drift' names no case");
  EXPECT_EQ(refusal("[figure.drift]\ncase = \"a\"\n"),
            "validate.toml:1: 'drift' names either a quantity or a series");
  EXPECT_EQ(refusal("[figure.drift]\ncase = \"a\"\nquantity = \"d\"\nfaktor = 2\n"),
            "validate.toml:4: there is no key 'faktor' here");
  EXPECT_EQ(refusal("[figure.drift]\ncase = 7\n"),
            "validate.toml:2: 'case' has a value of another kind");
  EXPECT_EQ(refusal("[figure.drift]\ncase = \"a\"\nquantity = \"d\"\nover = \"best\"\n"),
            "validate.toml:4: 'over' is one of least, most, range, count, not 'best'");
  EXPECT_EQ(refusal("[figure.drift]\ncase = \"a\"\nquantity = \"d\"\neach = [\"old\"]\n"),
            "validate.toml:1: [columns] has no 'old'");
  EXPECT_EQ(refusal("[figure.drift]\ncase = \"a\"\nquantity = \"d\"\nabove = {much = \"x\"}\n"),
            "validate.toml:4: 'above' is a table of words, {\"0.01\" = \"slips\"}");
  EXPECT_EQ(refusal("[figures.drift]\ncase = \"a\"\n"),
            "validate.toml:1: there is no key 'figures' here");
  EXPECT_EQ(refusal("[figure").substr(0, 16), "validate.toml:1:");
}

}  // namespace
}  // namespace stiction
