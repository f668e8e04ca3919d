// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "foundation/instant.hpp"
#include "mcap/format.hpp"
#include "sample_log/ledger.hpp"
#include "sample_log/log_files.hpp"
#include "sample_log/sample_id.hpp"
#include "sample_log/sample_set.hpp"

namespace tocsin::sample_log {

/// What a log must know of a topic so that a later life can go on with it, and other tools read it.
struct LoggedStream {
  std::string name;  ///< over all lives; stream_key() of it is the stream's number
  std::string topic;
  mcap::Schema schema;  ///< its id does not count
  mcap::KeyValues facts;
};

struct LogEntry {
  SampleId id;
  std::int64_t sent_wall_ns = 0;  ///< [ns] since the Unix epoch, writer's clock
  std::vector<std::uint8_t> bytes;
};

struct LogLimits {
  std::uint64_t bytes = 64U << 20U;  ///< [byte] of all segments; the oldest goes beyond it
  Duration age = std::chrono::hours(24);
};

/// What a log is for.
enum class LogUse : std::uint8_t {
  queue,   ///< what comes waits until it is confirmed
  history  ///< what comes is kept, and waits from the time that `find` has named it
};

/// What is in a log of a topic.
struct LoggedSpan {
  std::string topic;
  std::uint64_t samples = 0;
  std::uint64_t first_ns = 0;  ///< when the oldest came, since the Unix epoch; rises
  std::uint64_t last_ns = 0;
};

/// Samples of a topic that came in a time.
struct LogQuery {
  std::string topic;
  std::uint64_t from_ns = 0;  ///< since the Unix epoch, both included
  std::uint64_t to_ns = 0;
  std::size_t most = 4096;  ///< samples that are named at once
};
struct LogFinding {
  std::vector<SampleId> ids;             ///< in the order of the log
  std::optional<std::uint64_t> next_ns;  ///< from where to look on, when there were too many
};

/// What became of an entry.
enum class Logged : std::uint8_t {
  kept,
  waiting,    ///< it is in the log, and a queue's is not confirmed: nothing was done
  confirmed,  ///< it was confirmed before: nothing was done
  refused     ///< there is no room, or the folder cannot be written
};

/// A bounded log of samples: MCAP files that every tool opens, one after the other, of which the
/// oldest goes when there are too many bytes or it is too old. It knows which samples have been
/// confirmed, over all lives; what was appended and confirmed survives a kill -9.
///
/// A queue has an index of what waits in memory; a history, which may hold very many samples, only
/// of what `find` has named, and the numbers of all as a SampleSet. Each sample is in it once.
///
/// Segments are never changed: one that was cut is read up to the cut, a damaged chunk is left out
/// with a line in problems(). Ages of this life's segments are counted by the steady clock, so that
/// a set clock takes nothing away. Nothing throws. One thread.
class SampleLog {
 public:
  /// Reads what earlier instances left.
  SampleLog(LogFiles& files, const LogLimits& limits, Instant at, LogUse use = LogUse::queue);
  ~SampleLog();
  SampleLog(const SampleLog&) = delete;
  SampleLog& operator=(const SampleLog&) = delete;

  /// A stream must be known before its entries; again changes nothing.
  void add(const LoggedStream& stream);
  /// By stream_key, also those of earlier lives.
  [[nodiscard]] const std::map<std::uint64_t, LoggedStream>& streams() const { return streams_; }

  /// In the order of the entries. All or none of those that are new are kept.
  [[nodiscard]] std::vector<Logged> append(const std::vector<LogEntry>& entries, Instant at);
  /// These are on the other side. They stay in their segments, but are not waited for any more.
  void confirm(const std::vector<SampleId>& ids);
  /// Those of a query that are not confirmed; they wait from then on. Reads files.
  [[nodiscard]] LogFinding find(const LogQuery& query);
  /// These are not waited for any more, though nobody has confirmed them.
  void forget(const std::vector<SampleId>& ids);
  /// By topic.
  [[nodiscard]] std::vector<LoggedSpan> contents() const;
  /// Those that are waited for and not confirmed, in the order in which they came.
  [[nodiscard]] std::vector<SampleId> waiting() const;
  /// In the order of the log; those that are gone or damaged are left out.
  [[nodiscard]] std::vector<LogEntry> read(const std::vector<SampleId>& ids);
  /// Removes the segments that are beyond the limits. Those of their samples that were still
  /// waiting.
  [[nodiscard]] std::vector<SampleId> retire(Time now);
  /// All that was appended and confirmed survives a power cut from then on. May block for long.
  void sync();

  /// [byte] Of all segments.
  [[nodiscard]] std::uint64_t bytes() const;
  /// What went wrong since the last call, for people.
  [[nodiscard]] std::vector<std::string> take_problems() { return std::exchange(problems_, {}); }

 private:
  struct Segment {
    std::string file;
    std::uint64_t number = 0;
    std::uint64_t bytes = 0;
    Time written{};                           ///< when something was appended last
    std::map<std::string, LoggedSpan> spans;  ///< by topic
  };
  struct Place {
    std::uint64_t segment = 0;
    std::uint64_t log_time_ns = 0;  ///< rises from sample to sample, over all segments
  };
  class Active;
  void recover(const std::string& file, std::uint64_t number, Instant at);
  /// Throws ConfigError when it is no MCAP file.
  void index(std::unique_ptr<mcap::ByteSource> source, Segment& segment);
  [[nodiscard]] bool begin_segment();
  /// How long the last segment is; it is closed when that is enough.
  void measure_segment();
  /// One that was appended to the last segment.
  void note(const SampleId& id, std::uint64_t log_time_ns);
  void read(const Segment& segment, const std::map<std::uint64_t, SampleId>& wanted,
            std::vector<LogEntry>& found);
  void find(const Segment& segment, const LogQuery& query, LogFinding& finding);
  void remove_oldest(std::vector<SampleId>& retired);

  LogFiles& files_;
  const LogLimits limits_;
  const LogUse use_;
  Ledger confirmed_;
  std::map<std::uint64_t, LoggedStream> streams_;
  std::deque<Segment> segments_;
  std::unique_ptr<Active> active_;  ///< the last of segments_; null: none is being written
  std::map<SampleId, Place> waiting_;
  SampleSet known_;  ///< of a history: what is in it, or was
  std::uint64_t last_number_ = 0;
  std::uint64_t last_log_time_ns_ = 0;
  bool refuses_ = false;  ///< the last attempt to write failed
  std::vector<std::string> problems_;
};

}  // namespace tocsin::sample_log
