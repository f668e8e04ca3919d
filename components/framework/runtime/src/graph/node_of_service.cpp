// SPDX-License-Identifier: Apache-2.0
#include "graph/node_of_service.hpp"

#include <array>

#include "container/logger_services.hpp"
#include "container/type_description_service.hpp"
#include "runtime/middleware/ros_services.hpp"

namespace tocsin {

std::string node_of_service(const std::string& service) {
  static const std::array<std::string, 14> names{
      parameter_service::DescribeParameters::name, parameter_service::GetParameters::name,
      parameter_service::GetParameterTypes::name,  parameter_service::ListParameters::name,
      parameter_service::SetParameters::name,      parameter_service::SetParametersAtomically::name,
      logger_service::GetLoggerLevels::name,       logger_service::SetLoggerLevels::name,
      lifecycle_service::ChangeState::name,        lifecycle_service::GetState::name,
      lifecycle_service::GetAvailableStates::name, lifecycle_service::GetAvailableTransitions::name,
      lifecycle_service::GetTransitionGraph::name, GetTypeDescription::name};
  for (const std::string& name : names) {
    const std::string end = name.substr(1);  // without the tilde
    const bool has = service.size() > end.size() &&
                     service.compare(service.size() - end.size(), end.size(), end) == 0;
    if (has) return service.substr(0, service.size() - end.size());
  }
  return "";
}

}  // namespace tocsin
