// SPDX-License-Identifier: Apache-2.0
#include "open_link.hpp"

namespace tocsin::cli {

std::optional<std::string> open_link_warning(const deployment::Deployment& deployment) {
  if (deployment.radio || !deployment.security.empty()) return std::nullopt;
  for (const deployment::Host& host : deployment.hosts) {
    const bool loopback = host.address.rfind("127.", 0) == 0;
    if (loopback || !deployment::is_routed(host)) continue;
    return "WARN: the link of " + host.name + " (" + host.address +
           ") is open: who reaches it may stop and drive the vehicle; `tocsin keystore create` and "
           "`security` of the bringup file close it";
  }
  return std::nullopt;
}

}  // namespace tocsin::cli
