// SPDX-License-Identifier: Apache-2.0
#include "domains_line.hpp"

#include <vector>

#include "foundation/joined.hpp"

namespace tocsin::cli {

std::string domains_line(const deployment::Deployment& deployment) {
  bool routed = false;
  std::vector<std::string> hosts;
  for (const deployment::Host& host : deployment.hosts) {
    hosts.push_back(std::to_string(host.local_domain) + " on " + host.name);
    routed = routed || deployment::is_routed(host);
  }
  const std::string link = "; the link has " + std::to_string(deployment.link_domain);
  return "ROS_DOMAIN_ID: " + joined(hosts, ", ") + (routed ? link : "");
}

}  // namespace tocsin::cli
