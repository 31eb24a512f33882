// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/interruption.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

namespace stiction::reference {
namespace {

struct File {
  explicit File(bool interrupted) {
    if (!interrupted) return;
    kill(getpid(), SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // it is there, and not made yet
  }
  std::string last_words() { return "; it is told of"; }
};

void make_file(bool interrupted_meanwhile) {
  end_in_order("program");
  const WithLastWords<File> file([&] { return File(interrupted_meanwhile); });
  if (!interrupted_meanwhile) kill(getpid(), SIGINT);
  std::this_thread::sleep_for(std::chrono::seconds(60));
}

constexpr int kInterrupted = kSignalled + SIGINT;

TEST(InterruptionDeathTest, WhatHasLastWordsIsToldOf) {
  EXPECT_EXIT(make_file(false), testing::ExitedWithCode(kInterrupted),
              "^program: interrupted; it is told of\n$");
}

TEST(InterruptionDeathTest, WhatIsJustBeingMadeIsToldOf) {
  EXPECT_EXIT(make_file(true), testing::ExitedWithCode(kInterrupted),
              "^program: interrupted; it is told of\n$");
}

}  // namespace
}  // namespace stiction::reference
