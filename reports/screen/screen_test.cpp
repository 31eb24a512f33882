// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/screen/screen.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "reports/screen/progress_line.h"
#include "reports/text/number.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

// Restores a variable of the environment.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* const old = std::getenv(name)) old_ = old, was_ = true;
    value ? setenv(name, value, 1) : unsetenv(name);
  }
  ~Variable() { was_ ? setenv(name_, old_.c_str(), 1) : unsetenv(name_); }

 private:
  const char* name_;
  std::string old_;
  bool was_ = false;
};

TEST(Screen, APipeHasTheColumnsItIsToldOrEighty) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  {
    const Variable columns("COLUMNS", nullptr);
    EXPECT_EQ(screen_of(ends[1]).width, 80u);
    EXPECT_FALSE(screen_of(ends[1]).colour);
    EXPECT_FALSE(screen_of(ends[1]).moving);
  }
  for (const auto& [told, width] : {std::pair{"200", 200u}, {"x", 80u}, {"0", 80u}, {"-5", 80u}}) {
    const Variable columns("COLUMNS", told);
    EXPECT_EQ(screen_of(ends[1]).width, width) << told;
  }
  close(ends[0]);
  close(ends[1]);
}

TEST(Screen, ATableIsNeverWiderThanAskedForAndCutsNothing) {
  const Cells rows = {{"what", "winner", "figure"},
                      {"a question of some length", "the conjugate vector", "1e-17 m/s"},
                      {"µ", "secant", "2"}};
  for (const std::size_t width : {30u, 48u, 60u, 200u}) {
    const std::string table = plain_table(rows, {0, 1}, width);
    for (const auto& row : rows) {
      for (const auto& cell : row) EXPECT_NE(table.find(cell), std::string::npos) << cell;
    }
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(display_width(line), std::max<std::size_t>(width, 47)) << line;
      EXPECT_TRUE(line.empty() || line.back() != ' ');
    }
  }
  EXPECT_EQ(plain_table({{"a"}, {"b"}}, {0}, 80), "a\nb\n");
}

TEST(Screen, ABulletsFurtherLinesStandUnderItsText) {
  EXPECT_EQ(bullet("one two three four five", 23), "- one two three four\n  five\n");
}

TEST(ProgressLine, GivesUpTheTimeBeforeTheName) {
  EXPECT_EQ(progress_text(12, 183, "rules/slab", 80.0, 80),
            "[12/183] rules/slab · 1 min 20 s left");
  EXPECT_EQ(progress_text(12, 183, "rules/slab", 80.0, 25), "[12/183] rules/slab");
  EXPECT_LE(display_width(progress_text(12, 183, "rules/slab-of-some-length", 80.0, 25)), 25u);
  EXPECT_EQ(progress_text(0, 9, "a\nb", 0.0, 80), "[0/9] a b");
}

TEST(ProgressLine, TellsTimesAsPeopleDo) {
  EXPECT_EQ(duration_text(4.6), "5 s");
  EXPECT_EQ(duration_text(125.0), "2 min 05 s");
  EXPECT_EQ(duration_text(4800.0), "1 h 20 min");
}

}  // namespace
}  // namespace stiction
