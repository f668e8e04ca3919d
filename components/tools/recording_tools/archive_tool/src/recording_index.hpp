// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "database.hpp"
#include "excerpt.hpp"
#include "recordings.hpp"

namespace tocsin::archive {

/// What is asked of an index; both times included.
struct IndexQuery {
  std::string vehicle;  ///< empty: all
  std::string topic;    ///< with the slash; empty: all
  std::int64_t from_ns = 0;
  std::int64_t to_ns = std::numeric_limits<std::int64_t>::max();
};

/// A recording of the archive.
struct IndexedFile {
  std::string object;
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  std::int64_t bytes = 0;
  std::int64_t messages = 0;  ///< of the asked topic, else of all
  std::int64_t gaps = 0;      ///< the same
};

/// What is in which recording, and plain numbers of each second, in a database that others ask by
/// SQL, too: tables files, topics and readings, and the view link_readings, in which a second that
/// several hosts recorded stands once. Throws EnvironmentError for what the engine says. One
/// thread.
class RecordingIndex {
 public:
  /// Makes the tables that are not there.
  explicit RecordingIndex(std::unique_ptr<Database> database);

  [[nodiscard]] bool has(const std::string& id);
  /// All of it or nothing; nothing when it is there.
  void add(const Recording& recording, const Excerpt& excerpt);

  /// By vehicle and time.
  [[nodiscard]] std::vector<IndexedFile> files(const IndexQuery& query);
  /// Of link_readings, by vehicle and time. `topic` of the query does not matter.
  [[nodiscard]] std::vector<Reading> readings(const IndexQuery& query);

 private:
  void make_tables();
  void make_days(const Excerpt& excerpt);
  void add_topics(const std::string& id, const Excerpt& excerpt);
  void add_readings(const Recording& recording, const Excerpt& excerpt);

  std::unique_ptr<Database> database_;
};

}  // namespace tocsin::archive
