// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "foundation/time.hpp"
#include "runtime/fast_dds/names.hpp"
#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {

/// Holds back heartbeats and acknowledgements of discovery that follow each other too closely for a
/// radio; of those that are held only the newest is sent.
///
/// Fast DDS 2.9.1 answers each heartbeat of discovery after 10 us with all that is missing, and
/// sends all of that again after 100 us, what is still under way included: over a radio each
/// endpoint crossed twice, with a heartbeat and an acknowledgement of its own, and a router that
/// came back waited for all of it. Pure; `now` never decreases.
class DiscoveryPacer {
 public:
  /// From a heartbeat of one writer to its next.
  static constexpr Duration heartbeat_period = std::chrono::milliseconds(10);
  /// From an acknowledgement of one reader to its next: what it asks for is under way for so long.
  static constexpr Duration acknowledgement_period = std::chrono::milliseconds(50);

  struct Held {
    std::vector<std::uint8_t> message;
    eprosima::fastdds::rtps::Locator_t to;
  };

  /// Whether a message of this key is to be sent now. If not it is kept for `take_due`.
  [[nodiscard]] bool passes(const StateKey& key, const Held& message, Time now);
  /// A message that was kept and is to be sent now.
  [[nodiscard]] std::optional<Held> take_due(Time now);
  /// When there will be one; `never` when none is kept.
  [[nodiscard]] Time deadline() const;

 private:
  struct State {
    Time next{};  ///< nothing goes before
    std::optional<Held> held;
  };
  void forget_idle(Time now);
  std::map<std::pair<StateKey, eprosima::fastdds::rtps::Locator_t>, State> states_;
};

}  // namespace tocsin
