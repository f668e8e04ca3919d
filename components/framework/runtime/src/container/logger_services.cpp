// SPDX-License-Identifier: Apache-2.0
#include "container/logger_services.hpp"

#include "component/log_lines.hpp"
#include "container/rosout.hpp"
#include "foundation/printable.hpp"
#include "runtime/host_control.hpp"

namespace tocsin {

namespace {

/// What was set; all loggers together have INFO before, as in ROS 2, and one alone has none.
LogLevel level_of(const std::string& node) {
  const LogLevel set = log_levels::of(node);
  return node.empty() && set == LogLevel::unset ? LogLevel::info : set;
}

}  // namespace

LoggerServices::LoggerServices(Component& owner, const std::string& node)
    : owner_(owner),
      get_(owner, logger_service::GetLoggerLevels::name, node),
      set_(owner, logger_service::SetLoggerLevels::name, node) {}

Outcome LoggerServices::set(const rcl_interfaces::msg::LoggerLevel& given,
                            const HasNode& has_node) {
  const std::string node =
      node_of_logger(owner_.bus().host_control().ros_namespace(), given.name());
  if (!node.empty() && !has_node(node)) {
    return {false, printable(given.name()) + ": no logger of this process has this name"};
  }
  const auto level = to_log_level(given.level());
  if (!level) {
    return {false, std::to_string(given.level()) +
                       " is no level; they are 0 (unset), 10, 20, 30, 40, 50 (debug to fatal)"};
  }
  log_levels::set(node, *level);
  return {true, ""};
}

void LoggerServices::answer(const HasNode& has_node) {
  while (const auto call = get_.take()) {
    logger_service::GetLoggerLevels::Response response;
    for (const std::string& name : call->request->names()) {
      const std::string node = node_of_logger(owner_.bus().host_control().ros_namespace(), name);
      rcl_interfaces::msg::LoggerLevel level;
      level.name(name);
      level.level(static_cast<std::uint32_t>(level_of(node)));
      response.levels().push_back(std::move(level));
    }
    get_.reply(call->id, std::move(response));
  }
  while (const auto call = set_.take()) {
    logger_service::SetLoggerLevels::Response response;
    for (const auto& one : call->request->levels()) {
      const Outcome outcome = set(one, has_node);
      rcl_interfaces::msg::SetLoggerLevelsResult result;
      result.successful(outcome.done);
      result.reason(outcome.text);
      response.results().push_back(std::move(result));
    }
    set_.reply(call->id, std::move(response));
  }
}

}  // namespace tocsin
