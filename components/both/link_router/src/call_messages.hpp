// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "link_router/service_directory.hpp"
#include "tocsin_idl/link_calls.hpp"

namespace tocsin {

[[nodiscard]] tocsin_msgs::msg::LinkServices to_message(const router::ServiceLists& lists);
/// Without what has no name of a service or a type.
[[nodiscard]] router::ServiceLists to_lists(const tocsin_msgs::msg::LinkServices& message);

}  // namespace tocsin
