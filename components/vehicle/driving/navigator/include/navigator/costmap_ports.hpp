// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "navigator/navigator.hpp"
#include "ros_idl/nav2_msgs.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "runtime/service_port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Under the names that nav2's costmaps have: forget what was seen besides the map.
struct ClearGlobalCostmap {
  using Request = nav2_msgs::srv::ClearEntireCostmap_Request;
  using Response = nav2_msgs::srv::ClearEntireCostmap_Response;
  static constexpr const char* name = "global_costmap/clear_entirely_global_costmap";
};
struct ClearLocalCostmap {
  using Request = nav2_msgs::srv::ClearEntireCostmap_Request;
  using Response = nav2_msgs::srv::ClearEntireCostmap_Response;
  static constexpr const char* name = "local_costmap/clear_entirely_local_costmap";
};

/// Ports of a component whose navigator avoids obstacles: `global_costmap/costmap` once a second,
/// `local_costmap/costmap`, 3 m about the vehicle, twice a second, both while somebody reads; and
/// the services that clear them. There is one layer of obstacles, so that both clear the same.
class CostmapPorts {
 public:
  explicit CostmapPorts(Component& owner);

  /// Does what has been asked for.
  void take(Navigator& navigator);
  /// Tells the costs, with the time of the report.
  void report(const Surroundings& surroundings, const std::optional<geometry::Pose>& pose,
              const builtin_interfaces::msg::Time& stamp, Time now);

 private:
  template <class Topic>
  void tell(Output<Topic>& output, const Surroundings& surroundings,
            const navigation::CellWindow& window, const builtin_interfaces::msg::Time& stamp);

  Output<topic::GlobalCostmap> global_;
  Output<topic::LocalCostmap> local_;
  Server<ClearGlobalCostmap> clear_global_;
  Server<ClearLocalCostmap> clear_local_;
  Logger log_;
  Time next_global_{};
  Time next_local_{};
};

}  // namespace tocsin
