// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "peer.hpp"
#include "shared.hpp"

namespace tocsin {

/// A sample that a reader of the station got, by the wall clock of this computer.
struct GotSample {
  std::uint32_t topic = 0;  ///< index in the list of topics
  bool backfilled = false;
  std::uint64_t source = 0;
  std::uint64_t sequence = 0;
  std::int64_t at_ns = 0;  ///< since the Unix epoch
};

/// Readers of stored topics and of what is backfilled of them on the station, which belong to no
/// launch. What they get is in memory that they share with this process.
class StationReaders {
 public:
  /// `station`: a process of the host, `domain` the host's, `qos` a file with profile `event`.
  /// Topics are of this stack, without the slash.
  StationReaders(pid_t station, int domain, const std::string& qos,
                 const std::vector<std::string>& topics);
  [[nodiscard]] std::vector<GotSample> got() const;

 private:
  static constexpr std::size_t most = 1U << 18U;
  struct Samples {
    std::atomic<std::size_t> claimed{0};
    std::array<GotSample, most> samples{};
    std::array<std::atomic<bool>, most> written{};
  };
  class Reading;
  Shared<Samples> shared_;
  std::unique_ptr<Peer> peer_;
};

/// A sample in the log of the vehicle's router.
struct LoggedOne {
  std::uint64_t source = 0;
  std::uint64_t sequence = 0;
  std::int64_t at_ns = 0;  ///< when it came to the log, since the Unix epoch
};
/// All of a topic, without the slash, in the log in a folder.
[[nodiscard]] std::vector<LoggedOne> logged_in(const std::string& folder, const std::string& topic);

/// What became of one topic until a time.
struct StoredTopicFigures {
  std::size_t logged = 0;      ///< on the vehicle, from the readers' first sample on
  std::size_t unrouted = 0;    ///< written between these while the vehicle had no router
  std::size_t live = 0;        ///< of these, first seen live by the readers
  std::size_t backfilled = 0;  ///< and backfilled
  std::size_t missing = 0;     ///< not in the station's log
  std::size_t unheard = 0;     ///< there, and no reader got it: the router was new to them
  std::size_t twice = 0;
  std::size_t disordered = 0;  ///< live or backfilled before an older one of its writer
  std::int64_t last_ns = 0;    ///< when the last of these came, since the Unix epoch
};
/// The logs of both sides.
struct BothLogs {
  std::vector<LoggedOne> vehicle;
  std::vector<LoggedOne> station;
};
/// Of the samples that came to the vehicle's log until `end_ns`.
[[nodiscard]] StoredTopicFigures figures_of(std::uint32_t topic, const BothLogs& logs,
                                            const std::vector<GotSample>& got, std::int64_t end_ns);

}  // namespace tocsin
