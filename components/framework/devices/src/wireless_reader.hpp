// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "devices/wireless.hpp"
#include "nl80211.hpp"

namespace tocsin::network {

/// Reads one interface: from nl80211 when it knows the interface, else from a file in the format
/// of /proc/net/wireless. An interface that is not there or is down has no reading, whatever a file
/// says.
class WirelessReader final : public WirelessDevice {
 public:
  WirelessReader(std::string interface, std::string proc_path);
  [[nodiscard]] WirelessReading read() override;

 private:
  [[nodiscard]] WirelessReading read_file() const;

  std::string interface_;
  std::string path_;
  Nl80211Reader nl80211_;
};

}  // namespace tocsin::network
