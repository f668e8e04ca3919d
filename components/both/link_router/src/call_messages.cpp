// SPDX-License-Identifier: Apache-2.0
#include "call_messages.hpp"

#include "wire_names.hpp"

namespace tocsin {
namespace {

using Services = std::vector<tocsin_msgs::msg::LinkService>;

Services to_services(const std::set<router::ServiceName>& names) {
  Services services;
  for (const router::ServiceName& one : names) {
    services.emplace_back();
    services.back().name(one.name);
    services.back().type(one.type);
  }
  return services;
}

std::set<router::ServiceName> to_names(const Services& services) {
  std::set<router::ServiceName> names;
  for (const auto& one : services) {
    if (is_wire_name(one.name(), "_/") && is_wire_name(one.type(), "_/")) {
      names.insert({one.name(), one.type()});
    }
  }
  return names;
}

}  // namespace

tocsin_msgs::msg::LinkServices to_message(const router::ServiceLists& lists) {
  tocsin_msgs::msg::LinkServices message;
  message.offered(to_services(lists.offered));
  message.wanted(to_services(lists.wanted));
  return message;
}

router::ServiceLists to_lists(const tocsin_msgs::msg::LinkServices& message) {
  return {to_names(message.offered()), to_names(message.wanted())};
}

}  // namespace tocsin
