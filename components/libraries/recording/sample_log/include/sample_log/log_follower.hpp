// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mcap/tail.hpp"
#include "sample_log/log_files.hpp"
#include "sample_log/sample_log.hpp"

namespace tocsin::sample_log {

/// Where to begin in a log.
struct LogStart {
  enum class From : std::uint8_t {
    end,        ///< with the next sample that comes to the log
    beginning,  ///< with the oldest that is there
    last,       ///< with the last `value` samples of the topic
    time,       ///< with the first that came at `value` or later, [ns] since the Unix epoch
    after       ///< with the first behind the place `value`
  };
  From from = From::end;
  std::uint64_t value = 0;
};

/// A sample as the log has it.
struct LogSample {
  SampleId id;
  const LoggedStream* stream = nullptr;  ///< of the follower that gave it
  /// Its place in the log, which is also when it came there, [ns] since the Unix epoch. Rises from
  /// sample to sample over all segments and lives of the log.
  std::uint64_t place = 0;
  std::int64_t sent_wall_ns = 0;  ///< [ns] since the Unix epoch, writer's clock
  std::vector<std::uint8_t> bytes;
};

/// Reads one topic of a log while another process writes it: from a place in the past up to now,
/// and then what comes, each sample once and in the order of the log. There is no border between
/// old and new, as all of it is read from the log. One thread; blocks as a disk does.
class LogFollower {
 public:
  /// `topic` with its slash. `files` must outlive it. Nothing throws.
  LogFollower(const LogSource& files, std::string topic, const LogStart& start);

  /// What follows, `most` samples or a few more; empty when nothing has come.
  [[nodiscard]] std::vector<LogSample> read(std::size_t most);
  /// Where it is: behind the last sample that `read` gave.
  [[nodiscard]] std::uint64_t place() const { return place_; }
  /// Whether samples between its place and those that it could give are, or may be, gone: the log's
  /// bounds took them. Tells it once.
  [[nodiscard]] bool take_gap() { return std::exchange(has_gap_, false); }
  /// Chunks that were left out.
  [[nodiscard]] std::uint64_t damaged() const { return damaged_; }

 private:
  using Numbers = std::set<std::uint64_t>;
  [[nodiscard]] Numbers segments() const;
  /// Puts it in front of the `count` last samples of the topic.
  void go_before_last(std::uint64_t count);
  void go_to_end();
  /// The segment in which the place is; the first when it is in none.
  void find_segment();
  /// Whether the segment has no more for now or ever.
  [[nodiscard]] bool read_segment(std::size_t most, std::vector<LogSample>& came);
  void take(const mcap::Channel& channel, const mcap::Message& message,
            std::vector<LogSample>& came);
  void begin(std::uint64_t segment);

  const LogSource& files_;
  const std::string topic_;
  std::uint64_t place_ = 0;
  std::uint64_t segment_ = 0;  ///< 0: none was there yet
  std::optional<mcap::Tail> tail_;
  bool is_read_ = false;  ///< all of a segment that was closed
  std::map<std::uint64_t, LoggedStream> streams_;
  std::uint64_t damaged_ = 0;
  bool has_gap_ = false;
};

/// The topics of which a log has samples, with their slashes. Reads all segments; those that cannot
/// be read are left out.
[[nodiscard]] std::set<std::string> topics_in(const LogSource& files);

}  // namespace tocsin::sample_log
