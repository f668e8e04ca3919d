// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "link_router/link_acknowledgement.hpp"
#include "link_router/link_state_values.hpp"
#include "link_router/transmission.hpp"
#include "link_tables.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// What a flow of the host is on the link, by the rule for it.
[[nodiscard]] Flow on_link(Flow flow, const TrafficRule& rule);
/// What the configuration and its writers say of a flow. `rule` of the host that sends it.
[[nodiscard]] router::StreamRule stream_rule(const Flow& flow, const TrafficRule& rule);

[[nodiscard]] router::Origin origin_of(const CarriedSample& sample);
/// A carried sample for the decisions, and back.
[[nodiscard]] router::Sample sample_of(const CarriedSample& carried);
[[nodiscard]] CarriedSample carried(const router::Sample& sample);

/// Without instances, backfill and requests.
[[nodiscard]] tocsin_msgs::msg::LinkAcknowledgement to_message(
    const router::LinkAcknowledgement& acknowledgement);
/// Whether its lists are of one length.
[[nodiscard]] bool is_sound(const tocsin_msgs::msg::LinkAcknowledgement& message);
/// Nothing when its lists are not of one length. `stream_of` is the stream and path of a wire id;
/// what it does not know is left out.
[[nodiscard]] std::optional<router::LinkAcknowledgement> to_acknowledgement(
    const tocsin_msgs::msg::LinkAcknowledgement& message,
    const std::function<std::optional<StreamPath>(std::uint32_t)>& stream_of);

/// Without stamp and role.
[[nodiscard]] tocsin_msgs::msg::LinkState to_message(const router::LinkStateValues& values,
                                                     const LinkPackets& packets);

}  // namespace tocsin
