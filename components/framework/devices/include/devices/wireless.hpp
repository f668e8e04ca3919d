// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "devices/device.hpp"

namespace tocsin::network {

/// Where a reading comes from. `absent`: nothing to read, the note says why.
enum class WirelessSource { absent, proc, nl80211 };

/// The word for messages and logs: "absent", "proc" or "nl80211".
[[nodiscard]] const char* name(WirelessSource source);

/// What the wireless interface tells about its link. Each empty field was not told, or was told as
/// invalid; none is ever guessed. Counters are those of the driver, since association.
struct WirelessReading {
  WirelessSource source = WirelessSource::absent;
  bool associated = false;
  std::string note;                      ///< why values are missing; empty when all is well
  std::optional<double> signal_dbm;      ///< last received frame
  std::optional<double> signal_avg_dbm;  ///< the kernel's moving average
  std::optional<double> noise_dbm;
  std::optional<double> quality;  ///< [1] 0 to 70, see `link_quality`
  std::optional<double> tx_bitrate_mbps;
  std::optional<double> expected_throughput_mbps;
  std::optional<std::uint64_t> tx_packets;
  std::optional<std::uint64_t> tx_retries;
  std::optional<std::uint64_t> tx_failed;  ///< proc: discarded for excessive retries
  std::optional<std::uint64_t> beacon_loss;
  std::optional<double> channel_time_ms;  ///< time the radio spent on the channel in use
  std::optional<double> channel_busy_ms;  ///< of it, sensed busy
};

/// An interface, and the file in the format of /proc/net/wireless for what the kernel cannot tell.
struct WirelessAddress {
  std::string interface;
  std::string file;
};

/// A wireless interface.
class WirelessDevice : public Device {
 public:
  static constexpr const char* kind = "wireless interface";
  using Address = WirelessAddress;
  [[nodiscard]] static std::string text(const Address& address) { return address.interface; }
  /// What it tells now. Never throws, blocks well below 1 ms; what cannot be read is absent, with
  /// the reason.
  [[nodiscard]] virtual WirelessReading read();
};

/// The largest `quality`.
inline constexpr double link_quality_max = 70.0;

/// Link Quality as the kernel derives it from the signal: clamp(signal, -110, -40) + 110, 0 to 70
/// (Linux 6.12, net/wireless/wext-compat.c, cfg80211_wireless_stats). It says nothing about
/// interference. A signal that is NaN has quality 0.
[[nodiscard]] double link_quality(double signal_dbm);

/// A reading that holds nothing but the reason.
[[nodiscard]] WirelessReading absent(std::string note);

/// The line of `interface` in the text of /proc/net/wireless. Without such a line the reading is
/// absent. Traps of the format: noise -256 means invalid; an unassociated interface prints zeros
/// without dots; a level that is not negative is in the driver's own unit, not in dBm.
[[nodiscard]] WirelessReading parse_proc_wireless(const std::string& text,
                                                  const std::string& interface);

}  // namespace tocsin::network
