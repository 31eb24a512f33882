// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/record_store.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "reports/record/record_json.h"
#include "reports/record/test_files.h"
#include "reports/record/test_message.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

namespace fs = std::filesystem;

using test::content_of;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

class RecordStoreTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "record_store_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    out_ = name;
  }
  void TearDown() override { fs::remove_all(out_); }

  fs::path out_;
};

TEST_F(RecordStoreTest, MakesMissingFolders) {
  const RecordStore store = RecordStore::create(out_ / "a" / "b");
  EXPECT_EQ(store.folder().parent_path(), out_ / "a" / "b");
  EXPECT_TRUE(fs::is_empty(store.records_file()));
}

TEST_F(RecordStoreTest, TwoRunsInOneFolderDoNotMix) {
  RecordStore a = RecordStore::create(out_);
  RecordStore b = RecordStore::create(out_);
  ASSERT_NE(a.folder(), b.folder());
  a.append(test::passing_record("a"));
  b.append(test::passing_record("b"));
  a.append(test::passing_record("a"));
  a.write_file("report.md", "a");
  b.write_file("report.md", "b");
  EXPECT_EQ(read_records(a.records_file()).records.size(), 2u);
  ASSERT_EQ(read_records(b.records_file()).records.size(), 1u);
  EXPECT_EQ(read_records(b.records_file()).records[0].case_name, "b");
  EXPECT_EQ(content_of(a.folder() / "report.md"), "a");
}

TEST_F(RecordStoreTest, ManyRunsAtOnceEachGetTheirOwn) {
  std::vector<std::string> folders(16);
  std::vector<std::thread> runs;
  for (std::string& folder : folders) {
    runs.emplace_back([&] { folder = RecordStore::create(out_).folder().string(); });
  }
  for (std::thread& run : runs) run.join();
  EXPECT_EQ(std::set<std::string>(folders.begin(), folders.end()).size(), folders.size());
}

TEST_F(RecordStoreTest, TheFolderIsNamedByTheTime) {
  const std::string name = RecordStore::create(out_).folder().filename().string();
  EXPECT_TRUE(std::string_view(name).substr(0, 2) == "20" && name.size() >= 20) << name;
  EXPECT_EQ(name[10], 'T') << name;
  EXPECT_EQ(name[19], 'Z') << name;
}

TEST_F(RecordStoreTest, ARecordCanBeReadAsSoonAsItIsAppended) {
  RecordStore store = RecordStore::create(out_);
  for (std::size_t n = 1; n <= 3; ++n) {
    store.append(test::passing_record());
    EXPECT_EQ(read_records(store.records_file()).records.size(), n);
  }
  EXPECT_EQ(content_of(store.records_file()).back(), '\n');
}

