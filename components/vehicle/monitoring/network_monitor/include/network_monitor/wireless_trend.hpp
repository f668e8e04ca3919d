// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "devices/wireless.hpp"

namespace tocsin::network {

/// What the counters of an interface say about the time between two readings.
struct WirelessRates {
  /// [%] [0, 100] retransmissions of all transmissions: 100 retries / (retries + packets). Empty
  /// when the driver does not count, or when nothing was sent in between.
  std::optional<double> retry_percent;
  /// [%] [0, 100] share of the time on the channel in which it was busy: utilisation by everybody.
  std::optional<double> busy_percent;
};

/// Differences of the counters of consecutive readings. Pure.
class WirelessTrend {
 public:
  /// The rates since the last call. All empty at the first one, and after counters were reset
  /// (new association).
  [[nodiscard]] WirelessRates update(const WirelessReading& reading);

 private:
  WirelessReading last_;
};

}  // namespace tocsin::network
