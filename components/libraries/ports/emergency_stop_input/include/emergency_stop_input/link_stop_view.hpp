// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin {

/// What the host's router reports of the emergency stop on topic::LinkStop, and what its silence
/// means.
///
/// A stop stands while the last message says so. A router that has been received once and then not
/// for `silent_after` is a stop, too: the vehicle must not drive where a stop has no way to it.
/// Before the first message nothing stands, as a host without a router has none to expect.
///
/// Pure; `now` must not decrease.
class LinkStopView {
 public:
  struct Values {
    bool stands = false;
    std::vector<std::string> stopped_by;
    std::uint64_t releases = 0;  ///< rises with each release by people at the station
  };
  /// What a process keeps for its successor.
  struct Memory {
    bool stands = false;   ///< by the last message, or by silence
    bool expects = false;  ///< a message has been received
  };
  static constexpr Duration silent_after = std::chrono::seconds(1);
  static constexpr const char* silent_name = "link_router is silent";
  static constexpr const char* kept_name = "link, before a restart";

  /// True when people have released since the message before. The first message, and a number that
  /// falls (of a router that was restarted), release nothing.
  [[nodiscard]] bool on_message(Values values, Time now);
  /// What stood when an earlier process of this listener died stands until the first message. That
  /// one must be received within `silent_after` if that process had received any.
  void restore(const Memory& memory, Time now);

  [[nodiscard]] bool stands(Time now) const;
  /// Names of those whose stops stand; never empty while one stands.
  [[nodiscard]] std::vector<std::string> stopped_by(Time now) const;
  /// When silence begins unless a message is received; `never` once it has begun.
  [[nodiscard]] Time deadline(Time now) const;
  [[nodiscard]] Memory memory(Time now) const { return {stands(now), last_.has_value()}; }

 private:
  [[nodiscard]] bool is_silent(Time now) const { return last_ && now - *last_ >= silent_after; }
  Values values_;
  std::optional<Time> last_;  ///< when the last message was received, or was first expected
  bool received_ = false;     ///< a message, so that `values_.releases` is known
};

}  // namespace tocsin
