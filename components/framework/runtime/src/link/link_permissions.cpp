// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/link_permissions.hpp"

#include "link/flow_table.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin {
namespace {

std::vector<std::string> topics_of(Role role, const LinkSide& side) {
  const TopicNames names(side.ros_namespace);
  std::vector<std::string> topics;
  const TrafficRules rules(side.traffic_file, role);
  for (const auto& entry : rules.all()) topics.push_back(names.on_wire(entry.first));
  topics.push_back(names.on_wire(link_receipt_topic));
  topics.push_back(names.on_wire(fill_in_topic));
  return topics;
}

}  // namespace

keystore::Permissions link_permissions(const LinkSide& side) {
  const Role other = side.role == Role::uxv ? Role::gcs : Role::uxv;
  return {topics_of(side.role, side), topics_of(other, side)};
}

}  // namespace tocsin
