// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/conversation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace stiction::reference {
namespace {

// What `ask` says of a shell script that does not answer as it should.
std::string complaint(const std::string& script, const ConversationLimits& limits = {}) {
  try {
    Conversation child({"sh", "-c", script}, limits);
    child.ask("question");
  } catch (const ChildError& what) {
    return what.what();
  }
  return "no complaint";
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Conversation, AsksAndAnswersLineByLine) {
  Conversation child({"sh", "-c", "while read -r line; do echo \"<$line>\"; done"});
  EXPECT_EQ(child.ask("one"), "<one>");
  EXPECT_EQ(child.ask("two words"), "<two words>");
}

// More than pipes hold, both ways.
TEST(Conversation, PassesLongLines) {
  Conversation child({"cat"});
  const std::string line(3'000'000, 'x');
  EXPECT_EQ(child.ask(line), line);
}

TEST(Conversation, TellsHowAChildEndedAndItsLastWords) {
  EXPECT_EQ(complaint("read -r line; exit 7"), "ended with exit code 7");
  EXPECT_EQ(complaint("read -r line; echo 'it ends' >&2; echo >&2; kill -SEGV $$"),
            "was ended by signal 11 (Segmentation fault); its last words: 'it ends'");
  EXPECT_EQ(complaint("exit 0"), "ended with exit code 0");
  EXPECT_EQ(complaint("read -r line; printf half"), "ended in the middle of the line 'half'");
}

TEST(Conversation, TellsOfAProgramThatIsNotThere) {
  EXPECT_THROW(Conversation({"no-such-program-at-all"}), ChildError);
  EXPECT_THROW(Conversation({"/dev/null"}), ChildError);
  EXPECT_THROW(Conversation({}), ChildError);
}

TEST(Conversation, WaitsNoLongerThanToldAndLeavesNothingBehind) {
  const auto start = std::chrono::steady_clock::now();
  // What it starts outlives it unless its whole group is ended.
  const std::string file = testing::TempDir() + "/conversation-left-behind";
  std::remove(file.c_str());
  EXPECT_EQ(complaint("(sleep 1; touch " + file + ") & sleep 600", {.reply_seconds = 0.2}),
            "gave no answer within 0.2 s");
  EXPECT_LT(seconds_since(start), 5.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(1300));
  EXPECT_FALSE(std::ifstream(file).good());
}

// It must not wait for a reader that never comes, nor be held up by what a child says beside.
TEST(Conversation, IsNotHeldUpByAChildThatDoesNotListenOrTalksOn) {
  EXPECT_EQ(complaint("exec 0<&-; sleep 600", {.reply_seconds = 0.2}),
            "gave no answer within 0.2 s");
  EXPECT_EQ(complaint("read -r line; head -c 1000000 /dev/zero | tr '\\0' 'e' >&2; echo yes"),
            "no complaint");
}

TEST(Conversation, RefusesWhatWasNotAskedFor) {
  Conversation child({"sh", "-c", "read -r line; echo one; echo two; sleep 600"});
  EXPECT_EQ(child.ask("question"), "one");
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  try {
    child.ask("question");
    FAIL();
  } catch (const ChildError& what) {
    EXPECT_EQ(what.what(), std::string("said 'two ' without being asked"));
  }
  EXPECT_THROW(child.ask("question"), ChildError);
}

TEST(Conversation, LimitsTheMemory) {
  const ConversationLimits limits{.memory_bytes = 64 << 20};
  const std::string hungry = "exec python3 -c \"input(); x = bytearray(1 << 30); print(len(x))\"";
  EXPECT_THAT(complaint(hungry, limits).c_str(), testing::HasSubstr("MemoryError"));
  EXPECT_EQ(complaint(hungry), "no complaint");
}

// The clock is the system's, of the process that was started.
TEST(Conversation, ReadsTheCpuTimeOffTheSystem) {
  Conversation child({"python3", "-c",
                      "import time\ninput(); print('idle', flush=True); input()\n"
                      "while time.process_time() < 0.3: pass\nprint('busy', flush=True); input()"});
  child.ask("begin");
  const double before = child.cpu_seconds();
  EXPECT_GT(before, 0.0);
  EXPECT_EQ(child.ask("work"), "busy");
  const double spent = child.cpu_seconds() - before;
  EXPECT_GT(spent, 0.3 - before);
  EXPECT_LT(spent, 0.35);
}

TEST(Conversation, ReadsTheResidentSetOffTheSystem) {
  Conversation child({"python3", "-c",
                      "input(); print('empty', flush=True); input()\n"
                      "held = b'1' * (64 << 20); print('full', flush=True); input()"});
  child.ask("begin");
  const auto before = child.resident_memory();
  ASSERT_TRUE(before);
  EXPECT_GT(*before, 1 << 20);
  EXPECT_EQ(child.ask("take"), "full");
  const auto after = child.resident_memory();
  ASSERT_TRUE(after);
  EXPECT_GE(*after - *before, 64 << 20);
  EXPECT_LT(*after - *before, 66 << 20);
}

TEST(Conversation, EndsWithTheObject) {
  pid_t process = 0;
  {
    Conversation child({"sh", "-c", "trap '' TERM; sleep 600"});
    process = child.process();
    EXPECT_EQ(kill(process, 0), 0);
  }
  EXPECT_NE(kill(process, 0), 0);
}

}  // namespace
}  // namespace stiction::reference
