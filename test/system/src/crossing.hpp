// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foundation/temporary_folder.hpp"
#include "peer.hpp"
#include "shared.hpp"
#include "stack.hpp"

namespace tocsin {

/// One sample that crossed, by the wall clock of this computer [ns since the epoch].
struct Crossed {
  std::int64_t sent_ns;
  std::int64_t received_ns;
};

/// DDS domain of the vehicle in a standing mission; the station's is the next, the link's follows.
constexpr int standing_domain = 40;

/// Writes a bringup file that is bringup/mission.yaml without mission and live view, with this
/// traffic file. `more` is its end: first keys of `hosts`, indented, then others. Returns its path.
[[nodiscard]] std::string standing(const std::string& folder, const std::string& traffic,
                                   const std::string& more = "");
/// The same with a traffic file in which the topics of Crossings are of class critical, and the
/// vehicle's crossing/latest (kept while poor) and crossing/image (dropped) of high and low.
[[nodiscard]] std::string standing_mission(const std::string& folder, const std::string& more = "");

/// Whether the routers of both hosts run within a minute.
[[nodiscard]] bool routers_run(const Stack& stack);

/// Samples of class critical that go over the link both ways, 200 a second, written and read by
/// ordinary peers of both hosts that belong to no launch.
class Crossings {
 public:
  static constexpr double lifespan_s = 0.3;  ///< of each sample
  static constexpr std::size_t most_stations = 2;
  enum class Way : std::uint8_t { up, down };  ///< from the vehicle, to it

  /// `vehicle` and `station` are processes of the hosts, `domain` the vehicle's, the station's is
  /// the next.
  Crossings(pid_t vehicle, pid_t station, int domain);
  /// The same with several stations, whose domains follow each other; at most most_stations.
  Crossings(pid_t vehicle, const std::vector<pid_t>& stations, int domain);
  ~Crossings();
  Crossings(const Crossings&) = delete;
  Crossings& operator=(const Crossings&) = delete;

  /// All that crossed so far, at whatever station, in the order of arrival.
  [[nodiscard]] std::vector<Crossed> all(Way way) const;
  /// The first to arrive of those that were written after `sent_ns`.
  [[nodiscard]] std::optional<Crossed> first_after(Way way, std::int64_t sent_ns) const;
  /// Of those that were written after `sent_ns`, whether one has come to this station.
  [[nodiscard]] bool has_come(std::size_t station, std::int64_t sent_ns) const;
  /// [s] The longest time in which nothing arrived, from then until now.
  [[nodiscard]] double longest_gap_s(Way way, std::int64_t from_ns) const;

 private:
  struct Log;
  using Logs = std::array<Log, 1 + most_stations>;  ///< of the vehicle, then of each station
  void start(pid_t process, int host_domain, Way from, Log& log);
  TemporaryFolder folder_;
  std::string qos_file_;
  const std::unique_ptr<Shared<Logs>> logs_;
  std::vector<std::unique_ptr<Peer>> peers_;
};

/// [ns] since the epoch.
[[nodiscard]] std::int64_t wall_now_ns();

/// How long after the death of a router samples crossed again, each way.
struct Recovery {
  std::int64_t killed_ns;  ///< since the epoch
  double up_s;
  double down_s;
};
/// Kills a process of the launch with -9. Nothing when not both ways crossed again within 20 s.
[[nodiscard]] std::optional<Recovery> kill_and_time(const Stack& stack, const std::string& process,
                                                    const Crossings& crossings);

}  // namespace tocsin
