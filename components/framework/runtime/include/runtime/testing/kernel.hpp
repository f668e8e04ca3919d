// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin {

/// Whether this kernel tells whose sockets are: it may be built without INET_UDP_DIAG, or a sandbox
/// may keep AF_NETLINK from us. Without, other users of the computer are heard.
[[nodiscard]] bool kernel_tells_users();

}  // namespace tocsin
