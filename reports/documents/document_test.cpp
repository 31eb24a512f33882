// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/documents/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/record/test_message.h"

namespace stiction {
namespace {

FigureTexts figures() {
  FigureRules rules;
  rules.program = "validate";
  for (const char* name : {"drift@old", "drift@quiet", "steps"}) {
    rules.figures.push_back({.name = name, .where = "validate.toml:1"});
  }
  rules.samples.push_back({.name = "sample", .where = "validate.toml:7"});
  rules.columns["drift"] = {"old", "quiet"};
  KeptFigures kept;
  kept.environment = {"4f2a9c1", "g++ 12", "Example CPU", "2026-01-01"};
  kept.figures = {{"drift@old", {0.5, 0.5}}, {"drift@quiet", {1e-9, 1e-9}}, {"steps", {7, 205}}};
  kept.samples = {{"sample", "one\ntwo\n"}};
  FigureTexts texts;
  texts.add(rules, kept);
  return texts;
}

std::string no_templates(const std::string& name) {
  throw std::runtime_error("there is no " + name + ".md");
}

TEST(Document, FillsTablesAndFiguresAndLeavesTheRest) {
  const Templates templates = [](const std::string& name) {
    EXPECT_EQ(name, "who-holds");
    return std::string("| a | b |\n| {{drift@*}} |\n{{sample}}\n");
  };
  const std::string document =
      "before\n<!-- table: who-holds -->\nstale\n<!-- /table -->\n"
      "in <!-- v:steps -->9<!-- /v --> steps at <!-- v:validate:revision --><!-- /v -->\n";
  const std::string expected =
      "before\n<!-- table: who-holds -->\n| a | b |\n| 0.5 | 1e-9 |\none\ntwo\n<!-- /table -->\n"
      "in <!-- v:steps -->7 to 205<!-- /v --> steps at <!-- v:validate:revision -->4f2a9c1<!-- /v "
      "-->\n";
  const FigureTexts texts = figures();
  EXPECT_EQ(written(document, "README.md", texts, templates), expected);
  EXPECT_EQ(written(expected, "README.md", texts, templates), expected);
  EXPECT_TRUE(texts.unused().empty());
}

TEST(Document, WithoutMarkersStaysAsItIs) {
  EXPECT_FALSE(has_markers("# Title\n"));
  EXPECT_EQ(written("# Title\n", "README.md", figures(), no_templates), "# Title\n");
}

TEST(Document, RefusesWhatItDoesNotKnow) {
  const auto message = [](const std::string& document) {
    return test::message_of([&] { written(document, "README.md", figures(), no_templates); });
  };
  EXPECT_EQ(message("\n<!-- v:speed --><!-- /v -->"), "README.md:2: there is no figure 'speed'");
  EXPECT_EQ(message("<!-- table: gone -->\n<!-- /table -->"), "README.md:1: there is no gone.md");
  EXPECT_EQ(message("<!-- v:steps -->7"), "README.md:1: a marker without its <!-- /v -->");
  EXPECT_EQ(message("<!-- v:steps -->7 <!-- v:steps -->7<!-- /v -->"),
            "README.md:1: a marker without its <!-- /v -->");
}

TEST(Document, NamesThePlaceInATemplate) {
  const auto message = [](const std::string& content) {
    return test::message_of([&] {
      written("<!-- table: t -->\n<!-- /table -->", "README.md", figures(),
              [&](const std::string&) { return content; });
    });
  };
  EXPECT_EQ(message("| a |\n| {{speed}} |"), "README.md:1: t.md:2: there is no figure 'speed'");
  EXPECT_EQ(message("{{steps"), "README.md:1: t.md:1: '{{' without '}}'");
}

TEST(FigureTexts, KnowWhichAreUsedNowhere) {
  const FigureTexts texts = figures();
  texts.of("drift@*");
  EXPECT_THAT(texts.unused(), testing::ElementsAre("sample", "steps"));
}

TEST(FigureTexts, RefuseAFigureThatWasNeverMeasured) {
  FigureRules rules;
  rules.program = "compare";
  rules.figures.push_back({.name = "creep", .where = "compare.toml:4"});
  FigureTexts texts;
  EXPECT_EQ(test::message_of([&] { texts.add(rules, {}); }),
            "compare.toml:4: figure 'creep' is not in reports/documents/figures/compare.json: "
            "./stiction readme --update RUN adds it from a run");
}

}  // namespace
}  // namespace stiction
