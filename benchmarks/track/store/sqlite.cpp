// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/sqlite.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {

void Database::Close::operator()(sqlite3* handle) const { sqlite3_close(handle); }
void Statement::Finalize::operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }

Database::Database(const std::filesystem::path& file, double busy_seconds) : name_(file.string()) {
  std::error_code ignored;  // sqlite3_open says what is wrong
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  sqlite3* handle = nullptr;
  const int code = sqlite3_open(name_.c_str(), &handle);
  handle_.reset(handle);
  if (code != SQLITE_OK) {
    throw TrackError(fmt::format("{} cannot be opened: {}", name_, sqlite3_errstr(code)));
  }
  sqlite3_busy_timeout(handle, static_cast<int>(busy_seconds * 1e3));
}

void Database::execute(const char* sql) {
  if (sqlite3_exec(get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
    throw TrackError(fmt::format("{}: {}", name_, sqlite3_errmsg(get())));
  }
}

std::int64_t Database::last_id() const { return sqlite3_last_insert_rowid(get()); }

Statement::Statement(Database& database, const char* sql) : database_(database) {
  sqlite3_stmt* handle = nullptr;
  const int code = sqlite3_prepare_v2(database.get(), sql, -1, &handle, nullptr);
  handle_.reset(handle);
  check(code, SQLITE_OK);
}

void Statement::check(int code, int wanted) const {
  if (code == wanted) return;
  throw TrackError(fmt::format("{}: {}", database_.name(), sqlite3_errmsg(database_.get())));
}

Statement& Statement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(handle_.get(), next_++, value), SQLITE_OK);
  return *this;
}

Statement& Statement::bind(double value) {
  check(sqlite3_bind_double(handle_.get(), next_++, value), SQLITE_OK);
  return *this;
}

Statement& Statement::bind(const std::string& value) {
  const auto bytes = static_cast<sqlite3_uint64>(value.size());
  // −1 is SQLITE_TRANSIENT, spelled without its C cast: SQLite keeps a copy.
  const auto copy = reinterpret_cast<sqlite3_destructor_type>(-1);
  check(sqlite3_bind_text64(handle_.get(), next_++, value.data(), bytes, copy, SQLITE_UTF8),
        SQLITE_OK);
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(handle_.get());
  if (code == SQLITE_ROW) return true;
  check(code, SQLITE_DONE);
  sqlite3_reset(handle_.get());
  next_ = 1;
  return false;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(handle_.get(), column);
}

double Statement::real(int column) const { return sqlite3_column_double(handle_.get(), column); }

std::string Statement::text(int column) const {
  const auto* const bytes = sqlite3_column_text(handle_.get(), column);
  return bytes == nullptr ? "" : reinterpret_cast<const char*>(bytes);
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (open_) sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace stiction::track
