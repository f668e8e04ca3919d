// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/absent_devices.hpp"
#include "radio_link.hpp"
#include "sim_base.hpp"

namespace tocsin::simulation {

/// The devices of one simulated host: the bases on it, its radio, and what /proc would tell.
class SimDevices final : public AbsentDevices {
 public:
  /// Whose devices they are.
  struct Place {
    std::string host;
    radio::Direction direction;  ///< of what it sends
  };
  /// `wireless_file`: second path of the text of /proc/net/wireless.
  SimDevices(Core& core, RadioLink& link, const Place& place, std::string wireless_file);

  /// Components keep files for a restart.
  void keep_files() { keeps_files_ = true; }
  [[nodiscard]] bool keeps_files() const override { return keeps_files_; }
  void add_base(SimBase& base) { bases_.push_back(&base); }
  /// Echo requests to this address are answered by the other side.
  void add_peer(const std::string& address) { peers_.push_back(address); }

  OpenedSerial open_serial(const std::string& path, Readable readable) override;
  /// Throws ConfigError when `target` is no IPv4 address, as the real one does.
  std::unique_ptr<EchoDevice> open_echo(const EchoTarget& target, Readable readable) override;
  /// Knows what `file` tells of an interface; its kernel tells nothing more.
  std::unique_ptr<network::WirelessDevice> open_wireless(const std::string& interface,
                                                         const std::string& file) override;
  /// /proc/meminfo and /proc/stat of an invented computer: 1 GB, a quarter of one core busy.
  std::optional<std::string> read_text(const std::string& path) override;

 private:
  [[nodiscard]] std::string stat_text() const;
  Core& core_;
  RadioLink& link_;
  Place place_;
  std::string wireless_file_;
  bool keeps_files_ = false;
  std::vector<SimBase*> bases_;
  std::vector<std::string> peers_;
};

}  // namespace tocsin::simulation
