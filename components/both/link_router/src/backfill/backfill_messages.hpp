// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "link_router/backfill_batch.hpp"
#include "link_router/history_requests.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "sample_log/sample_log.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// Without instances, topic, type and user data.
[[nodiscard]] tocsin_msgs::msg::Backfill to_message(const router::BackfillBatch& batch);
/// `stream` is the number of its stream here.
[[nodiscard]] router::BackfillBatch to_batch(const tocsin_msgs::msg::Backfill& message,
                                             std::uint64_t stream);
/// Whether a message of a peer names what can be a topic and a type.
[[nodiscard]] bool is_sound(const tocsin_msgs::msg::Backfill& message);

[[nodiscard]] tocsin_msgs::msg::LogRequest to_message(const router::HistoryRange& range);
/// Empty when its topic is none.
[[nodiscard]] std::optional<router::HistoryRange> to_range(
    const tocsin_msgs::msg::LogRequest& message);

/// What the log keeps of a flow of this name: other tools find topic and definition in it.
[[nodiscard]] sample_log::LoggedStream logged_stream(const std::string& name, const Flow& flow);
/// Topic, type and user data of such a stream.
[[nodiscard]] Flow flow_of(const sample_log::LoggedStream& stream);
/// Where a topic's backfilled samples are delivered: `<topic>/backfilled`, reliable, a late reader
/// gets the last hundred.
[[nodiscard]] Flow backfilled(const Flow& flow);

}  // namespace tocsin
