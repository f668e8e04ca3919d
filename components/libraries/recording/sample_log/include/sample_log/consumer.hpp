// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foundation/folder_lock.hpp"
#include "foundation/state_file.hpp"
#include "sample_log/log_files.hpp"
#include "sample_log/log_follower.hpp"

namespace tocsin::sample_log {

/// Who reads a topic of a log, and whether the log remembers how far.
struct ConsumerName {
  std::string topic;  ///< with its slash
  std::string name;   ///< letters, digits, `_`, `-`, at most 64; empty: nothing is remembered
};

/// Reads a topic of a log in a folder, from the place that its name has got to, over all lives of
/// this process and of the one that writes the log; a name that is new begins at `start`.
///
/// What `read` gave and `commit` did not tell is given again to the next life: each sample at least
/// once, and exactly once to who handles and commits in one step. The place of a name is in
/// `consumers/NAME` of the log's folder, in a file that a kill -9 leaves whole; after a power cut
/// it may be older. One thread; blocks as a disk does: use it in a Background.
class Consumer {
 public:
  /// Throws ConfigError for a name that is none, when another process is this consumer of the
  /// topic, and when its place cannot be kept.
  Consumer(const std::string& folder, const ConsumerName& who, const LogStart& start);

  /// What follows, `most` samples or a few more; empty when nothing has come.
  [[nodiscard]] std::vector<LogSample> read(std::size_t most = 1000) { return log_.read(most); }
  /// All that `read` gave is done with. False: it could not be written; to be tried again.
  [[nodiscard]] bool commit();
  /// Whether samples that it was to get are, or may be, gone: the log's bounds took them. Tells it
  /// once.
  [[nodiscard]] bool take_gap() { return log_.take_gap(); }
  /// Whether its name was known, so that `start` did not count.
  [[nodiscard]] bool is_back() const { return is_back_; }

 private:
  /// `own`: the folder of its place, which is made; empty: it has none.
  Consumer(const std::string& folder, const ConsumerName& who, const LogStart& start,
           const std::string& own);

  const FolderSource files_;
  std::optional<FolderLock> lock_;
  StateFile state_;
  std::optional<std::uint64_t> known_;  ///< the place that is written
  const bool is_back_;
  LogFollower log_;
};

}  // namespace tocsin::sample_log
