// SPDX-License-Identifier: GPL-3.0-or-later
// What a study's file says, and the points that come of it.
#include "validation/sweep/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/testing/test_refusal.h"
#include "validation/sweep/points.h"
#include "validation/user/test_user_problem.h"

namespace stiction {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kStudy = R"(problem = "ramp.toml"
[[axis]]
vary = "ramp.friction"
values = [0.2, 0.4]
[[axis]]
vary = "ramp.slope_deg"
from = 10
to = "30 deg"
count = 3
)";

class StudyFile : public test::UserProblem {
 protected:
  Study study(const std::string& text) {
    write(test::kProblem);
    std::ofstream(folder_ / "study.toml") << text;
    return read_study(folder_ / "study.toml");
  }
  std::string refusal(const std::string& text) {
    return test::refusal([&] { study(text); });
  }
  // The study with `from` replaced by `to`.
  static std::string with(const std::string& from, const std::string& to) {
    return test::replaced(kStudy, from, to);
  }
};

TEST_F(StudyFile, AGridHasEveryCombinationTheLastAxisFastest) {
  const Study read = study(kStudy);
  const Points points(read);
  ASSERT_EQ(points.size(), 6u);
  EXPECT_THAT(points.values(0), ElementsAre(0.2, 10.0));
  EXPECT_THAT(points.values(1), ElementsAre(0.2, 20.0));
  EXPECT_THAT(points.values(5), ElementsAre(0.4, 30.0));
  EXPECT_EQ(points.name(1), "user/ramp/ramp.friction=0.2/ramp.slope_deg=20");
}

TEST_F(StudyFile, AScaleByFactorsIsEvenInTheLogarithm) {
  const Study read =
      study(with("from = 10\nto = \"30 deg\"", "scale = \"log\"\nfrom = 0.1\nto = 10"));
  ASSERT_EQ(read.axes[1].values.size(), 3u);
  EXPECT_DOUBLE_EQ(read.axes[1].values[0], 0.1);
  EXPECT_EQ(read.axes[1].values[1], 1.0) << "to twelve digits, so that names are short";
  EXPECT_EQ(read.axes[1].values[2], 10.0);
}

TEST_F(StudyFile, SamplesFillTheBoxOfTheAxes) {
  const std::string box = R"(problem = "ramp.toml"
sample = { count = 64 }
[[axis]]
vary = "ramp.friction"
from = 0.2
to = 0.4
[[axis]]
vary = "ramp.slope_deg"
from = 10
to = 30
)";
  const Study read = study(box);
  const Points points(read);
  ASSERT_EQ(points.size(), 64u);
  int low = 0;
  for (std::size_t k = 0; k < 64; ++k) {
    const std::vector<double> at = points.values(k);
    EXPECT_TRUE(at[0] >= 0.2 && at[0] <= 0.4 && at[1] >= 10.0 && at[1] <= 30.0);
    low += at[0] < 0.3 && at[1] < 20.0 ? 1 : 0;
  }
  EXPECT_NEAR(low, 16, 2) << "a quarter of them, as evenly as the sequence has it";
}

TEST_F(StudyFile, AHashIsOfWhatIsRunAndOfNothingElse) {
  const Study first = study(kStudy);
  const Points points(first);
  std::set<std::string> hashes;
  for (std::size_t k = 0; k < points.size(); ++k) hashes.insert(points.hash(k));
  EXPECT_EQ(hashes.size(), points.size());

  // The same point of another study, with another title, order and grid.
  const Study second = study(R"(title = "other"
problem = "ramp.toml"
[[axis]]
vary = "ramp.slope_deg"
values = [5, 20]
[[axis]]
vary = "ramp.friction"
values = [0.2]
)");
  EXPECT_EQ(Points(second).hash(1), points.hash(1));
  EXPECT_EQ(hashes.count(Points(second).hash(0)), 0u);

  // Other physics, another engine, another setting.
  const std::string before = points.hash(0);
  const auto hash_of = [&](const std::string& problem, const std::string& text) {
    write(problem);
    std::ofstream(folder_ / "study.toml") << text;
    const Study read = read_study(folder_ / "study.toml");
    return Points(read).hash(0);
  };
  EXPECT_EQ(hash_of(test::kProblem, kStudy), before);
  EXPECT_EQ(hash_of(std::string("# a comment\n") + test::kProblem, kStudy), before);
  EXPECT_NE(hash_of(edited("mass = 2.0", "mass = 2.1"), kStudy), before);
  EXPECT_NE(hash_of(edited("tolerance = 1e-12", "tolerance = 1e-11"), kStudy), before);
  EXPECT_NE(hash_of(edited("dt = 1e-3", "dt = 5e-4"), kStudy), before);
  EXPECT_NE(hash_of(test::kProblem, "engines = [\"plain\"]\n" + std::string(kStudy)), before);
}