TEST_F(RecordStoreTest, AppendsFromManyThreadsGiveWholeLines) {
  constexpr int kThreads = 8;
  constexpr int kEach = 25;
  RecordStore store = RecordStore::create(out_);
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&store, t] {
      for (int i = 0; i < kEach; ++i) {
        Record record = test::passing_record(std::to_string(t) + "/" + std::to_string(i));
        record.notes = {std::string(static_cast<std::size_t>(10000 * (t % 3)), 'x')};
        store.append(record);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::set<std::string> names;
  for (const Record& record : read_records(store.records_file()).records) {
    names.insert(record.case_name);
  }
  EXPECT_EQ(names.size(), std::size_t{kThreads * kEach});
}

TEST_F(RecordStoreTest, ARecordThatCannotBeReadBackIsNotWritten) {
  RecordStore store = RecordStore::create(out_);
  Record record = test::passing_record();
  record.series[0].x.clear();
  EXPECT_THROW(store.append(record), std::invalid_argument);
  EXPECT_TRUE(fs::is_empty(store.records_file()));
}

TEST_F(RecordStoreTest, WriteFileReplacesAndLeavesNoTemporary) {
  RecordStore store = RecordStore::create(out_);
  store.write_file("report.md", "old");
  store.write_file("report.md", "new");
  EXPECT_EQ(content_of(store.folder() / "report.md"), "new");
  EXPECT_EQ(names_in(store.folder()), (std::set<std::string>{"records.jsonl", "report.md"}));
}

TEST_F(RecordStoreTest, WriteFileTakesPlainNamesOnly) {
  RecordStore store = RecordStore::create(out_);
  store.append(test::passing_record());
  for (const char* name : {"", ".", "..", "../report.md", "/tmp/report.md", "records.jsonl"}) {
    EXPECT_NE(test::message_of([&] { store.write_file(name, "x"); }), "") << name;
  }
  EXPECT_EQ(read_records(store.records_file()).records.size(), 1u);
}

TEST_F(RecordStoreTest, FinishPointsLatestAtTheRun) {
  RecordStore a = RecordStore::create(out_);
  RecordStore b = RecordStore::create(out_);
  EXPECT_FALSE(fs::exists(out_ / "latest"));
  a.finish();
  EXPECT_EQ(fs::canonical(out_ / "latest"), fs::canonical(a.folder()));
  b.finish();
  b.finish();
  EXPECT_EQ(fs::canonical(out_ / "latest"), fs::canonical(b.folder()));
  EXPECT_TRUE(fs::read_symlink(out_ / "latest").is_relative()) << "the folder can be moved";
  EXPECT_EQ(names_in(out_), (std::set<std::string>{a.folder().filename().string(),
                                                   b.folder().filename().string(), "latest"}));
}

// Before anything has run, and nothing of the folder is changed.
TEST_F(RecordStoreTest, WhatStandsInPlaceOfTheLinkIsRefusedAtTheStart) {
  const std::string latest = (out_ / "latest").string();
  const std::string what = ", where the link to the last run belongs: move it, or name another ";
  fs::create_directory(latest);
  EXPECT_EQ(test::message_of([&] { RecordStore::create(out_); }),
            "\"" + latest + "\" is a folder" + what + "folder for the reports.");
  fs::remove(latest);
  std::ofstream(latest) << "mine";
  EXPECT_EQ(test::message_of([&] { RecordStore::create(out_); }),
            "\"" + latest + "\" is a file" + what + "folder for the reports.");
  EXPECT_EQ(content_of(latest), "mine");
  EXPECT_EQ(names_in(out_), (std::set<std::string>{"latest"}));
  fs::remove(latest);
  fs::create_symlink("a run that was deleted", latest);
  RecordStore::create(out_).finish();
  EXPECT_TRUE(fs::is_directory(latest));
}

// Else records would be written, and what stands deeper in the run's folder not.
TEST_F(RecordStoreTest, APathWithoutRoomForWhatStandsInItIsRefusedAtTheStart) {
  fs::path deep = out_;
  while (deep.native().size() < 3900) deep /= std::string(20, 'd');
  const std::string message = test::message_of([&] { RecordStore::create(deep); });
  EXPECT_NE(message.find("its path has " + std::to_string(deep.native().size()) + " bytes, and "),
            std::string::npos)
      << message;
  EXPECT_TRUE(fs::is_empty(out_));
  const std::string name =
      test::message_of([&] { RecordStore::create(out_ / std::string(300, 'd')); });
  EXPECT_NE(name.find("File name too long"), std::string::npos) << name;
}

// Made while the run went on.
TEST_F(RecordStoreTest, FinishReplacesNeitherAFolderNorAFile) {
  RecordStore store = RecordStore::create(out_);
  fs::create_directory(out_ / "latest");
  EXPECT_NE(test::message_of([&] { store.finish(); }).find("is a folder"), std::string::npos);
  fs::remove(out_ / "latest");
  std::ofstream(out_ / "latest") << "mine";
  EXPECT_NE(test::message_of([&] { store.finish(); }).find("is a file"), std::string::npos);
  EXPECT_EQ(content_of(out_ / "latest"), "mine");
  EXPECT_EQ(names_in(out_).size(), 2u) << "no temporary is left";
}

TEST_F(RecordStoreTest, AFileInPlaceOfTheFolderIsNamed) {
  std::ofstream(out_ / "file") << "x";
  EXPECT_EQ(test::message_of([&] { RecordStore::create(out_ / "file" / "runs"); }),
            "Cannot create folder \"" + (out_ / "file" / "runs").string() + "\": Not a directory.");
}

// The rest runs in a child of its own, since limits and user ids are the whole process's. The child
// is a plain fork (the default style), so that it shares the folder with its parent.
using RecordStoreDeathTest = RecordStoreTest;

[[noreturn]] void leave(const std::string& message) {
  std::fputs(message.c_str(), stderr);
  std::_Exit(0);
}

void limit_files_to(rlim_t bytes) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = std::min(bytes, limit.rlim_max);
  setrlimit(RLIMIT_FSIZE, &limit);
}

