// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/child.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace stiction::reference {
namespace {

TEST(ChildProcess, TellsHowItEnded) {
  EXPECT_EQ(run_child({"true"}).code, 0);
  EXPECT_EQ(run_child({"sh", "-c", "exit 7"}).code, 7);
  const Ended killed = run_child({"sh", "-c", "kill -SEGV $$"});
  EXPECT_EQ(killed.signal, SIGSEGV);
  EXPECT_EQ(killed.code, 128 + SIGSEGV);
  EXPECT_EQ(run_child({"no-such-program-at-all"}).code, 127);
  EXPECT_EQ(run_child({"/dev/null"}).code, 127);
  EXPECT_EQ(run_child({"true"}, {.folder = "/no-such-folder"}).code, 127);
}

// More than a pipe holds, on both.
TEST(ChildProcess, GivesAllOfBothOutputs) {
  const Ended ended =
      run_child({"sh", "-c", "head -c 300000 /dev/zero >&2; head -c 200000 /dev/zero; echo end"});
  EXPECT_EQ(ended.output.size(), 200004u);
  EXPECT_EQ(ended.errors.size(), 300000u);
}

TEST(ChildProcess, RunsWhereItIsTold) {
  EXPECT_EQ(run_child({"pwd", "-P"}, {.folder = "/"}).output, "/\n");
}

TEST(ChildProcess, HasNothingToReadAndNoRunFileToWrite) {
  setenv("STICTION_RUN_FILE", "a file", 1);
  const Ended ended = run_child({"sh", "-c", "cat; echo \"<$STICTION_RUN_FILE>\""});
  unsetenv("STICTION_RUN_FILE");
  EXPECT_EQ(ended.output, "<>\n");
}

TEST(ChildProcess, CanBeWatchedWhileItRuns) {
  std::vector<std::string> seen;
  double last = 0.0;
  const Ended ended = run_child({"sh", "-c", "echo begun >&2; sleep 0.7; echo done"},
                                {.meanwhile = [&](double seconds, const Ended& so_far) {
                                  EXPECT_GE(seconds, last);
                                  last = seconds;
                                  seen.push_back(so_far.errors);
                                }});
  EXPECT_EQ(ended.output, "done\n");
  EXPECT_GE(seen.size(), 4u) << "every 0.2 s";
  EXPECT_EQ(seen.back(), "begun\n");
}

TEST(ChildProcess, IsStoppedWhenItsTimeIsOver) {
  using Clock = std::chrono::steady_clock;
  // The second closes both pipes and goes on.
  for (const char* const script : {"exec sleep 60", "exec >&- 2>&-; exec sleep 60"}) {
    const Clock::time_point start = Clock::now();
    const Ended ended = run_child({"sh", "-c", script}, {.time_limit = 0.05});
    EXPECT_TRUE(ended.timed_out) << script;
    EXPECT_EQ(ended.signal, SIGKILL) << script;
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(30)) << script;
  }
  EXPECT_FALSE(run_child({"true"}, {.time_limit = 60.0}).timed_out);
}

TEST(ChildProcess, LastLineIsTheLastWithText) {
  EXPECT_EQ(last_line("first\nwhy\n \n"), "why");
  EXPECT_EQ(last_line("only"), "only");
  EXPECT_EQ(last_line(" \n"), "");
}

TEST(FindProgram, TakesTheFirstThatMayBeExecuted) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "stiction_find_program";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "sh") << "not to be executed";
  std::filesystem::permissions(folder / "sh", std::filesystem::perms::owner_read);
  EXPECT_EQ(find_program("sh", {"", folder, "/no-such-folder", "/bin", "/usr/bin"}), "/bin/sh");
  EXPECT_EQ(find_program("sh", {folder}), "");
  std::filesystem::remove_all(folder);
  EXPECT_FALSE(find_program("sh", folders_of_path()).empty());
  EXPECT_TRUE(std::filesystem::is_directory(folder_of_this_program()));
}

}  // namespace
}  // namespace stiction::reference
