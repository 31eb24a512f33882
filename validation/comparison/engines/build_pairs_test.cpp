// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/build_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "validation/comparison/engines/engine_matrix.h"
#include "validation/comparison/engines/engine_summary.h"
#include "validation/comparison/engines/trials.h"

namespace stiction {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// A record of compare engines with a curve: error and CPU time at each effort; NaN: it broke there.
Record answered(const std::string& id, const std::string& engine, const std::string& build_of,
                const std::vector<double>& errors, const std::vector<double>& seconds) {
  Record one;
  one.case_name = "engines/" + id;
  one.engine = engine;
  one.settings = {{"engine", engine}, {"configuration", "quiet"}};
  if (!build_of.empty()) one.settings["build_of"] = build_of;
  one.verdict = Verdict::kForInformation;
  one.series = {{"error", "1", "CPU time", "s", {}, {}}};
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (std::isnan(errors[k])) {
      one.failures.push_back({"crashed", "effort", {static_cast<double>(k)}});
      continue;
    }
    one.series[0].x.push_back(seconds[k]);
    one.series[0].y.push_back(errors[k]);
  }
  if (!std::isnan(errors[0])) {
    one.figures = {{"error", "1", "", errors[0]}, {"CPU time", "s", "", seconds[0]}};
  }
  return one;
}

std::vector<Question> asked(const std::vector<std::string>& ids) {
  std::vector<Question> chosen;
  for (const Question& one : engine_questions()) {
    if (std::find(ids.begin(), ids.end(), one.id) != ids.end()) chosen.push_back(one);
  }
  return chosen;
}

const double kBroke = std::nan("");

std::vector<Record> single_beside_double() {
  return {
      answered("accelerates", "stiction", "", {1e-13, 1e-13, 2e-13}, {0.3, 0.6, 1.2}),
      answered("accelerates", "stiction_single", "stiction", {1e-4, kBroke, 3e-3}, {0.2, 0.0, 1.0}),
      answered("accelerates", "swift", "", {1e-5}, {0.01})};
}

TEST(BuildPairs, SetEachAnswerBesideThatOfTheSameEffort) {
  const auto questions = asked({"accelerates"});
  const auto made = single_beside_double();
  const auto all = build_pairs(EngineAnswers(questions, made));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].own.engine, "stiction");
  EXPECT_EQ(all[0].build.engine, "stiction_single");
  ASSERT_EQ(all[0].answers.size(), 3u);
  EXPECT_DOUBLE_EQ(all[0].answers[0].speed(), 0.3 / 0.2);
  EXPECT_FALSE(all[0].answers[1].build_error);
  EXPECT_TRUE(std::isnan(all[0].answers[1].speed()));
  // The broken effort does not shift the one behind it.
  EXPECT_EQ(all[0].answers[2].effort, 2u);
  EXPECT_EQ(all[0].answers[2].build_error, 3e-3);
  EXPECT_DOUBLE_EQ(all[0].answers[2].speed(), 1.2);
}

TEST(BuildPairs, ThereAreNoneWithoutAnotherBuild) {
  const auto questions = asked({"accelerates"});
  const std::vector<Record> made = {answered("accelerates", "stiction", "", {1e-13}, {0.3}),
                                    answered("accelerates", "swift", "", {1e-5}, {0.01})};
  const EngineAnswers answers(questions, made);
  EXPECT_TRUE(build_pairs(answers).empty());
  EXPECT_EQ(builds_text(answers, {.width = 80}), "");
  EXPECT_EQ(builds_tables(answers), "");
}

TEST(BuildPairs, TellErrorAndSpeedSideBySide) {
  const auto questions = asked({"accelerates"});
  const auto made = single_beside_double();
  const EngineAnswers answers(questions, made);
  const std::string text = builds_text(answers, {.width = 80});
  EXPECT_THAT(text, HasSubstr("stiction_single · quiet beside stiction · quiet"));
  EXPECT_THAT(text, HasSubstr("× 1.50"));
  EXPECT_THAT(text, HasSubstr("… effort 2"));
  EXPECT_THAT(builds_text(answers, {.width = 200}),
              HasSubstr("error more than twice as large in 2 of 3 answers"));
  EXPECT_THAT(builds_tables(answers), HasSubstr("|            1e-4 |"));
  EXPECT_THAT(engine_summary(answers, {.width = 80}), HasSubstr(text));
  EXPECT_THAT(
      engine_findings(answers),
      testing::Contains(HasSubstr("speed × 1.50 in the median of 2 answers (1.20 to 1.50)")));
  const auto figures = builds_figures(answers);
  ASSERT_EQ(figures.size(), 3u);
  EXPECT_EQ(figures[1].quantity, "speed of stiction_single · quiet over stiction · quiet, least");
  EXPECT_EQ(figures[1].value, 1.2);
}

// Else our own solver would be told to be beaten by itself.
TEST(BuildPairs, AreNeitherOursNorOthers) {
  const auto questions = asked({"accelerates"});
  const std::vector<Record> made = {
      answered("accelerates", "stiction", "", {1e-3}, {0.3}),
      answered("accelerates", "stiction_single", "stiction", {1e-5}, {0.1})};
  const EngineAnswers answers(questions, made);
  EXPECT_FALSE(answers.cheapest(questions[0], 1e-4, false));
  EXPECT_FALSE(answers.cheapest(questions[0], 1e-4, true));
  EXPECT_THAT(engine_summary(answers, {.width = 80}), Not(HasSubstr("stiction_single · quiet 1")));
}

EngineKind engine(const std::string& name, const std::vector<std::string>& configurations,
                  std::size_t rungs) {
  EngineKind kind = find_engine("plain");
  kind.name = name;
  std::vector<Configuration> all;
  for (const std::string& one : configurations) all.push_back({.name = one});
  kind.configurations = [all](const std::string&) { return all; };
  for (std::size_t k = 0; k < rungs; ++k) kind.ladder.push_back({{"dt", std::to_string(k)}});
  return kind;
}

TEST(EngineTrials, AskAnotherBuildBehindItsEngineInTheSameConfigurationsAndEfforts) {
  const std::vector<EngineKind> engines = {find_engine("stiction"), engine("swift", {"default"}, 1),
                                           engine("stiction_single", {"quiet", "old"}, 4)};
  std::vector<std::string> told;
  for (const Trial& one : engine_trials(engines, asked({"creep-30"}), true)) {
    told.push_back(row_name(one) + " " + std::to_string(one.effort) + " " + one.build_of);
  }
  EXPECT_THAT(told, ElementsAre("stiction · quiet 0 ", "stiction_single · quiet 0 stiction",
                                "swift · default 0 ", "stiction · quiet 1 ",
                                "stiction_single · quiet 1 stiction", "stiction · quiet 2 ",
                                "stiction_single · quiet 2 stiction"));
}

}  // namespace
}  // namespace stiction
