// SPDX-License-Identifier: Apache-2.0
#include "network_monitor/wireless_trend.hpp"

#include <algorithm>

namespace tocsin::network {
namespace {

/// Growth of a counter; empty when it is not counted or was reset.
template <class Number>
std::optional<double> growth(const std::optional<Number>& from, const std::optional<Number>& to) {
  if (!from || !to || *to < *from) return std::nullopt;
  return static_cast<double>(*to - *from);
}

std::optional<double> percent(std::optional<double> part, std::optional<double> whole) {
  if (!part || !whole || *whole <= 0) return std::nullopt;
  return std::clamp(100.0 * *part / *whole, 0.0, 100.0);
}

}  // namespace

WirelessRates WirelessTrend::update(const WirelessReading& reading) {
  const auto packets = growth(last_.tx_packets, reading.tx_packets);
  const auto retries = growth(last_.tx_retries, reading.tx_retries);
  const auto sent = packets && retries ? std::optional(*packets + *retries) : std::nullopt;
  WirelessRates rates;
  rates.retry_percent = percent(retries, sent);
  rates.busy_percent = percent(growth(last_.channel_busy_ms, reading.channel_busy_ms),
                               growth(last_.channel_time_ms, reading.channel_time_ms));
  last_ = reading;
  return rates;
}

}  // namespace tocsin::network
