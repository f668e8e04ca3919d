// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "container/instances.hpp"
#include "ros_idl/rcl_interfaces.hpp"
#include "runtime/service_port.hpp"

namespace tocsin {

/// Names and types of the two services by which ROS 2 reads and sets levels of logs.
namespace logger_service {
struct GetLoggerLevels {
  using Request = rcl_interfaces::srv::GetLoggerLevels_Request;
  using Response = rcl_interfaces::srv::GetLoggerLevels_Response;
  static constexpr const char* name = "~/get_logger_levels";
};
struct SetLoggerLevels {
  using Request = rcl_interfaces::srv::SetLoggerLevels_Request;
  using Response = rcl_interfaces::srv::SetLoggerLevels_Response;
  static constexpr const char* name = "~/set_logger_levels";
};
}  // namespace logger_service

/// Serves the levels of this process's logs, as one of its nodes. One thread, that of its owner.
class LoggerServices {
 public:
  /// Whether this process has a node of this name.
  using HasNode = std::function<bool(const std::string& node)>;

  LoggerServices(Component& owner, const std::string& node);
  /// Answers all that has come.
  void answer(const HasNode& has_node);

 private:
  [[nodiscard]] Outcome set(const rcl_interfaces::msg::LoggerLevel& given, const HasNode& has_node);
  Component& owner_;
  Server<logger_service::GetLoggerLevels> get_;
  Server<logger_service::SetLoggerLevels> set_;
};

}  // namespace tocsin
