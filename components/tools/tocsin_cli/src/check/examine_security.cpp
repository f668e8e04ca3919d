// SPDX-License-Identifier: Apache-2.0
#include "examine_security.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <filesystem>

#include "foundation/joined.hpp"
#include "keystore/enclave.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin::check {
namespace {

using deployment::Deployment;
using deployment::Host;
using Topics = std::vector<std::string>;

Topics missing(const Topics& wanted, const Topics& allowed) {
  Topics topics;
  for (const std::string& topic : wanted) {
    const bool found = std::any_of(allowed.begin(), allowed.end(), [&topic](const auto& pattern) {
      return fnmatch(pattern.c_str(), topic.c_str(), 0) == 0;
    });
    if (!found) topics.push_back(topic);
  }
  return topics;
}

void examine_permissions(const Deployment& deployment, const Host& host,
                         std::vector<Finding>& findings) {
  const auto allowed = keystore::read_enclave(enclave_of(deployment, host)).permissions;
  const auto wanted = link_permissions({host.role, deployment.traffic});
  const auto note = [&](const char* what, const Topics& topics) {
    if (topics.empty()) return;
    findings.push_back(
        {Severity::error,
         fmt::format("host {}: its identity '{}' may not {} {}; `tocsin keystore permit {}` allows "
                     "what traffic.yaml says",
                     host.name, host.enclave, what, joined(topics), host.enclave)});
  };
  note("send", missing(wanted.publish, allowed->publish));
  note("hear", missing(wanted.subscribe, allowed->subscribe));
}

void examine_host(const Deployment& deployment, const Host& host, std::int64_t now_s,
                  std::vector<Finding>& findings) {
  const std::string folder = enclave_of(deployment, host);
  if (!std::filesystem::is_directory(folder)) {
    const bool runs_here = deployment.radio.has_value() || deployment.hosts.size() == 1;
    findings.push_back({runs_here ? Severity::error : Severity::note,
                        fmt::format("host {}: no identity '{}' in {}; `tocsin keystore add` makes "
                                    "it, and it is needed where the host runs",
                                    host.name, host.enclave, deployment.security)});
    return;
  }
  const auto problems = keystore::problems_of(folder, now_s);
  for (const std::string& problem : problems) {
    findings.push_back({Severity::error, fmt::format("host {}: {}", host.name, problem)});
  }
  if (problems.empty()) examine_permissions(deployment, host, findings);
}

}  // namespace

std::vector<Finding> examine_security(const Deployment& deployment, std::int64_t now_s) {
  std::vector<Finding> findings;
  if (deployment.security.empty()) return findings;
  for (const Host& host : deployment.hosts) {
    if (is_routed(host)) examine_host(deployment, host, now_s, findings);
  }
  return findings;
}

}  // namespace tocsin::check
