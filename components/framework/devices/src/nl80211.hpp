// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "devices/wireless.hpp"

struct nl_msg;
struct nl_sock;

namespace tocsin::network {

/// The channel part of a survey message.
struct Survey {
  bool in_use = false;
  std::optional<double> noise_dbm;
  std::optional<double> time_ms;
  std::optional<double> busy_ms;
};

/// The station of an NL80211_CMD_NEW_STATION message (in managed mode: the access point). Empty
/// when the message is of another kind or damaged.
[[nodiscard]] std::optional<WirelessReading> parse_station(nl_msg* message);

/// The channel of an NL80211_CMD_NEW_SURVEY_RESULTS message; empty as above.
[[nodiscard]] std::optional<Survey> parse_survey(nl_msg* message);

/// Adds the values of the channel in use; a survey of another channel changes nothing.
void add_survey(const Survey& survey, WirelessReading& reading);

/// Asks the kernel. Each call of `read` blocks for two local round trips, well below 1 ms.
class Nl80211Reader {
 public:
  /// Never throws on a kernel without nl80211: `read` then says so.
  Nl80211Reader();
  ~Nl80211Reader();
  Nl80211Reader(const Nl80211Reader&) = delete;
  Nl80211Reader& operator=(const Nl80211Reader&) = delete;

  /// The link of `interface`; of several stations (access point, ad hoc) the first.
  [[nodiscard]] WirelessReading read(const std::string& interface);

 private:
  nl_sock* socket_ = nullptr;
  int family_ = -1;
};

}  // namespace tocsin::network
