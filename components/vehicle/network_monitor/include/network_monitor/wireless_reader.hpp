// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "network_monitor/nl80211.hpp"
#include "network_monitor/wireless.hpp"

namespace tocsin::network {

/// Reads one interface: from nl80211 when it knows the interface, else from a file in the format
/// of /proc/net/wireless. An interface that is not there or is down has no reading, whatever a file
/// says. Never throws; what cannot be read is absent, with the reason.
class WirelessReader {
 public:
  /// An empty `interface` means that the vehicle has no radio: every reading is absent.
  WirelessReader(std::string interface, std::string proc_path);
  /// Of a simulated computer: `read_text` gives the text of the file, and nobody else is asked.
  using ReadText = std::function<std::optional<std::string>(const std::string& path)>;
  WirelessReader(std::string interface, std::string proc_path, ReadText read_text);

  [[nodiscard]] WirelessReading read();

 private:
  [[nodiscard]] WirelessReading read_simulated() const;
  [[nodiscard]] WirelessReading read_file() const;

  std::string interface_;
  std::string path_;
  ReadText read_text_;
  std::optional<Nl80211Reader> nl80211_;  ///< not in a simulation
};

}  // namespace tocsin::network
