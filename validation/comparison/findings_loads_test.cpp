// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/testing/test_scenes.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/findings.h"

namespace stiction {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Record record(const std::string& name, const std::string& method, const std::string& rule,
              std::vector<Figure> figures) {
  Record one;
  one.case_name = name;
  one.settings = {{"method", method}, {"rule", rule}};
  one.figures = std::move(figures);
  return one;
}

Record lost(const std::string& load, const std::string& rule, double mean, double fastest) {
  return record(
      "load/lost/cells=2/r=" + load, "paper", rule,
      {{kStartSlip, "m/s", "", 1e-4}, {kStepsTo9, "1", "", mean}, {kFastestTo9, "1", "", fastest}});
}

Record falls(const std::string& rule, double mean, double fastest) {
  return record("falling-box/r=0.35", "paper", rule,
                {{kFrom3, "1", "", mean}, {kFastestFrom3, "1", "", fastest}});
}

Record poses(const std::string& slope, double at_rest) {
  return record("poses/slope=" + slope, "quiet", "stored-vector",
                {{kPosesAtRest, "1", "", at_rest}, {kPoses, "1", "", 16}});
}

TEST(LoadFindings, SayAtWhichLoadsARuleRests) {
  const std::vector<Record> records = {
      lost("0.35", "fixed-point", test::kInfinity, test::kInfinity),
      lost("0.35", "bias-vector", 12, 20),
      lost("0.73", "fixed-point", test::kInfinity, test::kInfinity),
      lost("0.73", "bias-vector", test::kInfinity, test::kInfinity)};
  EXPECT_THAT(loads_of_the_cone(Figures(records)),
              ElementsAre("Loads of 0.35, 0.73 of the cone, memory lost (a slip of up to 0.0001 "
                          "m/s), a box of 2 cells an edge: the mean slip falls below 1e-9 m/s for "
                          "good with bias-vector on paper contacts at 0.35 (12 steps, the fastest "
                          "contact 20); at none with fixed-point on paper contacts."));
}

TEST(LoadFindings, AllIsShortForEveryLoadAndTheFastestMayNeverGetThere) {
  const std::vector<Record> records = {lost("0.35", "bias-vector", 12, 20),
                                       lost("0.73", "bias-vector", 14, test::kInfinity)};
  EXPECT_THAT(loads_of_the_cone(Figures(records)),
              ElementsAre(HasSubstr("at all (12 to 14 steps, the fastest contact 20 to never); at "
                                    "none with none.")));
}

TEST(LoadFindings, SayWhetherThePapersStepsAreReached) {
  const auto sentence = [](const std::vector<Record>& records) {
    return from_sliding(Figures(records)).at(0);
  };
  EXPECT_THAT(sentence({falls("fixed-point", test::kInfinity, test::kInfinity),
                        falls("bias-vector", 3000, 3400)}),
              testing::AllOf(HasSubstr("bias-vector on paper contacts 3000 at 1 of 1 loads (the "
                                       "fastest contact 3400); never: fixed-point"),
                             HasSubstr("8 to 16 are not reached")));
  EXPECT_THAT(sentence({falls("bias-vector", 12, 20)}), HasSubstr("8 to 16 are reached"));
}

TEST(LoadFindings, SayWhatTellsRestingVectorsFromCreepingOnes) {
  const auto run = [](const std::string& load, double creep, double sliding) {
    return record("load/lost/cells=2/r=" + load, "paper", "bias-vector",
                  {{kCreep, "m/s", "", creep}, {kSliding, "1", "", sliding}});
  };
  std::vector<Record> records = {run("0.35", 1e-12, 0), run("0.73", 1e-6, 2), run("0.9", 1e-5, 5)};
  EXPECT_THAT(what_stops_the_vector(Figures(records)),
              ElementsAre(testing::AllOf(
                  HasSubstr("2 to 5 contacts are at the cone in the 2 runs"),
                  HasSubstr("0 to 0 in the 1 others. A contact that one sweep clamps"))));
  records[0] = run("0.35", 1e-12, 2);
  EXPECT_THAT(what_stops_the_vector(Figures(records)),
              ElementsAre(HasSubstr("does not tell them apart")));
}

TEST(LoadFindings, CountPosesInTheOrderOfTheSlopes) {
  const std::vector<Record> records = {poses("10", 14), poses("20", 6), poses("3", 12)};
  EXPECT_THAT(poses_at_rest(Figures(records)),
              ElementsAre("Poses at rest: stored-vector on quiet contacts 12 of 16 at 3°, 14 of 16 "
                          "at 10° and 6 of 16 at 20°."));
}

TEST(LoadFindings, AreSilentOnWhatWasNotCompared) {
  const std::vector<Record> none;
  EXPECT_TRUE(loads_of_the_cone(Figures(none)).empty());
  EXPECT_TRUE(from_sliding(Figures(none)).empty());
  EXPECT_TRUE(poses_at_rest(Figures(none)).empty());
}

TEST(ContactsWords, NameTheDepthWhereItIsNotTheMethodsOwn) {
  EXPECT_EQ(contacts_words({{"method", "quiet"}}), "quiet");
  EXPECT_EQ(contacts_words({{"method", "quiet"}, {"depth", "projection"}}), "quiet");
  EXPECT_EQ(contacts_words({{"method", "quiet"}, {"depth", "consistent"}}),
            "quiet, consistent depth");
}

}  // namespace
}  // namespace stiction
