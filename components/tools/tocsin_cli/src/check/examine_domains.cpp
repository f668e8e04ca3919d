// SPDX-License-Identifier: Apache-2.0
#include "examine_domains.hpp"

#include <map>
#include <string>

namespace tocsin::check {
namespace {

constexpr int first_ephemeral = 32768;
constexpr int last_ephemeral = 60999;

int first_port(int domain) { return 7400 + 250 * domain; }

bool is_ephemeral(int domain) {
  return first_port(domain) >= first_ephemeral && first_port(domain) <= last_ephemeral;
}

}  // namespace

std::vector<Finding> examine_domains(const deployment::Deployment& deployment) {
  std::map<int, std::string> users;
  for (const deployment::Host& host : deployment.hosts) users[host.local_domain] = host.name;
  for (const deployment::Deployment& part : parts_of(deployment)) {
    users.emplace(part.link_domain, "the link");
  }
  std::vector<Finding> findings;
  for (const auto& [domain, user] : users) {
    if (!is_ephemeral(domain)) continue;
    const std::string port = std::to_string(first_port(domain));
    findings.push_back(
        {Severity::warning, "domain " + std::to_string(domain) + " of " + user +
                                ": its ports, from " + port +
                                ", are among those that Linux gives to any program (32768 to "
                                "60999); safe are 0 to 101 and 215 to 231"});
  }
  return findings;
}

}  // namespace tocsin::check
