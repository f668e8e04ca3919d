// SPDX-License-Identifier: Apache-2.0
#include "container/node_services.hpp"

#include <algorithm>
#include <array>

namespace tocsin {
namespace {

/// "~/get_parameters" and so on.
const std::array<std::string, 8>& names() {
  namespace parameter = parameter_service;
  static const std::array<std::string, 8> all{
      parameter::DescribeParameters::name,   parameter::GetParameters::name,
      parameter::GetParameterTypes::name,    parameter::ListParameters::name,
      parameter::SetParameters::name,        parameter::SetParametersAtomically::name,
      logger_service::GetLoggerLevels::name, logger_service::SetLoggerLevels::name};
  return all;
}

}  // namespace

bool calls_services_of(const std::string& node, const std::vector<std::string>& called) {
  return std::any_of(called.begin(), called.end(), [&](const std::string& service) {
    return std::any_of(names().begin(), names().end(),
                       [&](const std::string& name) { return service == node + name.substr(1); });
  });
}

}  // namespace tocsin
