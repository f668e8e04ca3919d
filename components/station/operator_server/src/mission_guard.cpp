// SPDX-License-Identifier: Apache-2.0
#include "operator_server/mission_guard.hpp"

#include "foundation/ends_with.hpp"
#include "tocsin_idl/actions.hpp"

namespace tocsin::foxglove {
namespace {

bool begins_mission(const std::string& service) {
  static const std::string end =
      std::string("/") + action::FollowWaypoints::name + "/_action/send_goal";
  return ends_with(service, end);
}

}  // namespace

std::string MissionGuard::refusal(ClientId client, const std::string& service, Time now) const {
  if (!driver_ || driver_->name.empty() || now - driver_->reported >= counts_for) return {};
  const auto own = operators_.find(client);
  if (own != operators_.end() && own->second == driver_->name) return {};
  return begins_mission(service) ? driver_->name + " drives by hand: ask for control before" : "";
}

}  // namespace tocsin::foxglove
