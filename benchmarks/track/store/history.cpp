// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/history.h"

#include <fmt/format.h>

#include <utility>

#include "benchmarks/track/measure/child.h"
#include "reference/statistics/two_samples.h"

namespace stiction::track {

namespace {

constexpr double kBusySeconds = 60.0;
constexpr std::int64_t kVersion = 1;

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
PRAGMA user_version = 1;
)";

constexpr const char* kRuns =
    "SELECT run.id, date, revision, label, processor, cores, compiler, flags "
    "FROM run JOIN machine ON machine.id = run.machine ORDER BY run.id";

std::int64_t version_of(Database& database) {
  Statement statement(database, "PRAGMA user_version");
  statement.step();
  return statement.integer(0);
}

StoredRun run_of(const Statement& row) {
  return {.id = row.integer(0),
          .date = row.text(1),
          .revision = row.text(2),
          .label = row.text(3),
          .machine = {row.text(4), row.integer(5), row.text(6), row.text(7)}};
}

Metric metric_of(const Statement& row, int first) {
  return {row.text(first), row.text(first + 1), row.text(first + 2),
          parse_kind(row.text(first + 3)).value_or(Kind::kOther)};
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

History::History(const std::filesystem::path& file) : database_(file, kBusySeconds) {
  // The rollback journal, synced at every step: a commit is on disk when it returns.
  database_.execute("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON;");
  if (version_of(database_) == 0) {
    Transaction transaction(database_);
    // Somebody else may have made the tables in between.
    if (version_of(database_) == 0) database_.execute(kTables);
    transaction.commit();
  }
  if (version_of(database_) > kVersion) {
    throw TrackError(fmt::format("{} was written by a newer version of stiction", file.string()));
  }
}

std::int64_t History::id_of(const Machine& machine) {
  const auto bind = [&](Statement& statement) -> Statement& {
    return statement.bind(machine.processor)
        .bind(machine.cores)
        .bind(machine.compiler)
        .bind(machine.flags);
  };
  Statement insert(database_,
                   "INSERT OR IGNORE INTO machine (processor, cores, compiler, flags) "
                   "VALUES (?, ?, ?, ?)");
  bind(insert).step();
  Statement select(database_,
                   "SELECT id FROM machine WHERE processor = ? AND cores = ? AND compiler = ? "
                   "AND flags = ?");
  bind(select).step();
  return select.integer(0);
}

std::int64_t History::id_of(const Metric& metric) {
  Statement insert(database_,
                   "INSERT OR IGNORE INTO metric (name, subject, what, unit, kind, direction) "
                   "VALUES (?, ?, ?, ?, ?, ?)");
  insert.bind(metric.name()).bind(metric.subject).bind(metric.what).bind(metric.unit);
  insert.bind(to_string(metric.kind));
  insert.bind(std::string(higher_is_better(metric.kind) ? "higher" : "lower")).step();
  Statement select(database_, "SELECT id FROM metric WHERE name = ?");
  select.bind(metric.name()).step();
  return select.integer(0);
}

std::int64_t History::add(const StoredRun& run) {
  Transaction transaction(database_);
  const std::int64_t machine = id_of(run.machine);
  Statement insert(database_,
                   "INSERT INTO run (date, revision, label, machine) VALUES (?, ?, ?, ?)");
  insert.bind(run.date).bind(run.revision).bind(run.label).bind(machine).step();
  const std::int64_t id = database_.last_id();
  Statement sample(database_, "INSERT INTO sample VALUES (?, ?, ?, ?)");
  for (const auto& [name, measurement] : run.measurements.all()) {
    const std::int64_t metric = id_of(measurement.metric);
    std::int64_t repetition = 0;
    for (const double value : measurement.samples) {
      sample.bind(id).bind(metric).bind(repetition++).bind(value).step();
    }
  }
  transaction.commit();
  return id;
}

std::vector<StoredRun> History::runs(const std::optional<Machine>& machine) const {
  std::vector<StoredRun> runs;
  for (Statement row(database_, kRuns); row.step();) {
    StoredRun run = run_of(row);
    if (!machine || run.machine == *machine) runs.push_back(std::move(run));
  }
  return runs;
}

StoredRun History::run(std::int64_t id) const {
  for (StoredRun& run : runs(std::nullopt)) {
    if (run.id != id) continue;
    Statement row(database_,
                  "SELECT subject, what, unit, kind, value FROM sample JOIN metric "
                  "ON metric.id = sample.metric WHERE run = ? ORDER BY metric, repetition");
    row.bind(id);
    while (row.step()) run.measurements.add(metric_of(row, 0), row.real(4));
    return run;
  }
  throw TrackError(fmt::format("{} has no run {}", database_.name(), id));
}

std::vector<Trend> History::trends(const std::string& glob,
                                   const std::optional<Machine>& machine) const {
  Statement row(database_,
                "SELECT subject, what, unit, kind, sample.value, run.id, processor, cores, "
                "compiler, flags FROM metric JOIN sample ON sample.metric = metric.id "
                "JOIN run ON run.id = sample.run JOIN machine ON machine.id = run.machine "
                "WHERE name GLOB ? ORDER BY name, run.id, repetition");
  row.bind(glob.empty() ? std::string("*") : glob);
  std::vector<Trend> trends;
  std::vector<double> samples;
  const auto finish_run = [&] {
    if (!samples.empty()) trends.back().medians.push_back(reference::median(samples));
    samples.clear();
  };
  while (row.step()) {
    if (machine && Machine{row.text(6), row.integer(7), row.text(8), row.text(9)} != *machine) {
      continue;
    }
    const Metric metric = metric_of(row, 0);
    const bool is_new = trends.empty() || trends.back().metric.name() != metric.name();
    if (is_new || trends.back().runs.back() != row.integer(5)) {
      finish_run();
      if (is_new) trends.push_back({.metric = metric, .runs = {}, .medians = {}});
      trends.back().runs.push_back(row.integer(5));
    }
    samples.push_back(row.real(4));
  }
  finish_run();
  return trends;
}

}  // namespace stiction::track
