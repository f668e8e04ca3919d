// SPDX-License-Identifier: Apache-2.0
#include "backfill/backfill_outgoing.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "backfill/backfill_messages.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {
namespace {

using BackfillMessage = tocsin_msgs::msg::Backfill;

std::optional<FlowId> open_flow(LinkBus& link) {
  const auto stores = [](const auto& rules) {
    return std::any_of(rules.begin(), rules.end(),
                       [](const auto& rule) { return rule.second.stored || rule.second.logged; });
  };
  if (!stores(link.rules().all()) && !stores(link.rules().patterns())) return std::nullopt;
  Flow flow;
  flow.topic = backfill_topic;
  flow.type = type_info<BackfillMessage>().name;
  return link.open(flow, TrafficClass::low);
}

}  // namespace

BackfillOutgoing::BackfillOutgoing(const Parts& parts)
    : parts_(parts), flow_(open_flow(parts.link)) {
  if (flow_) parts_.streams.add_backfill(*flow_);
}

void BackfillOutgoing::add(const LocalFlow& flow) {
  const std::uint64_t key = sample_log::stream_key(flow.rule.name);
  keys_[*flow.on_link] = key;
  parts_.flows[key] = flow.what;
  parts_.store.add(logged_stream(flow.rule.name, flow.what));
}

void BackfillOutgoing::remove(const LocalFlow& flow) {
  follow_fates();
  if (flow.on_link) keys_.erase(*flow.on_link);
}

void BackfillOutgoing::offer(const LocalFlow& flow, const CarriedSample& sample, Instant at) {
  const auto key = keys_.find(*flow.on_link);
  if (key == keys_.end()) return;
  const sample_log::SampleId id{key->second, sample.source, sample.sequence};
  parts_.sender.offer(id);
  parts_.store.append({id, sample.sent_wall_ns, parts_.link.bytes_of(sample)}, at);
}

void BackfillOutgoing::on_opened(const store_answer::Opened& opened) {
  for (const sample_log::LoggedStream& stream : opened.streams) {
    parts_.flows.try_emplace(sample_log::stream_key(stream.name), flow_of(stream));
  }
  for (const sample_log::SampleId& id : opened.waiting) parts_.sender.recover(id);
  if (opened.waiting.empty()) return;
  parts_.log.info("{} stored samples of earlier runs are still to cross", opened.waiting.size());
}

void BackfillOutgoing::on_reader(const LinkPeer& peer, Time now) {
  readers_[peer.instance] = peer;
  parts_.link_sender.set_wanted(peer.name, *flow_, true, now);
  if (!session_) begin_session();
}

void BackfillOutgoing::on_peer_gone(const LinkPeer& peer) {
  readers_.erase(peer.instance);
  if (is_for(peer)) begin_session();
}

void BackfillOutgoing::begin_session() {
  session_.reset();
  if (readers_.empty()) return parts_.sender.end_session();
  session_ = readers_.begin()->second;
  parts_.sender.begin_session();
}

void BackfillOutgoing::follow_fates() {
  std::vector<sample_log::SampleId> crossed;
  for (const router::StoredFate& one : parts_.link_sender.take_fates()) {
    const auto logged = parts_.history.live_key(one.stream);
    const auto stored = keys_.find(one.stream);
    if (!logged && stored == keys_.end()) continue;
    const sample_log::SampleId id{logged ? *logged : stored->second, one.origin.source,
                                  one.origin.sequence};
    const bool was_waited_for = parts_.sender.on_fate(id, one.fate);
    const bool is_news = logged && one.fate == router::LiveFate::delivered;
    if (was_waited_for || is_news) crossed.push_back(id);
  }
  confirm(crossed);
}

void BackfillOutgoing::confirm(const std::vector<sample_log::SampleId>& ids) {
  if (ids.empty()) return;
  auto [logged, stored] = parts_.history.split(ids);
  parts_.store.confirm(std::move(stored));
  parts_.history.confirm(std::move(logged));
}

void BackfillOutgoing::read_ahead() {
  auto [logged, stored] = parts_.history.split(parts_.sender.take_wanted());
  parts_.store.read(std::move(stored));
  parts_.history.read(std::move(logged));
}

CarriedSample BackfillOutgoing::packed(const router::BackfillBatch& batch) {
  auto message = std::make_shared<BackfillMessage>(to_message(batch));
  const Flow& flow = parts_.flows.at(batch.stream);
  message->from_instance(parts_.link.self());
  message->to_instance(session_->instance);
  message->topic(flow.topic);
  message->type(flow.type);
  message->user_data(flow.user_data);
  CarriedSample sample = parts_.link.pack(type_info<BackfillMessage>(), std::move(message));
  // The same for a batch that is sent once more, so that its pieces complete each other.
  sample.sequence = std::uint64_t{batch.session} << 32U | batch.number;
  return sample;
}

void BackfillOutgoing::send(Time now) {
  router::LinkSender& out = parts_.link_sender;
  while (session_ && out.may_backfill(now)) {
    const auto batch = parts_.sender.next(now, out.capacity_bytes_per_s(now));
    if (!batch) return;
    const CarriedSample sample = packed(*batch);
    const auto pieces =
        out.backfill(*flow_, {{0, sample.sequence, now}, sample.bytes, sample.content}, now);
    for (const router::Transmission& one : pieces) {
      if (const auto number = parts_.link.send(*flow_, sample, one.piece, one.path)) {
        out.on_written(one, *number);
      }
    }
  }
}

Time BackfillOutgoing::deadline(Time now) const {
  const router::LinkSender& out = parts_.link_sender;
  const Time next = parts_.sender.deadline(now, out.capacity_bytes_per_s(now));
  return next > now ? next : out.backfill_opens(now);
}

void BackfillOutgoing::add_to(tocsin_msgs::msg::LinkState& message) const {
  for (const auto& [key, counts] : parts_.sender.counts()) {
    const auto flow = parts_.flows.find(key);
    if (flow == parts_.flows.end() || parts_.history.has(key)) continue;
    tocsin_msgs::msg::StoredTopic topic;
    topic.topic(flow->second.topic);
    topic.stored(counts.stored);
    topic.backfilled(counts.backfilled);
    topic.expired(counts.expired);
    topic.refused(counts.refused);
    topic.waiting(static_cast<std::uint32_t>(counts.waiting));
    message.stored().push_back(std::move(topic));
  }
}

}  // namespace tocsin
