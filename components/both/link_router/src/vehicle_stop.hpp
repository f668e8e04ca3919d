// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "link_router/stop_listener.hpp"
#include "router_stop.hpp"

namespace tocsin {

/// A vehicle: the stops of stations for its host, and a report of what its safety controller says.
class VehicleStop final : public RouterStop::Side {
 public:
  VehicleStop(Component& owner, const StopKeysFile::Content& kept, Time now);
  void take(const StopNews& news, Time now) override;
  void fill(StopValue& value, Time now) override;
  void fill(topic::LinkStop::Message& message, Time now) override;
  /// Until then nothing is published on the host, which is a stop where a router was received
  /// before.
  [[nodiscard]] bool may_publish(Time now) const override { return listener_.knows(now); }
  [[nodiscard]] StopKeysFile::Content kept() const override;

 private:
  OptionalInput<topic::SafetyStatus> safety_;
  OptionalInput<topic::EmergencyStopRequest> request_;
  router::StopListener listener_;
  std::shared_ptr<const topic::SafetyStatus::Message> status_;
};

}  // namespace tocsin
