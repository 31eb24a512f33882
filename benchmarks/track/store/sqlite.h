// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace stiction::track {

/// An open SQLite file. Failures are TrackError with SQLite's own words. For one thread.
class Database {
 public:
  /// Makes the file and its folder where they are missing. Another writer is waited for, up to
  /// `busy_seconds`.
  Database(const std::filesystem::path& file, double busy_seconds);

  /// Statements without parameters and results.
  void execute(const char* sql);
  std::int64_t last_id() const;
  sqlite3* get() const { return handle_.get(); }
  const std::string& name() const { return name_; }

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  std::string name_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement: bind parameters in order, then `step` through the rows.
class Statement {
 public:
  Statement(Database& database, const char* sql);

  Statement& bind(std::int64_t value);
  Statement& bind(double value);
  Statement& bind(const std::string& value);

  /// Whether there is a row (more). After the last one the statement is ready for new parameters.
  bool step();

  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* handle) const;
  };
  void check(int code, int wanted) const;

  Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
  int next_ = 1;  // parameter to bind
};

/// A write transaction, taken at once; rolled back unless committed.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace stiction::track
