// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin {

/// Whether the IPv4 `address` is on an interface that is up and has carrier. Fast DDS ignores
/// others for the life of a participant. False for what is no address.
[[nodiscard]] bool interface_is_running(const std::string& address);

}  // namespace tocsin
