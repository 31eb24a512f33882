// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/whole_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <future>
#include <thread>

#include "reports/record/test_files.h"
#include "reports/record/test_message.h"

namespace stiction {
namespace {

namespace fs = std::filesystem;

using test::content_of;

class WholeFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "whole_file_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), {}); }

  fs::path folder_;
};

TEST_F(WholeFileTest, AnOlderFileStaysUntilTheNewOneIsWhole) {
  const fs::path file = folder_ / "file";
  write_whole(file, "old");
  EXPECT_EQ(content_of(file), "old");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{100, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message =
      test::message_of([&] { write_whole(file, std::string(1000, 'x'), Wait::kNo); });
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(message, "Cannot write \"" + file.string() + "\": File too large.");
  EXPECT_EQ(content_of(file), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(WholeFileTest, ALinkStaysAndWhatItPointsToIsWritten) {
  fs::create_directory(folder_ / "there");
  fs::create_symlink("there/file", folder_ / "link");
  write_whole(folder_ / "there/file", "old");
  write_whole(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content_of(folder_ / "there/file"), "new");
}

TEST_F(WholeFileTest, APipeIsWrittenTo) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  auto heard = std::async(std::launch::async, [&] { return content_of(pipe); });
  write_whole(pipe, "said");
  EXPECT_EQ(heard.get(), "said");
  EXPECT_EQ(files(), 1);
}

// A program without a handler writes until it is told to end.
TEST_F(WholeFileTest, ASignalLeavesNoFileThatIsNotWhole) {
  for (int k = 0; k < 10; ++k) {
    fs::remove(folder_ / "file");
    const pid_t child = fork();
    if (child == 0) {
      while (true) write_whole(folder_ / "file", std::string(100000, 'x'), Wait::kNo);
    }
    // On a busy machine it may be a while until the child has its turn.
    while (!fs::exists(folder_ / "file")) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::microseconds(5000 + 700 * k));
    kill(child, SIGTERM);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(WTERMSIG(status), SIGTERM);
    EXPECT_EQ(fs::file_size(folder_ / "file"), 100000u);
    EXPECT_EQ(files(), 1);
  }
}

// Where a program is ended by another thread, that one calls end_writing.
TEST_F(WholeFileTest, NothingBeginsOnceWritingHasEnded) {
  const pid_t child = fork();
  if (child == 0) {
    std::thread([] {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      end_writing();
      _exit(7);
    }).detach();
    while (true) write_whole(folder_ / "file", std::string(100000, 'x'), Wait::kNo);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(fs::file_size(folder_ / "file"), 100000u);
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace stiction
