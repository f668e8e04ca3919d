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
  std::vector<std::string> links;
  for (const deployment::Deployment& part : parts_of(deployment)) {
    links.push_back(std::to_string(part.link_domain));
  }
  const std::string link = links.size() == 1 ? "; the link has " : "; the links have ";
  return "ROS_DOMAIN_ID: " + joined(hosts, ", ") + (routed ? link + joined(links) : "");
}

}  // namespace tocsin::cli
