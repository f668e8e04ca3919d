// SPDX-License-Identifier: Apache-2.0
#include "recording_index.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <set>
#include <utility>

namespace tocsin::archive {
namespace {

constexpr std::int64_t day_ns = 86'400'000'000'000;
/// Of PostgreSQL's lock that orders those who make tables; any number that others do not use.
constexpr int table_lock = 7'340'061;

constexpr const char* make_files =
    "CREATE TABLE IF NOT EXISTS files (id TEXT PRIMARY KEY, object TEXT NOT NULL, "
    "vehicle TEXT NOT NULL, host TEXT NOT NULL, run TEXT NOT NULL, bytes BIGINT NOT NULL, "
    "from_ns BIGINT NOT NULL, to_ns BIGINT NOT NULL)";
constexpr const char* make_files_by_time =
    "CREATE INDEX IF NOT EXISTS files_by_time ON files (vehicle, from_ns)";
constexpr const char* make_topics =
    "CREATE TABLE IF NOT EXISTS topics (file TEXT NOT NULL REFERENCES files (id), "
    "topic TEXT NOT NULL, type TEXT NOT NULL, messages BIGINT NOT NULL, from_ns BIGINT NOT NULL, "
    "to_ns BIGINT NOT NULL, gaps BIGINT NOT NULL, PRIMARY KEY (file, topic))";
constexpr const char* make_readings =
    "CREATE TABLE IF NOT EXISTS readings (file TEXT NOT NULL, vehicle TEXT NOT NULL, "
    "time_ns BIGINT NOT NULL, x_m DOUBLE PRECISION, y_m DOUBLE PRECISION, "
    "signal_dbm DOUBLE PRECISION, loss_percent DOUBLE PRECISION, qni DOUBLE PRECISION, "
    "battery_percent DOUBLE PRECISION, PRIMARY KEY (file, time_ns))";
constexpr const char* make_readings_by_time =
    "CREATE INDEX IF NOT EXISTS readings_by_time ON readings (vehicle, time_ns)";
constexpr const char* link_readings =
    "link_readings AS SELECT vehicle, time_ns, MAX(x_m) AS x_m, MAX(y_m) AS y_m, "
    "MAX(signal_dbm) AS signal_dbm, MAX(loss_percent) AS loss_percent, MAX(qni) AS qni, "
    "MAX(battery_percent) AS battery_percent FROM readings GROUP BY vehicle, time_ns";
constexpr const char* select_files =
    "SELECT f.object, f.from_ns, f.to_ns, f.bytes, COALESCE(SUM(t.messages), 0),"
    " COALESCE(SUM(t.gaps), 0) FROM files f LEFT JOIN topics t ON t.file = f.id "
    "WHERE f.to_ns >= $1 AND f.from_ns <= $2 AND ($3 = '' OR f.vehicle = $3) "
    "AND ($4 = '' OR t.topic = $4) GROUP BY f.id ORDER BY f.vehicle, f.from_ns, f.object";
constexpr const char* select_readings =
    "SELECT time_ns, x_m, y_m, signal_dbm, loss_percent, qni, battery_percent FROM link_readings "
    "WHERE time_ns >= $1 AND time_ns <= $2 AND ($3 = '' OR vehicle = $3) "
    "ORDER BY vehicle, time_ns";

std::int64_t whole(const std::string& text) { return std::strtoll(text.c_str(), nullptr, 10); }

/// 20261129 for a day since the Unix epoch.
std::string name_of_day(std::int64_t day) {
  return fmt::format("{:%Y%m%d}", fmt::gmtime(std::time_t{day * 86400}));
}

}  // namespace

RecordingIndex::RecordingIndex(std::unique_ptr<Database> database)
    : database_(std::move(database)) {
  make_tables();
}

void RecordingIndex::make_tables() {
  const bool sqlite = database_->dialect() == Dialect::sqlite;
  Transaction transaction(*database_);
  if (!sqlite) database_->run("SELECT pg_advisory_xact_lock($1)", {std::int64_t{table_lock}});
  for (const char* const statement : {make_files, make_files_by_time, make_topics}) {
    database_->run(statement);
  }
  // PostgreSQL has a table for each day, so that old days go at once, by DROP TABLE.
  database_->run(sqlite ? make_readings
                        : std::string(make_readings) + " PARTITION BY RANGE (time_ns)");
  database_->run(make_readings_by_time);
  const std::string make_view = sqlite ? "CREATE VIEW IF NOT EXISTS " : "CREATE OR REPLACE VIEW ";
  database_->run(make_view + link_readings);
  transaction.commit();
}

bool RecordingIndex::has(const std::string& id) {
  return !database_->run("SELECT 1 FROM files WHERE id = $1", {id}).empty();
}

void RecordingIndex::make_days(const Excerpt& excerpt) {
  if (database_->dialect() == Dialect::sqlite) return;
  std::set<std::int64_t> days;
  for (const Reading& one : excerpt.readings) days.insert(one.time_ns / day_ns);
  if (days.empty()) return;
  database_->run("SELECT pg_advisory_xact_lock($1)", {std::int64_t{table_lock}});
  for (const std::int64_t day : days) {
    database_->run(
        fmt::format("CREATE TABLE IF NOT EXISTS readings_{} PARTITION OF readings FOR "
                    "VALUES FROM ({}) TO ({})",
                    name_of_day(day), day * day_ns, (day + 1) * day_ns));
  }
}

void RecordingIndex::add(const Recording& recording, const Excerpt& excerpt) {
  Transaction transaction(*database_);
  make_days(excerpt);
  const auto added = database_->run(
      "INSERT INTO files (id, object, vehicle, host, run, bytes, from_ns, to_ns) "
      "VALUES ($1, $2, $3, $4, $5, $6, $7, $8) ON CONFLICT DO NOTHING RETURNING id",
      {recording.id, object_of(recording), recording.vehicle, recording.host, recording.run,
       static_cast<std::int64_t>(recording.bytes), excerpt.from_ns, excerpt.to_ns});
  if (added.empty()) return;  // another one was faster
  add_topics(recording.id, excerpt);
  add_readings(recording, excerpt);
  transaction.commit();
}

void RecordingIndex::add_topics(const std::string& id, const Excerpt& excerpt) {
  for (const TopicExcerpt& one : excerpt.topics) {
    database_->run(
        "INSERT INTO topics (file, topic, type, messages, from_ns, to_ns, gaps) "
        "VALUES ($1, $2, $3, $4, $5, $6, $7)",
        {id, one.topic, one.type, one.messages, one.from_ns, one.to_ns, one.gaps});
  }
}

void RecordingIndex::add_readings(const Recording& recording, const Excerpt& excerpt) {
  for (const Reading& one : excerpt.readings) {
    database_->run(
        "INSERT INTO readings (file, vehicle, time_ns, x_m, y_m, signal_dbm, loss_percent, qni, "
        "battery_percent) VALUES ($1, $2, $3, $4, $5, $6, $7, $8, $9)",
        {recording.id, recording.vehicle, one.time_ns, one.x_m, one.y_m, one.signal_dbm,
         one.loss_percent, one.qni, one.battery_percent});
  }
}

std::vector<IndexedFile> RecordingIndex::files(const IndexQuery& query) {
  std::vector<IndexedFile> files;
  for (const SqlRow& row :
       database_->run(select_files, {query.from_ns, query.to_ns, query.vehicle, query.topic})) {
    files.push_back(
        {row[0], whole(row[1]), whole(row[2]), whole(row[3]), whole(row[4]), whole(row[5])});
  }
  return files;
}

std::vector<Reading> RecordingIndex::readings(const IndexQuery& query) {
  std::vector<Reading> readings;
  for (const SqlRow& row :
       database_->run(select_readings, {query.from_ns, query.to_ns, query.vehicle})) {
    readings.push_back({whole(row[0]), sql_number(row[1]), sql_number(row[2]), sql_number(row[3]),
                        sql_number(row[4]), sql_number(row[5]), sql_number(row[6])});
  }
  return readings;
}

}  // namespace tocsin::archive
