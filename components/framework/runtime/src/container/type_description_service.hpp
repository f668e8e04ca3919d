// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ros_idl/type_description_interfaces.hpp"
#include "runtime/service_port.hpp"

namespace tocsin {

/// Name and types of the service by which ROS 2 asks what the types of a node are made of.
struct GetTypeDescription {
  using Request = type_description_interfaces::srv::GetTypeDescription_Request;
  using Response = type_description_interfaces::srv::GetTypeDescription_Response;
  static constexpr const char* name = "~/get_type_description";
};

/// The type of the request's hash, out of all types that this process knows. Those of services are
/// their requests and responses, whose hashes their endpoints announce.
[[nodiscard]] GetTypeDescription::Response describe_type(
    const GetTypeDescription::Request& request);

/// Serves the descriptions, as one node of this process. One thread, that of its owner.
class TypeDescriptionService {
 public:
  TypeDescriptionService(Component& owner, const std::string& node);
  /// Answers all that has come.
  void answer();

 private:
  Server<GetTypeDescription> get_;
};

}  // namespace tocsin
