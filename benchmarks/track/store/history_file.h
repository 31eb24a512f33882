// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Transaction.h>

#include <filesystem>
#include <string>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {

/// What a history is opened for.
enum class Access {
  kRead,  ///< the file must be there; it is never made
  kWrite  ///< made where it is missing
};

/// A writer waits so long for another, ms.
inline constexpr int kBusyMilliseconds = 60000;

/// The SQLite database of a history, with its tables (benchmarks/schema.md). Throws TrackError, one
/// sentence with the file's name, when it cannot be opened or read, was written by a newer version, or
/// is another program's: such a file is left as it is, to the bit. For another writer it waits
/// `milliseconds`, now and in what is done with the database.
SQLite::Database open_history(const std::filesystem::path& file, Access access,
                              int milliseconds = kBusyMilliseconds);

/// Demands, before anything is measured for it, that a run can be added to this history: makes the file
/// where it is missing, reads it through, and takes its lock. Throws TrackError.
void check_writable(const std::filesystem::path& file, int milliseconds = 5000);

/// A write transaction, taken at once; rolled back unless committed.
inline SQLite::Transaction begin(SQLite::Database& database) {
  return SQLite::Transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
}

/// What SQLite complains of, with the file's name.
std::string sentence_of(const std::string& file, const SQLite::Exception& error);

/// What `work` gives; SQLite's errors become TrackErrors with the file's name.
template <class Work>
auto in(const std::string& file, Work work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw TrackError(sentence_of(file, error));
  }
}

}  // namespace stiction::track
