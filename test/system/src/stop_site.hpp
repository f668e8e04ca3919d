// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "foundation/temporary_folder.hpp"
#include "peer.hpp"
#include "stack.hpp"

namespace tocsin {

/// DDS domain of the vehicle's host in bringup/mission.yaml; the station's and the link's follow.
inline constexpr int site_domain = 40;
inline constexpr const char* vehicle_address = "10.77.0.1";
inline constexpr const char* station_address = "10.77.0.2";

/// Somebody who turns the vehicle on the spot, past all components, so that it moves unless the
/// driver holds the stop.
[[nodiscard]] std::function<void(Bus&)> turn_on_the_spot();

/// A person at the station: asks ten times a second for what was typed last.
class StationPerson {
 public:
  explicit StationPerson(pid_t station);
  ~StationPerson();
  StationPerson(const StationPerson&) = delete;
  StationPerson& operator=(const StationPerson&) = delete;
  void wants(bool stop) const;

 private:
  [[nodiscard]] std::function<void(Bus&)> asks() const;
  const std::array<int, 2> pipe_;
  const Peer peer_;
};

struct StopSiteOptions {
  bool loses = false;    ///< 30 % of the packets
  bool secured = false;  ///< a link with a keystore
  int disk_mib = 0;      ///< of the run folder; 0: as large as there is
};

/// A vehicle without a mission and its station, over the emulated radio. It turns on the spot.
class StopSite {
 public:
  /// Throws std::runtime_error with what the launcher said when it does not move.
  explicit StopSite(const StopSiteOptions& options);
  /// [s] from the press to the last turn of a wheel that is followed by a second of rest; none: it
  /// did not stop.
  [[nodiscard]] std::optional<double> press() const;
  /// Whether it moves then.
  [[nodiscard]] bool release() const;
  [[nodiscard]] bool moves(std::chrono::seconds limit) const;
  [[nodiscard]] const Stack& stack() const { return *stack_; }
  [[nodiscard]] Stack& stack() { return *stack_; }

 private:
  const TemporaryFolder folder_;
  std::unique_ptr<Stack> stack_;
  std::string wheels_;
  std::optional<Peer> watch_;
  std::optional<Peer> rogue_;
  std::optional<StationPerson> person_;
};

}  // namespace tocsin
