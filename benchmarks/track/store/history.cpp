// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/history.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include <atomic>
#include <optional>
#include <utility>

#include "benchmarks/track/measure/child.h"
#include "reference/statistics/two_samples.h"
#include "reports/record/whole_file.h"

namespace stiction::track {

namespace {

std::atomic<int> added_runs = 0;

constexpr const char* kRuns =
    "SELECT run.id, date, revision, label, processor, cores, compiler, flags "
    "FROM run JOIN machine ON machine.id = run.machine ORDER BY run.id";

/// The one number that a query for an id gives.
template <class... Value>
std::int64_t id_from(SQLite::Database& database, const char* sql, const Value&... values) {
  SQLite::Statement select(database, sql);
  SQLite::bind(select, values...);
  select.executeStep();
  return select.getColumn(0).getInt64();
}

/// A statement without results.
template <class... Value>
void execute(SQLite::Statement& statement, const Value&... values) {
  SQLite::bind(statement, values...);
  statement.exec();
  statement.reset();
}

std::string text(const SQLite::Statement& row, int column) {
  return row.getColumn(column).getString();
}

Machine machine_of(const SQLite::Statement& row, int first) {
  return {text(row, first), row.getColumn(first + 1).getInt64(), text(row, first + 2),
          text(row, first + 3)};
}

StoredRun run_of(const SQLite::Statement& row) {
  return {.id = row.getColumn(0).getInt64(),
          .date = text(row, 1),
          .revision = text(row, 2),
          .label = text(row, 3),
          .machine = machine_of(row, 4)};
}

Metric metric_of(const SQLite::Statement& row, int first) {
  return {text(row, first), text(row, first + 1), text(row, first + 2),
          parse_kind(text(row, first + 3)).value_or(Kind::kOther)};
}

}  // namespace

std::string Machine::text() const {
  return fmt::format("{}, {} cores, {}, {}", processor, cores, compiler, flags);
}

std::string difference(const Machine& a, const Machine& b) {
  std::string text;
  const auto add = [&](const char* what, const std::string& of_a, const std::string& of_b) {
    if (of_a == of_b) return;
    text += fmt::format("{}{}: {} / {}", text.empty() ? "" : "; ", what, of_a, of_b);
  };
  add("processor", a.processor, b.processor);
  add("cores", std::to_string(a.cores), std::to_string(b.cores));
  add("compiler", a.compiler, b.compiler);
  add("flags", a.flags, b.flags);
  return text;
}

History::History(const std::filesystem::path& file, Access access)
    : database_(open_history(file, access)) {}

std::int64_t History::id_of(const Machine& machine) {
  SQLite::Statement insert(database_,
                           "INSERT OR IGNORE INTO machine (processor, cores, compiler, flags) "
                           "VALUES (?, ?, ?, ?)");
  execute(insert, machine.processor, machine.cores, machine.compiler, machine.flags);
  return id_from(database_,
                 "SELECT id FROM machine WHERE processor = ? AND cores = ? AND compiler = ? "
                 "AND flags = ?",
                 machine.processor, machine.cores, machine.compiler, machine.flags);
}

std::int64_t History::id_of(const Metric& metric) {
  SQLite::Statement insert(
      database_,
      "INSERT OR IGNORE INTO metric (name, subject, what, unit, kind, direction) "
      "VALUES (?, ?, ?, ?, ?, ?)");
  execute(insert, metric.name(), metric.subject, metric.what, metric.unit, to_string(metric.kind),
          higher_is_better(metric.kind) ? "higher" : "lower");
  SQLite::Statement known(database_, "SELECT id, unit, kind FROM metric WHERE name = ?");
  known.bind(1, metric.name());
  known.executeStep();
  const std::string unit = text(known, 1), kind = text(known, 2);
  // Values in two units under one name could not be told apart.
  if (unit != metric.unit || kind != to_string(metric.kind)) {
    throw TrackError(fmt::format("{} holds '{}' as a {} in {}, this run as a {} in {}",
                                 database_.getFilename(), metric.name(), kind, unit,
                                 to_string(metric.kind), metric.unit));
  }
  return known.getColumn(0).getInt64();
}

int History::added() { return added_runs; }

std::int64_t History::add(const StoredRun& run) {
  return in(database_.getFilename(), [&] {
    std::optional<Writing> writing;
    SQLite::Transaction transaction = begin(database_);
    writing.emplace();  // not while another program is waited for
    const std::int64_t machine = id_of(run.machine);
    SQLite::Statement insert(
        database_, "INSERT INTO run (date, revision, label, machine) VALUES (?, ?, ?, ?)");
    execute(insert, run.date, run.revision, run.label, machine);
    const std::int64_t id = database_.getLastInsertRowid();
    SQLite::Statement sample(database_, "INSERT INTO sample VALUES (?, ?, ?, ?)");
    for (const auto& [name, measurement] : run.measurements.all()) {
      const std::int64_t metric = id_of(measurement.metric);
      std::int64_t repetition = 0;
      for (const double value : measurement.samples) {
        execute(sample, id, metric, repetition++, value);
      }
    }
    transaction.commit();
    ++added_runs;
    return id;
  });
}

std::vector<StoredRun> History::runs(const std::optional<Machine>& machine) const {
  return in(database_.getFilename(), [&] {
    std::vector<StoredRun> runs;
    for (SQLite::Statement row(database_, kRuns); row.executeStep();) {
      StoredRun run = run_of(row);
      if (!machine || run.machine == *machine) runs.push_back(std::move(run));
    }
    return runs;
  });
}

StoredRun History::run(std::int64_t id) const {
  for (StoredRun& run : runs(std::nullopt)) {
    if (run.id != id) continue;
    return in(database_.getFilename(), [&] {
      SQLite::Statement row(database_,
                            "SELECT subject, what, unit, kind, value FROM sample JOIN metric "
                            "ON metric.id = sample.metric WHERE run = ? ORDER BY metric, "
                            "repetition");
      row.bind(1, id);
      while (row.executeStep()) {
        run.measurements.add(metric_of(row, 0), row.getColumn(4).getDouble());
      }
      return run;
    });
  }
  throw TrackError(fmt::format("{} has no run {}", database_.getFilename(), id));
}

std::vector<std::string> History::metrics() const {
  return in(database_.getFilename(), [&] {
    std::vector<std::string> names;
    SQLite::Statement row(database_, "SELECT name FROM metric ORDER BY name");
    while (row.executeStep()) names.push_back(text(row, 0));
    return names;
  });
}

std::vector<Trend> History::trends(const std::string& glob,
                                   const std::optional<Machine>& machine) const {
  std::vector<Trend> trends;
  std::vector<double> samples;
  const auto finish_run = [&] {
    if (!samples.empty()) trends.back().medians.push_back(reference::median(samples));
    samples.clear();
  };
  in(database_.getFilename(), [&] {
    SQLite::Statement row(
        database_,
        "SELECT subject, what, unit, kind, sample.value, run.id, processor, cores, "
        "compiler, flags FROM metric JOIN sample ON sample.metric = metric.id "
        "JOIN run ON run.id = sample.run JOIN machine ON machine.id = run.machine "
        "WHERE name GLOB ? ORDER BY name, run.id, repetition");
    row.bind(1, glob.empty() ? std::string("*") : glob);
    while (row.executeStep()) {
      if (machine && machine_of(row, 6) != *machine) continue;
      const Metric metric = metric_of(row, 0);
      const std::int64_t run = row.getColumn(5).getInt64();
      const bool is_new = trends.empty() || trends.back().metric.name() != metric.name();
      if (is_new || trends.back().runs.back() != run) {
        finish_run();
        if (is_new) trends.push_back({.metric = metric, .runs = {}, .medians = {}});
        trends.back().runs.push_back(run);
      }
      samples.push_back(row.getColumn(4).getDouble());
    }
  });
  finish_run();
  return trends;
}

}  // namespace stiction::track
