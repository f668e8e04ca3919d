// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "emergency_stop_input/emergency_stop_latch.hpp"
#include "link_router/stop_speaker.hpp"
#include "router_stop.hpp"

namespace tocsin {

/// A station: whoever presses on its host stops the vehicles, by the rule of EmergencyStopLatch.
class StationStop final : public RouterStop::Side {
 public:
  StationStop(Component& owner, const StopKeysFile::Content& kept);
  void take(const StopNews& news, Time now) override;
  void fill(StopValue& value, Time now) override;
  void fill(topic::LinkStop::Message& message, Time now) override;
  [[nodiscard]] StopKeysFile::Content kept() const override;

 private:
  /// What a vehicle has reported last.
  struct Report {
    bool known = false;
    bool stands = false;
    std::vector<std::string> by;
    Time received{};
  };
  void take_host(Time now);
  [[nodiscard]] EmergencyStopLatch::Writer writer(std::uint64_t source) const;

  OptionalInput<topic::EmergencyStop> stop_;
  OptionalInput<topic::EmergencyStopRequest> request_;
  EmergencyStopLatch latch_;
  router::StopSpeaker speaker_;
  std::map<std::string, Report> reports_;  ///< by host
};

}  // namespace tocsin
