// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/child.h"

#include <gtest/gtest.h>

#include <fstream>

#include "benchmarks/track/store/remembered.h"
#include "benchmarks/track/store/scratch.h"

namespace stiction::track {
namespace {

TEST(Child, MayBeNoProgram) {
  EXPECT_EQ(run({"no-such-program-at-all"}).code, 127);
  EXPECT_FALSE(has_program("no-such-program-at-all"));
}

TEST(Child, RunsWhereItIsTold) {
  const Scratch scratch;
  EXPECT_EQ(last_line(demand_run("pwd", {"pwd", "-P"}, scratch.folder())),
            std::filesystem::canonical(scratch.folder()).string());
}

TEST(Child, ExplainsAFailureByItsLastLine) {
  try {
    demand_run("it cannot be done", {"sh", "-c", "echo first >&2; echo why >&2; exit 1"});
    FAIL();
  } catch (const TrackError& error) {
    EXPECT_STREQ(error.what(), "it cannot be done: why");
  }
}

TEST(Remembered, IsMadeOnce) {
  const Scratch scratch;
  int made = 0;
  const auto make = [&] { return "text " + std::to_string(++made) + "\n"; };
  EXPECT_EQ(remembered(scratch.folder(), "key", false, make), "text 1\n");
  EXPECT_EQ(remembered(scratch.folder(), "key", false, make), "text 1\n");
  EXPECT_EQ(remembered(scratch.folder(), "other key", false, make), "text 2\n");
  EXPECT_EQ(remembered(scratch.folder(), "key", true, make), "text 3\n");
  EXPECT_EQ(remembered(scratch.folder(), "key", false, make), "text 3\n");
}

TEST(Remembered, KnowsAFileByItsContent) {
  const Scratch scratch;
  std::ofstream(scratch.folder() / "a") << "content";
  std::ofstream(scratch.folder() / "b") << "content";
  std::ofstream(scratch.folder() / "c") << "contents";
  const auto hash = [&](const char* name) { return content_hash(scratch.folder() / name); };
  EXPECT_EQ(hash("a"), hash("b"));
  EXPECT_NE(hash("a"), hash("c"));
  EXPECT_THROW(hash("missing"), TrackError);
}

}  // namespace
}  // namespace stiction::track