// Demands that always run in a child, whose gtest expectations nobody would see.
void demand(bool holds, const char* what) {
  if (holds) return;
  std::fputs(what, stderr);
  std::_Exit(1);
}

TEST_F(RecordStoreDeathTest, AnUnwritableFolderGivesTheSentence) {
  const auto child = [&] {
    fs::permissions(out_, fs::perms::owner_read | fs::perms::owner_exec);
    // The superuser may write anywhere, so the child becomes nobody.
    if (geteuid() == 0) {
      fs::permissions(out_, fs::perms::others_read | fs::perms::others_exec);
      demand(setuid(65534) == 0, "setuid failed");
    }
    leave(test::message_of([&] { RecordStore::create(out_); }));
  };
  EXPECT_EXIT(child(), testing::ExitedWithCode(0),
              "^Cannot create folder \".*record_store_.*\": Permission denied\\.$");
}

TEST_F(RecordStoreDeathTest, AFullDiskLosesNoFinishedRecord) {
  const auto child = [&] {
    RecordStore store = RecordStore::create(out_);
    limit_files_to(20000);
    std::size_t written = 0;
    std::string message;
    while (message.empty() && written < 1000) {
      message = test::message_of([&] { store.append(test::passing_record()); });
      if (message.empty()) ++written;
    }
    demand(written > 2 && written < 1000, "the limit was not met");
    const RecordFile full = read_records(store.records_file());
    demand(full.records.size() == written, "a finished record is lost");
    demand(full.unfinished.empty(), "half a line is left");
    demand(content_of(store.records_file()).back() == '\n', "half a line is left");
    // Room again: the run goes on in the same file.
    limit_files_to(RLIM_INFINITY);
    store.append(test::passing_record("later"));
    const RecordFile later = read_records(store.records_file());
    demand(later.records.size() == written + 1, "writing did not go on");
    demand(later.records.back().case_name == "later", "writing did not go on");
    leave(message);
  };
  EXPECT_EXIT(child(), testing::ExitedWithCode(0),
              "^Cannot write the record of \"incline/.*\" to \".*/records.jsonl\": File too large; "
              "the [0-9]+ record\\(s\\) before it are kept\\.$");
}

TEST_F(RecordStoreDeathTest, AFullDiskKeepsTheOldFile) {
  const auto child = [&] {
    RecordStore store = RecordStore::create(out_);
    store.write_file("report.md", "old");
    limit_files_to(5000);
    const std::string message =
        test::message_of([&] { store.write_file("report.md", std::string(100000, 'x')); });
    demand(content_of(store.folder() / "report.md") == "old", "the old file is gone");
    demand(names_in(store.folder()).size() == 2, "a temporary is left");
    leave(message);
  };
  EXPECT_EXIT(child(), testing::ExitedWithCode(0),
              "^Cannot write \".*/report.md\": File too large\\.$");
}

// A crash in the middle of a run: what was appended can be read, and the next run is not disturbed.
TEST_F(RecordStoreDeathTest, AKilledRunLeavesItsRecords) {
  const auto child = [&] {
    RecordStore store = RecordStore::create(out_);
    store.append(test::passing_record("a"));
    store.append(test::passing_record("b"));
    std::raise(SIGKILL);
  };
  EXPECT_EXIT(child(), testing::KilledBySignal(SIGKILL), "");
  std::size_t runs = 0;
  for (const auto& entry : fs::directory_iterator(out_)) {
    ++runs;
    EXPECT_EQ(read_records(entry.path() / "records.jsonl").records.size(), 2u);
  }
  EXPECT_EQ(runs, 1u);
}

}  // namespace
}  // namespace stiction