TEST_F(StudyFile, AHashIsOfTheFilesThatTheProblemNamesToo) {
  std::ofstream(folder_ / "part.off")
      << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n"
         "3 1 2 3\n3 2 0 3\n";
  const std::string problem =
      edited("shape = \"point\"", "shape = \"surface\"\nfile = \"part.off\"\ncell_size = 1");
  const auto hash = [&] {
    write(problem);
    std::ofstream(folder_ / "study.toml") << kStudy;
    Study read;
    read.problem = [&] {
      std::ifstream stream(folder_ / "ramp.toml");
      return parse_toml(stream, folder_ / "ramp.toml");  // not meshed
    }();
    read.engines = {{find_engine("stiction"), {}, ""}};
    read.axes = {{"ramp.friction", "1", {0.2}, 0.0, 0.0, false}};
    return Points(read).hash(0);
  };
  const std::string before = hash();
  EXPECT_EQ(hash(), before);
  std::ofstream(folder_ / "part.off", std::ios::app) << "\n# changed\n";
  EXPECT_NE(hash(), before);
}

TEST_F(StudyFile, APointRunsWithItsValues) {
  const Study read = study(kStudy);
  const Points points(read);
  // μ = 0.2 at 20°: g (sin 20° − 0.2 cos 20°) for 0.1 s.
  const Record record = points.finished(1, run_job(points.job(1), 1.0));
  EXPECT_EQ(record.error, "");
  EXPECT_NEAR(record.checks.at(0).value, 0.1 * 10 * (std::sin(0.349066) - 0.2 * std::cos(0.349066)),
              1e-2);  // g Δt: the step before it touches
  EXPECT_EQ(record.point, points.hash(1));
  ASSERT_EQ(record.axes.size(), 2u);
  EXPECT_EQ(record.axes[1].name, "ramp.slope_deg");
  EXPECT_EQ(record.axes[1].unit, "deg");
  EXPECT_EQ(record.axes[1].value, 20.0);
  EXPECT_TRUE(record.series.empty());
}

TEST_F(StudyFile, AValueThatTheProblemRefusesIsTheErrorOfItsPoint) {
  const Study read = study(with("values = [0.2, 0.4]", "values = [0.2, -0.4]"));
  const Points points(read);
  const Record record = points.finished(4, run_job(points.job(4), 1.0));
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_NE(record.error, "");
}

TEST_F(StudyFile, EnginesRunInTheConfigurationsThatAreAskedFor) {
  const Study two = study(std::string(kStudy) + R"(
[[engine]]
name = "stiction"
settings = { method = "paper", rule = "secant" }
[[engine]]
name = "plain"
settings = {}
)");
  ASSERT_EQ(two.engines.size(), 2u);
  EXPECT_EQ(two.size(), 12u);
  EXPECT_EQ(two.engines[0].configuration, "paper, secant");
  const Points points(two);
  const Settings settings = points.job(0).settings;
  EXPECT_EQ(settings.at("rule"), "secant");
  EXPECT_EQ(settings.at("dt"), "0.001") << "of the problem's file";
  EXPECT_EQ(points.engine(6).kind.name, "plain");
  EXPECT_THAT(
      refusal(std::string(kStudy) + "[[engine]]\nname = \"stiction\"\nsettings = { colour = 1 }\n"),
      HasSubstr("study.toml:"));
  const Study all = study("configurations = \"all\"\n" + std::string(kStudy));
  EXPECT_GE(all.engines.size(), 1u);
  const Study one = study("configurations = [\"quiet\"]\n" + std::string(kStudy));
  ASSERT_EQ(one.engines.size(), 1u);
  EXPECT_EQ(one.engines[0].configuration, "quiet");
  EXPECT_THAT(refusal("configurations = [\"loud\"]\n" + std::string(kStudy)),
              HasSubstr("configuration"));
}

