// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/configuration_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/record/test_records.h"

namespace stiction {
namespace {

TEST(ConfigurationText, IsTheNameAndWhatDiffersFromIt) {
  Record record = test::passing_record();
  EXPECT_EQ(configuration_text(record), "paper, fixed point, kappa=0.7");
  record.differs.clear();
  EXPECT_EQ(configuration_text(record), "paper, fixed point");
  record.configuration.clear();
  EXPECT_EQ(configuration_text(record), "dt=0.001 rule=fixed-point");
  record.settings.clear();
  EXPECT_EQ(configuration_text(record), "default");
}

TEST(RerunCommand, NamesCaseConfigurationAndWhatDiffers) {
  Record record = test::passing_record("slab/kappa");
  EXPECT_EQ(rerun_command(record),
            "./stiction validate --case 'slab/kappa' --configuration 'paper, fixed point' --set "
            "'kappa=0.7'");
  record.differs = {{"perturbed", "turned/1"}};
  EXPECT_EQ(
      rerun_command(record),
      "./stiction validate --case 'slab/kappa' --configuration 'paper, fixed point' --perturb "
      "'turned/1'");
  record.differs = {{"finer", "2"}};
  EXPECT_THAT(rerun_command(record),
              testing::HasSubstr("--configuration 'paper, fixed point' --finer '2'"));
  record.configuration = "default";
  record.differs.clear();
  record.engine = "bullet";
  EXPECT_EQ(rerun_command(record),
            "./stiction validate --case 'slab/kappa' --engine 'bullet' --configuration 'default'");
  EXPECT_EQ(rerun_command(record, {"my ramp.toml"}, "python3 mine.py"),
            "./stiction validate 'my ramp.toml' --case 'slab/kappa' --engine 'python3 mine.py' "
            "--configuration 'default'");
  record.configuration.clear();
  record.case_name = "user/a[1]*b";
  EXPECT_EQ(rerun_command(record),
            "./stiction validate PROBLEM.toml --case 'user/a?1??b' --engine 'bullet'");
}

TEST(RerunCommand, HasNoWordThatAShellWouldRun) {
  Record record = test::passing_record("a'; rm -rf /; '\n$(reboot)");
  record.differs.clear();
  EXPECT_EQ(
      rerun_command(record),
      "./stiction validate --case 'a'\\''; rm -rf /; '\\'' $(reboot)' --configuration 'paper, "
      "fixed point'");
}

}  // namespace
}  // namespace stiction
