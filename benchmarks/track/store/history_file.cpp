// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/history_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <cstdint>
#include <fstream>
#include <string_view>
#include <system_error>

#include "reports/record/whole_file.h"

namespace stiction::track {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kVersion = 1;        // user_version
constexpr std::int64_t kMark = 0x73746963;  // application_id, "stic"

// benchmarks/schema.md says what the columns mean.
constexpr const char* kTables = R"(
CREATE TABLE machine (
  id INTEGER PRIMARY KEY, processor TEXT NOT NULL, cores INTEGER NOT NULL,
  compiler TEXT NOT NULL, flags TEXT NOT NULL, UNIQUE (processor, cores, compiler, flags));
CREATE TABLE run (
  id INTEGER PRIMARY KEY AUTOINCREMENT, date TEXT NOT NULL, revision TEXT NOT NULL,
  label TEXT NOT NULL, machine INTEGER NOT NULL REFERENCES machine);
CREATE TABLE metric (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, subject TEXT NOT NULL, what TEXT NOT NULL,
  unit TEXT NOT NULL, kind TEXT NOT NULL, direction TEXT NOT NULL);
CREATE TABLE sample (
  run INTEGER NOT NULL REFERENCES run, metric INTEGER NOT NULL REFERENCES metric,
  repetition INTEGER NOT NULL, value REAL NOT NULL,
  PRIMARY KEY (run, metric, repetition)) WITHOUT ROWID;
CREATE INDEX sample_of_metric ON sample (metric, run);
PRAGMA application_id = 1937008995;
PRAGMA user_version = 1;
)";
// A statement of each table, which SQLite does not take unless the columns are there.
constexpr const char* kColumns[] = {
    "SELECT id, processor, cores, compiler, flags FROM machine",
    "SELECT id, date, revision, label, machine FROM run",
    "SELECT id, name, subject, what, unit, kind, direction FROM metric",
    "SELECT run, metric, repetition, value FROM sample"};

// What SQLite's format keeps in a file's first bytes (https://www.sqlite.org/fileformat2.html): they are
// read without SQLite, whose own look at a file may already change it (a journal to be rolled back).
struct Header {
  bool is_sqlite = false;
  bool has_log = false;  // write-ahead log, which no history has
  std::int64_t version = 0;
  std::int64_t mark = 0;
};

Header header_of(const fs::path& file) {
  std::string bytes(100, '\0');
  std::ifstream(file, std::ios::binary).read(bytes.data(), 100);
  const auto number = [&](std::size_t at) {
    std::int64_t value = 0;
    for (std::size_t k = at; k < at + 4; ++k) value = 256 * value + std::uint8_t(bytes[k]);
    return value;
  };
  using std::string_view_literals::operator""sv;
  return {.is_sqlite = bytes.starts_with("SQLite format 3\0"sv),
          .has_log = bytes[19] == 2,
          .version = number(60),
          .mark = number(68)};
}

[[noreturn]] void refuse_foreign(const fs::path& file) {
  throw TrackError(fmt::format(
      "{} is another program's SQLite file and was left as it is; name a history of stiction, or "
      "a file that is not there yet",
      file.string()));
}

void demand_ours(const fs::path& file) {
  const Header header = header_of(file);
  std::error_code none;
  // SQLite would fill a text of a few bytes; what was broken off while it was made has a journal.
  const bool has_text = fs::is_regular_file(file, none) && fs::file_size(file, none) > 0 &&
                        !fs::exists(file.string() + "-journal", none);
  if (!header.is_sqlite && has_text) {
    throw TrackError(fmt::format("{}: file is not a database", file.string()));
  }
  if (!header.is_sqlite) return;
  // Version 1 was written without the mark at first.
  const bool unmarked = header.mark == 0 && header.version == kVersion && !header.has_log;
  if (header.mark != kMark && !unmarked) refuse_foreign(file);
  if (header.version > kVersion) {
    throw TrackError(fmt::format("{} was written by a newer version of stiction", file.string()));
  }
}

void demand_there(const fs::path& file) {
  std::error_code unknown;
  const bool there = fs::exists(file, unknown);
  if (there && (!fs::is_regular_file(file, unknown) || fs::file_size(file, unknown) > 0)) return;
  throw TrackError(fmt::format("{} is no history: {}; './stiction track record' makes one",
                               file.string(),
                               there ? "the file is empty" : "there is no such file"));
}

void demand_tables(SQLite::Database& database, const fs::path& file) {
  try {
    for (const char* columns : kColumns) SQLite::Statement(database, columns);
  } catch (const SQLite::Exception& error) {
    const bool marked =
        database.execAndGet("PRAGMA application_id").getInt64() == kMark;  // ours, and damaged
    if (marked || error.getErrorCode() != SQLITE_ERROR) throw;
    refuse_foreign(file);
  }
}

void make_tables(SQLite::Database& database) {
  const auto are_there = [&] { return database.execAndGet("PRAGMA user_version").getInt64() > 0; };
  if (are_there()) return;
  const Writing writing;  // of an empty file the transaction's begin writes a page
  SQLite::Transaction transaction = begin(database);
  // Somebody else may have made them in between.
  if (!are_there()) database.exec(kTables);
  transaction.commit();
}

}  // namespace

SQLite::Database open_history(const fs::path& file, Access access, int milliseconds) {
  const bool writes = access == Access::kWrite;
  std::error_code ignored;  // SQLite says what is wrong
  if (writes && file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  if (!writes) demand_there(file);
  demand_ours(file);
  SQLite::Database database = in(file.string() + " cannot be opened", [&] {
    return SQLite::Database(file, SQLite::OPEN_READWRITE | (writes ? SQLite::OPEN_CREATE : 0),
                            milliseconds);
  });
  in(file.string(), [&] {
    // The rollback journal, synced at every step: a commit is on disk when it returns.
    database.exec("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON;");
    if (writes) make_tables(database);
    demand_tables(database, file);
  });
  return database;
}

void check_writable(const fs::path& file, int milliseconds) {
  SQLite::Database database = open_history(file, Access::kWrite, milliseconds);
  in(file.string(), [&] {
    if (database.execAndGet("PRAGMA quick_check(1)").getString() != "ok") {
      throw SQLite::Exception("database disk image is malformed", SQLITE_CORRUPT);
    }
    begin(database).commit();
  });
}

std::string sentence_of(const std::string& file, const SQLite::Exception& error) {
  if (error.getErrorCode() != SQLITE_BUSY) return fmt::format("{}: {}", file, error.what());
  return fmt::format(
      "{} is locked: another program is writing to it; let that end, or name another file with "
      "--history",
      file);
}

}  // namespace stiction::track
