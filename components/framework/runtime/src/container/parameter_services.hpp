// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "container/instances.hpp"
#include "runtime/middleware/ros_parameters.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/service_port.hpp"

namespace tocsin {

/// The parameters of a node, for who asks from outside.
struct ParameterSource {
  std::function<std::vector<ParameterFacts>()> facts;
  /// All of them or none.
  std::function<Outcome(const std::vector<rcl_interfaces::msg::Parameter>&)> set;
};

/// Serves the parameters of one node. One thread, that of its owner.
class ParameterServices {
 public:
  /// `owner` is ticked when somebody asks; `node`: whose parameters they are.
  ParameterServices(Component& owner, const std::string& node);
  /// Answers all that has come.
  void answer(const ParameterSource& source);

 private:
  void answer_readers(const ParameterSource& source);
  Server<parameter_service::DescribeParameters> describe_;
  Server<parameter_service::GetParameters> get_;
  Server<parameter_service::GetParameterTypes> types_;
  Server<parameter_service::ListParameters> list_;
  Server<parameter_service::SetParameters> set_;
  Server<parameter_service::SetParametersAtomically> set_atomically_;
};

}  // namespace tocsin
