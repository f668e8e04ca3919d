// SPDX-License-Identifier: Apache-2.0
#include "router_messages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tocsin {
namespace {

using std::chrono::microseconds;

constexpr Duration age_unit = microseconds(100);
constexpr std::uint16_t oldest = std::numeric_limits<std::uint16_t>::max();

router::WhilePaused while_paused(WhilePoor rule) {
  if (rule == WhilePoor::send) return router::WhilePaused::send;
  return rule == WhilePoor::latest ? router::WhilePaused::latest : router::WhilePaused::drop;
}

std::uint16_t to_units(Duration age) {
  const auto units = std::max(age, Duration::zero()) / age_unit;
  return static_cast<std::uint16_t>(std::min<std::int64_t>(units, oldest));
}

std::uint64_t dropped(const router::ClassCounts& counts, router::DropReason reason) {
  return counts.dropped[static_cast<std::size_t>(reason)];
}

tocsin_msgs::msg::LinkClass to_message(TrafficClass traffic_class,
                                       const router::ClassCounts& counts) {
  using router::DropReason;
  tocsin_msgs::msg::LinkClass message;
  message.traffic_class(to_string(traffic_class));
  message.offered(counts.offered);
  message.sent(counts.sent);
  message.delivered(counts.delivered);
  message.late(counts.late);
  message.lost(counts.lost);
  message.unwanted(counts.unwanted);
  message.repaired(counts.repaired);
  message.repairs(counts.repairs);
  message.repair_bytes(counts.repair_bytes);
  message.dropped_paused(dropped(counts, DropReason::paused));
  message.dropped_superseded(dropped(counts, DropReason::superseded));
  message.dropped_expired(dropped(counts, DropReason::expired));
  message.dropped_overflow(dropped(counts, DropReason::overflow));
  message.queue_samples(static_cast<std::uint32_t>(counts.waiting_samples));
  message.queue_bytes(static_cast<std::uint32_t>(counts.waiting_bytes));
  message.delay_s(counts.delay ? static_cast<float>(to_seconds(*counts.delay))
                               : std::numeric_limits<float>::quiet_NaN());
  return message;
}

tocsin_msgs::msg::LinkPath to_message(const router::PathValues& path) {
  tocsin_msgs::msg::LinkPath message;
  message.chosen(path.chosen);
  message.silent(path.silent);
  message.capacity_bytes_per_s(static_cast<float>(path.capacity_bytes_per_s));
  message.backlog_s(static_cast<float>(to_seconds(path.backlog)));
  message.loss(static_cast<float>(path.loss));
  message.delay_s(path.delay ? static_cast<float>(to_seconds(*path.delay))
                             : std::numeric_limits<float>::quiet_NaN());
  return message;
}

}  // namespace

Flow on_link(Flow flow, const TrafficRule& rule) {
  flow.stored = rule.stored || rule.logged;
  flow.depth = std::max(flow.depth, rule.depth);
  flow.lifespan_s = std::min(flow.lifespan_s, rule.lifespan_s);
  return flow;
}

router::StreamRule stream_rule(const Flow& flow, const TrafficRule& rule) {
  router::StreamRule stream;
  stream.name = flow.topic + "|" + flow.user_data;
  stream.traffic_class = rule.traffic_class;
  stream.while_paused = while_paused(rule.while_poor);
  stream.depth = static_cast<std::size_t>(flow.depth);
  stream.lifespan = std::isfinite(flow.lifespan_s) ? seconds(flow.lifespan_s) : Duration::max();
  stream.repaired = policy_of(stream.traffic_class).repaired;
  stream.durable = flow.transient_local;
  stream.adaptive = rule.adaptive;
  stream.on_demand = rule.on_demand;
  stream.stored = rule.stored || rule.logged || flow.stored;
  stream.compressed = rule.compressed;
  return stream;
}

router::Origin origin_of(const CarriedSample& sample) {
  return {sample.source, sample.sequence, Time(Duration(sample.sent_wall_ns))};
}

CarriedSample carried(const router::Sample& sample) {
  return {
      sample.content,         static_cast<std::uint32_t>(sample.bytes),      sample.origin.source,
      sample.origin.sequence, sample.origin.sent.time_since_epoch().count(), sample.coding};
}

router::Sample sample_of(const CarriedSample& carried) {
  return {origin_of(carried), carried.bytes, carried.content, carried.coding};
}

bool is_sound(const tocsin_msgs::msg::LinkAcknowledgement& message) {
  const std::size_t count = message.streams().size();
  return message.highest().size() == count && message.age_100us().size() == count &&
         message.before().size() == count;
}

tocsin_msgs::msg::LinkAcknowledgement to_message(
    const router::LinkAcknowledgement& acknowledgement) {
  tocsin_msgs::msg::LinkAcknowledgement message;
  message.made_ns(acknowledgement.made.time_since_epoch().count());
  message.count(acknowledgement.count);
  for (const router::StreamAcknowledgement& stream : acknowledgement.streams) {
    message.streams().push_back(stream.stream);
    message.highest().push_back(static_cast<std::uint32_t>(stream.highest));
    message.age_100us().push_back(to_units(stream.age));
    message.before().push_back(stream.before);
  }
  return message;
}

std::optional<router::LinkAcknowledgement> to_acknowledgement(
    const tocsin_msgs::msg::LinkAcknowledgement& message,
    const std::function<std::optional<StreamPath>(std::uint32_t)>& stream_of) {
  if (!is_sound(message)) return std::nullopt;
  router::LinkAcknowledgement acknowledgement;
  acknowledgement.made = Time(Duration(message.made_ns()));
  acknowledgement.count = message.count();
  acknowledgement.streams.reserve(message.streams().size());
  for (std::size_t i = 0; i < message.streams().size(); ++i) {
    const auto stream = stream_of(message.streams()[i]);
    if (!stream) continue;
    acknowledgement.streams.push_back({stream->stream, message.highest()[i],
                                       message.age_100us()[i] * age_unit, message.before()[i],
                                       stream->path});
  }
  return acknowledgement;
}

tocsin_msgs::msg::LinkState to_message(const router::LinkStateValues& values,
                                       const LinkPackets& packets) {
  tocsin_msgs::msg::LinkState message;
  message.paused(values.paused);
  message.live_peers(static_cast<std::uint32_t>(values.live_peers));
  message.silent_peers(static_cast<std::uint32_t>(values.silent_peers));
  message.capacity_bytes_per_s(static_cast<float>(values.capacity_bytes_per_s));
  message.capacity_measured(values.capacity_measured);
  message.backlog_s(static_cast<float>(to_seconds(values.backlog)));
  message.loss(static_cast<float>(values.loss));
  message.scale(static_cast<float>(values.scale));
  message.repair_share(static_cast<float>(values.repair_share));
  for (const TrafficClass one : traffic_classes) {
    message.classes().push_back(to_message(one, values.classes[router::index_of(one)]));
    message.classes().back().bytes(packets.class_bytes[router::index_of(one)]);
  }
  message.packets(packets.packets);
  message.bytes(packets.bytes);
  message.discovery_bytes(packets.discovery_bytes);
  message.acknowledgement_bytes(packets.acknowledgement_bytes);
  message.backfill_bytes(packets.backfill_bytes);
  message.stop_bytes(packets.stop_bytes);
  for (const router::PathValues& path : values.paths) {
    message.paths().push_back(to_message(path));
    message.paths().back().bytes(packets.bytes - packets.second_bytes);
  }
  if (!message.paths().empty()) message.paths().back().bytes(packets.second_bytes);
  return message;
}

}  // namespace tocsin
