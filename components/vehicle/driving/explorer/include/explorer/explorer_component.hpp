// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "explorer/exploration_drive.hpp"
#include "map_ports/map_input.hpp"
#include "ros_idl/std_srvs.hpp"
#include "runtime/action_port.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "runtime/service_port.hpp"
#include "tocsin_idl/actions.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// True begins to explore, false ends it.
struct Explore {
  using Request = std_srvs::srv::SetBool_Request;
  using Response = std_srvs::srv::SetBool_Response;
  static constexpr const char* name = "explore";
};

/// Drives to where the map ends, by the navigator, until all that can be reached is known.
class ExplorerComponent final : public Component {
 public:
  using Params = ExplorationDrive::Params;
  ExplorerComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  using Navigate = action::NavigateToPose;
  void take_calls();
  void take_location(Time now);
  void on_news(const ActionClient<Navigate>::News& news, Time now);
  void follow(const ExplorationDrive::Order& order, Time now);
  void tell();

  Server<Explore> explore_{*this};
  MapInput map_{*this};
  Input<topic::Location> location_{*this, WakeMode::time_triggered};
  Output<topic::ExploreStatus> status_{*this};
  ActionClient<Navigate> navigate_{*this};

  const Params params_;
  ExplorationDrive drive_;
  std::optional<GoalId> goal_;
  std::string told_;
};

}  // namespace tocsin
