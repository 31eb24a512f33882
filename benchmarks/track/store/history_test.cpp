// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/history.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "benchmarks/track/measure/child.h"
#include "benchmarks/track/store/scratch.h"

namespace stiction::track {
namespace {

const Machine kHere = {"Example CPU", 2, "GCC 12", "Release -O3"};
const Machine kThere = {"Example CPU", 2, "GCC 13", "Release -O3"};

constexpr int kMetrics = 20;
constexpr int kSamples = 10;

// Metric k has the samples value + k, value + k + 1, …
StoredRun run_of(double value, const Machine& machine = kHere) {
  StoredRun run{.date = "2026-01-01T00:00:00Z",
                .revision = "0123456789ab",
                .label = "present",
                .machine = machine};
  for (int k = 0; k < kMetrics; ++k) {
    for (int r = 0; r < kSamples; ++r) {
      run.measurements.add({"subject", "metric " + std::to_string(k), "s", Kind::kTime},
                           value + k + r);
    }
  }
  return run;
}

class HistoryTest : public testing::Test {
 protected:
  Scratch scratch_;
  std::filesystem::path file_ = scratch_.folder() / "deep/history.sqlite";
};

TEST_F(HistoryTest, GivesBackWhatItWasGiven) {
  StoredRun run = run_of(1.0 / 3.0);
  run.measurements.add({"case@rule=none", "digits: \"creep\"; DROP TABLE run", "1", Kind::kDigits},
                       5.5);
  const std::int64_t id = History(file_).add(run);
  const StoredRun read = History(file_).run(id);
  EXPECT_EQ(read.date, run.date);
  EXPECT_EQ(read.revision, run.revision);
  EXPECT_EQ(read.label, run.label);
  EXPECT_EQ(read.machine, run.machine);
  ASSERT_EQ(read.measurements.all().size(), run.measurements.all().size());
  for (const auto& [name, measurement] : run.measurements.all()) {
    const Measurement* const found = read.measurements.find(name);
    ASSERT_NE(found, nullptr) << name;
    EXPECT_EQ(found->samples, measurement.samples);
    EXPECT_EQ(found->metric.kind, measurement.metric.kind);
    EXPECT_EQ(found->metric.unit, measurement.metric.unit);
  }
}

TEST_F(HistoryTest, TrendsAreOfOneMachine) {
  History history(file_);
  history.add(run_of(1.0));
  history.add(run_of(100.0, kThere));
  history.add(run_of(2.0));
  EXPECT_EQ(history.runs(kHere).size(), 2u);
  EXPECT_EQ(history.runs(std::nullopt).size(), 3u);
  const std::vector<Trend> trends = history.trends("subject#metric 1", kHere);
  ASSERT_EQ(trends.size(), 1u);
  EXPECT_EQ(trends[0].runs, (std::vector<std::int64_t>{1, 3}));
  EXPECT_EQ(trends[0].medians, (std::vector<double>{6.5, 7.5}));  // 2 … 11 and 3 … 12
  EXPECT_EQ(history.trends("*", std::nullopt).size(), static_cast<std::size_t>(kMetrics));
  EXPECT_EQ(history.trends("", std::nullopt)[0].runs.size(), 3u);
  EXPECT_TRUE(history.trends("nonsense", kHere).empty());
}

TEST_F(HistoryTest, SaysWhatDiffers) {
  EXPECT_EQ(difference(kHere, kHere), "");
  EXPECT_EQ(difference(kHere, kThere), "compiler: GCC 12 / GCC 13");
}

/// The sentence with which `work` is refused.
template <class Work>
std::string refusal(Work work) {
  try {
    work();
  } catch (const TrackError& error) {
    return error.what();
  }
  return "it was not refused";
}

TEST_F(HistoryTest, RefusesWhatItCannotRead) {
  EXPECT_EQ(refusal([&] { History(file_).run(7); }), file_.string() + " has no run 7");
  EXPECT_EQ(refusal([] { History("/dev/null/history.sqlite"); }),
            "/dev/null/history.sqlite cannot be opened: unable to open database file");
  for (const std::size_t size : {1, 600, 5000}) {
    const auto text = scratch_.folder() / "text";
    std::ofstream(text) << std::string(size, 'x');
    EXPECT_EQ(refusal([&] { History{text}; }), text.string() + ": file is not a database");
    EXPECT_EQ(content_of(text), std::string(size, 'x'));
  }
  SQLite::Database(file_, SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 2");
  EXPECT_EQ(refusal([&] { History{file_}; }),
            file_.string() + " was written by a newer version of stiction");
}

// A file that another program has made, by SQL.
std::filesystem::path foreign(const std::filesystem::path& folder, const std::string& sql) {
  const std::filesystem::path file = folder / "foreign.sqlite";
  std::filesystem::remove(file);
  SQLite::Database(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(sql);
  return file;
}

TEST_F(HistoryTest, LeavesTheFilesOfOtherProgramsAlone) {
  for (const char* sql :
       {"CREATE TABLE notes (text TEXT)", "CREATE TABLE run (id); PRAGMA user_version = 1",
        "CREATE TABLE notes (text TEXT); PRAGMA user_version = 7",
        "CREATE TABLE run (id); PRAGMA application_id = 252006",
        "PRAGMA journal_mode = WAL; CREATE TABLE run (id); PRAGMA user_version = 1"}) {
    const std::filesystem::path file = foreign(scratch_.folder(), sql);
    const std::string before = content_of(file);
    const std::string sentence =
        file.string() +
        " is another program's SQLite file and was left as it is; name a history of stiction, or "
        "a file that is not there yet";
    EXPECT_EQ(refusal([&] { History{file}; }), sentence) << sql;
    EXPECT_EQ(refusal([&] { History(file, Access::kRead); }), sentence) << sql;
    EXPECT_EQ(refusal([&] { check_writable(file); }), sentence) << sql;
    EXPECT_EQ(content_of(file), before) << sql;
  }
}

TEST_F(HistoryTest, AReaderMakesNoFile) {
  const std::string sentence =
      file_.string() + " is no history: there is no such file; './stiction track record' makes one";
  EXPECT_EQ(refusal([&] { History(file_, Access::kRead); }), sentence);
  EXPECT_FALSE(std::filesystem::exists(file_.parent_path()));
  const auto empty = scratch_.folder() / "empty";
  std::ofstream{empty};
  EXPECT_EQ(refusal([&] { History(empty, Access::kRead); }),
            empty.string() +
                " is no history: the file is empty; './stiction track record' makes "
                "one");
  EXPECT_TRUE(content_of(empty).empty());
  History{empty}.add(run_of(1.0));
  EXPECT_EQ(History(empty, Access::kRead).runs(std::nullopt).size(), 1u);
}

// Those from before a history carried its program's mark.
TEST_F(HistoryTest, TakesAHistoryWithoutAMark) {
  History(file_).add(run_of(1.0));
  SQLite::Database(file_, SQLite::OPEN_READWRITE).exec("PRAGMA application_id = 0");
  EXPECT_EQ(History(file_).add(run_of(2.0)), 2);
  EXPECT_EQ(History(file_, Access::kRead).runs(std::nullopt).size(), 2u);
}

TEST_F(HistoryTest, IsFoundUnwritableBeforeAnythingIsMeasured) {
  check_writable(file_);
  EXPECT_TRUE(History(file_, Access::kRead).runs(std::nullopt).empty());
  {
    SQLite::Database other(file_, SQLite::OPEN_READWRITE);
    const SQLite::Transaction held(other, SQLite::TransactionBehavior::EXCLUSIVE);
    EXPECT_EQ(refusal([&] { check_writable(file_, 50); }),
              file_.string() +
                  " is locked: another program is writing to it; let that end, or "
                  "name another file with --history");
  }
  SQLite::Database(file_, SQLite::OPEN_READWRITE).exec("DROP TABLE sample");
  EXPECT_EQ(refusal([&] { check_writable(file_); }), file_.string() + ": no such table: sample");
}

// Values in two units under one name could not be told apart.
TEST_F(HistoryTest, RefusesAMetricInAnotherUnit) {
  History history(file_);
  history.add(run_of(1.0));
  StoredRun other;
  other.measurements.add({"subject", "metric 3", "ms", Kind::kTime}, 1.0);
  EXPECT_EQ(refusal([&] { history.add(other); }),
            file_.string() + " holds 'subject#metric 3' as a time in s, this run as a time in ms");
  EXPECT_EQ(history.runs(std::nullopt).size(), 1u);
}

TEST_F(HistoryTest, SaysWhichFileIsDamaged) {
  History(file_).add(run_of(1.0));
  const auto size = std::filesystem::file_size(file_);
  std::fstream stream(file_, std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(4096);
  stream << std::string(size - 4096, 'x');
  stream.close();
  const std::string sentence = file_.string() + ": database disk image is malformed";
  EXPECT_EQ(refusal([&] { History(file_).runs(std::nullopt); }), sentence);
  EXPECT_EQ(refusal([&] { History(file_).trends("", std::nullopt); }), sentence);
  EXPECT_EQ(refusal([&] { History(file_).add(run_of(2.0)); }), sentence);
  EXPECT_EQ(refusal([&] { check_writable(file_); }), sentence);
}

TEST_F(HistoryTest, WritesNothingToAFileThatLacksATable) {
  History history(file_);
  SQLite::Database(file_, SQLite::OPEN_READWRITE).exec("DROP TABLE sample");
  EXPECT_EQ(refusal([&] { history.add(run_of(1.0)); }), file_.string() + ": no such table: sample");
  EXPECT_TRUE(history.runs(std::nullopt).empty());
}

TEST_F(HistoryTest, ARunIsThereWholeOrNotAtAll) {
  History history(file_);
  const auto write = [&](bool commits) {
    SQLite::Database other(file_, SQLite::OPEN_READWRITE);
    SQLite::Transaction transaction(other);
    other.exec("INSERT INTO machine VALUES (1, '', 2, '', '')");
    other.exec("INSERT INTO run (date, revision, label, machine) VALUES ('', '', '', 1)");
    if (commits) transaction.commit();
  };
  write(false);
  EXPECT_TRUE(history.runs(std::nullopt).empty());
  write(true);
  EXPECT_EQ(history.runs(std::nullopt).size(), 1u);
}

TEST_F(HistoryTest, TakesTwoWriters) {
  constexpr int kRuns = 20;
  const auto write = [&] {
    History history(file_);
    for (int k = 0; k < kRuns; ++k) history.add(run_of(k));
  };
  std::thread other(write);
  write();
  other.join();
  const History history(file_);
  const std::vector<StoredRun> runs = history.runs(std::nullopt);
  ASSERT_EQ(runs.size(), 2u * kRuns);
  for (const StoredRun& run : runs) {
    EXPECT_EQ(history.run(run.id).measurements.all().size(), static_cast<std::size_t>(kMetrics));
  }
}

// STICTION_KILLS: how often benchmarks/prove_track kills it.
int kills() {
  const char* const text = std::getenv("STICTION_KILLS");
  return text == nullptr ? 10 : std::atoi(text);
}

// A child writes runs until it is killed; it tells each that `add` reported as finished by a byte.
TEST_F(HistoryTest, SurvivesAKill) {
  { History history(file_); }
  std::size_t finished = 0;
  for (int kill_number = 0; kill_number < kills(); ++kill_number) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
      History history(file_);
      for (double value = 0.0;; value += 1.0) {
        history.add(run_of(value));
        if (write(ends[1], "x", 1) != 1) _exit(1);
      }
    }
    close(ends[1]);
    // Not before the first run, and then anywhere in the middle of a later one.
    char sign;
    ASSERT_EQ(read(ends[0], &sign, 1), 1);
    ++finished;
    std::this_thread::sleep_for(std::chrono::microseconds(700 * kill_number));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    while (read(ends[0], &sign, 1) == 1) ++finished;
    close(ends[0]);
    const History history(file_);
    const std::vector<StoredRun> runs = history.runs(std::nullopt);
    // The run in progress may have been committed before the child could tell.
    ASSERT_GE(runs.size(), finished);
    ASSERT_LE(runs.size(), finished + 1);
    finished = runs.size();
    for (const StoredRun& run : runs) {
      const StoredRun whole = history.run(run.id);
      ASSERT_EQ(whole.measurements.all().size(), static_cast<std::size_t>(kMetrics));
      for (const auto& [name, measurement] : whole.measurements.all()) {
        ASSERT_EQ(measurement.samples.size(), static_cast<std::size_t>(kSamples));
      }
    }
  }
}

}  // namespace
}  // namespace stiction::track