TEST_F(StudyFile, CasesVaryInSettingsOfTheirEngine) {
  const Study read = study(R"(cases = ["half-space/free-fall"]
[[axis]]
vary = "engine.dt"
values = [1e-3, 5e-4]
)");
  const Points points(read);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points.name(1), "half-space/free-fall/engine.dt=0.0005");
  EXPECT_EQ(points.job(1).settings.at("dt"), "0.0005");
  EXPECT_THAT(
      refusal("cases = [\"half-space/free-fall\"]\n[[axis]]\nvary = \"duration\"\nvalues = [1]\n"),
      HasSubstr("cannot vary"));
}

TEST_F(StudyFile, MistakesAreToldWithTheirLine) {
  const auto told = [&](const std::string& text, const std::string& words) {
    EXPECT_THAT(refusal(text), testing::AllOf(HasSubstr("study.toml:"), HasSubstr(words))) << text;
  };
  told("", "a study has a 'problem' or 'cases'");
  told("problem = \"ramp.toml\"\n", "a study needs an [[axis]]");
  told(with("\"ramp.toml\"", "\"hill.toml\""), "cannot read");
  told(with("\"ramp.toml\"", "\"ramp.toml\"\ncases = [\"*\"]"), "one of them");
  told(with("ramp.friction", "ramp.colour"), "'ramp.colour' cannot vary");
  told(with("ramp.slope_deg\"\nfrom = 10\nto = \"30 deg\"", "ramp.friction\"\nfrom = 1\nto = 3"),
       "varies on another axis too");
  told(with("[0.2, 0.4]", "[]"), "at least one number");
  told(with("[0.2, 0.4]", "[0.2, 0.2]"), "given twice");
  told(with("count = 3", "count = 2.5"), "a whole number");
  told(with("count = 3", "count = 0"), "a whole number");
  told(with("count = 3", "count = 1e300"), "a whole number");
  told(with("count = 3", "count = 9999999"), "more than 10000000 points");
  told(with("to = \"30 deg\"", "to = 10"), "must not be the same");
  told(with("count = 3", "count = 3\nscale = \"log\"\nvalues = [1]"), "no effect");
  told(with("from = 10", "scale = \"log\"\nfrom = -10"), "of one sign");
  told("engines = [\"none such\"]\n" + std::string(kStudy), "cannot be started");
  told("colour = 1\n" + std::string(kStudy), "has no key 'colour'");
  told("sample = { method = \"dice\", count = 3 }\n" +
           with("values = [0.2, 0.4]", "from = 0.2\nto = 0.4"),
       "no effect");
  told("engines = [\"stiction\", \"plain\"]\nsample = { count = 9999999 }\n" +
           std::string(
               "problem = \"ramp.toml\"\n[[axis]]\nvary = \"ramp.friction\"\nfrom = 0\nto = 1\n"),
       "a whole number from 1 to 5000000");
  told("sample = { count = 3 }\n" + std::string(kStudy), "lacks 'from'");
}

TEST(StudyHelp, TellsItsTables) {
  const std::string help = study_help(80);
  for (const char* words : {"problem =", "[[axis]]", "vary =", "[sample]", "method ="}) {
    EXPECT_THAT(help, HasSubstr(words));
  }
}

}  // namespace
}  // namespace stiction
