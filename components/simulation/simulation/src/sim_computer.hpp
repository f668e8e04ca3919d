// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/computer.hpp"
#include "devices/echo_device.hpp"
#include "devices/true_pose.hpp"
#include "devices/wireless.hpp"
#include "radio_link.hpp"
#include "sim_base.hpp"

namespace tocsin::simulation {

/// The computer of one simulated host. Its devices are the bases on it, its radio, and what /proc
/// would tell; it must outlive them.
class SimComputer final : public Computer {
 public:
  /// Whose it is.
  struct Place {
    std::string host;
    radio::Direction direction;  ///< of what it sends
    std::size_t vehicle = 0;     ///< of several that or whose station it is
  };
  /// `wireless_file`: second path of the text of /proc/net/wireless.
  SimComputer(Core& core, RadioLink& link, const Place& place, std::string wireless_file);
  SimComputer(const SimComputer&) = delete;
  SimComputer& operator=(const SimComputer&) = delete;

  void add_base(SimBase& base) { bases_.push_back(&base); }
  /// Echo requests to this address are answered by the other side.
  void add_peer(const std::string& address) { peers_.push_back(address); }

  /// /proc/net/wireless, and /proc/meminfo and /proc/stat of an invented computer: 1 GB, a quarter
  /// of one core busy. Empty for other paths.
  [[nodiscard]] std::optional<std::string> read_file(const std::string& path) const;

 private:
  [[nodiscard]] OpenedSerial open_serial(const std::string& path, Devices::Readable readable);
  [[nodiscard]] std::unique_ptr<EchoDevice> open_echo(const EchoTarget& target,
                                                      Devices::Readable readable);
  [[nodiscard]] std::string stat_text() const;
  Core& core_;
  RadioLink& link_;
  Place place_;
  std::string wireless_file_;
  std::vector<SimBase*> bases_;
  std::vector<std::string> peers_;
};

}  // namespace tocsin::simulation
