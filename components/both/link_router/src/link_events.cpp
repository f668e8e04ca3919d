// SPDX-License-Identifier: Apache-2.0
#include "link_events.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "foundation/hash.hpp"
#include "router_messages.hpp"

namespace tocsin {

void LinkEvents::take(Instant at) {
  while (const auto event = link_.take()) {
    std::visit([this, at](const auto& what) { on(what, at); }, *event);
  }
  send_merged(at);
}

Time LinkEvents::deadline() const {
  Time next = never;
  for (const auto& entry : merging_) next = std::min(next, entry.second.merger.deadline());
  return next;
}

template <class Call>
void LinkEvents::each(const Call& call) {
  for (const auto& service : services_) call(*service);
}

void LinkEvents::on(const link_event::HostFlow& event, Instant at) {
  const TrafficRule& rule = link_.rules().of(event.what.topic);
  LocalFlow flow{event.flow, event.what, rule.stored, rule.logged || !rule.live, {}, {}};
  if (rule.live) {
    const Flow sent = on_link(event.what, rule);
    flow.on_link = link_.open(sent, rule.traffic_class);
    flow.rule = stream_rule(sent, rule);
    flow.rule.paths = link_.rules().paths_of(rule.traffic_class);
    if (rule.max_rate_hz > 0) limit(flow, rule, at);
  }
  const LocalFlow& known = local_.insert_or_assign(event.flow, flow).first->second;
  each([&](LinkService& one) { one.on_local_flow(known, at); });
}

void LinkEvents::limit(const LocalFlow& flow, const TrafficRule& rule, Instant at) {
  const Duration interval = seconds(1 / rule.max_rate_hz);
  const bool is_state = flow.what.transient_local || flow.is_stored || flow.is_logged;
  if (is_state || flow.what.type != type_info<TransformMerger::Message>().name) {
    limits_.emplace(flow.on_host, interval);
    return;
  }
  // Another one in each life of this router, whose sequence begins anew.
  const std::uint64_t source = hash_of(flow.rule.name + "|" + std::to_string(at.wall_ns));
  merging_.emplace(flow.on_host, Merging{TransformMerger(interval), source});
}

void LinkEvents::merge(FlowId flow, const CarriedSample& sample) {
  const auto message = link_.unpack(type_info<TransformMerger::Message>(), sample);
  if (message == nullptr) return;
  merging_.at(flow).merger.add(*static_cast<const TransformMerger::Message*>(message.get()),
                               sample.sent_wall_ns);
}

void LinkEvents::send_merged(Instant at) {
  for (auto& [id, merging] : merging_) {
    auto merged = merging.merger.take(at.now);
    if (!merged) continue;
    CarriedSample sample =
        link_.pack(type_info<TransformMerger::Message>(),
                   std::make_shared<TransformMerger::Message>(std::move(merged->message)));
    sample.source = merging.source;
    sample.sequence = ++merging.sequence;
    sample.sent_wall_ns = merged->sent_wall_ns;
    const LocalFlow& flow = local_.at(id);
    each([&](LinkService& one) { one.on_local(flow, sample, true, at); });
  }
}

void LinkEvents::on(const link_event::HostFlowGone& event, Instant at) {
  const auto found = local_.find(event.flow);
  if (found == local_.end()) return;
  const LocalFlow& flow = found->second;
  if (flow.on_link) each([at](LinkService& one) { one.send(at); });  // the last of who left
  each([&](LinkService& one) { one.on_local_flow_gone(flow, at); });
  if (flow.on_link) link_.close(*flow.on_link);
  limits_.erase(event.flow);
  merging_.erase(event.flow);
  local_.erase(found);
}

void LinkEvents::on(const link_event::HostSample& event, Instant at) {
  const auto found = local_.find(event.flow);
  if (found == local_.end()) return;
  const bool is_merged = merging_.count(event.flow) != 0;
  if (is_merged) merge(event.flow, event.sample);
  const auto limits = limits_.find(event.flow);
  const bool passes =
      !is_merged && (limits == limits_.end() || limits->second.pass(event.sample.source, at.now));
  const bool is_live = found->second.on_link && passes;
  each([&](LinkService& one) { one.on_local(found->second, event.sample, is_live, at); });
}

void LinkEvents::on(const link_event::HostReaderMatched& event, Instant at) {
  each([&](LinkService& one) { one.on_local_reader(event.flow, at.now); });
}

void LinkEvents::on(const link_event::PeerFound& event, Instant at) {
  const LinkPeer peer{event.name, event.peer};
  peers_.add(peer);
  each([&](LinkService& one) { one.on_peer(peer, at); });
}

void LinkEvents::on(const link_event::PeerLost& event, Instant at) {
  const LinkPeer* const peer = peers_.find(event.peer);
  if (peer == nullptr) return;
  each([&](LinkService& one) { one.on_peer_gone(*peer, at); });
  peers_.remove(event.peer);
}

void LinkEvents::on(const link_event::PeerFlow& event, Instant at) {
  if (peers_.find(event.peer) == nullptr) return;
  if (event.what.path != 0) {
    second_[event.flow] = {event, std::nullopt};
    return join_paths();
  }
  RemoteFlow& flow = remote_[event.flow];
  flow = {event.flow, event.peer, {event.wire_id, 0}, event.what, stream_rule(event.what, {}),
          nullptr};
  const auto service = std::find_if(services_.rbegin(), services_.rend(),
                                    [&](const auto& one) { return one->takes(event.what.topic); });
  flow.service = service->get();
  flow.service->on_remote_flow(flow, at);
  part_from(flow.id);
  join_paths();
}

void LinkEvents::part_from(FlowId first) {
  for (auto& entry : second_) {
    if (entry.second.first == first) entry.second.first.reset();
  }
}

void LinkEvents::join_paths() {
  for (auto& entry : second_) {
    SecondFlow& second = entry.second;
    if (second.first) continue;
    Flow what = second.event.what;
    what.path = 0;
    const auto found = std::find_if(remote_.begin(), remote_.end(), [&](const auto& one) {
      return one.second.peer == second.event.peer && one.second.what == what;
    });
    if (found == remote_.end()) continue;
    RemoteFlow& flow = found->second;
    second.first = flow.id;
    flow.wire_ids[1] = second.event.wire_id;
    receiver_.on_stream(peers_.find(flow.peer)->name, second.event.wire_id, flow.rule, 1);
  }
}

bool LinkEvents::forget_second(FlowId flow) {
  const auto found = second_.find(flow);
  if (found == second_.end()) return false;
  const LinkPeer* const peer = peers_.find(found->second.event.peer);
  if (peer != nullptr) receiver_.forget_stream(peer->name, found->second.event.wire_id);
  const auto first = found->second.first ? remote_.find(*found->second.first) : remote_.end();
  if (first != remote_.end()) first->second.wire_ids[1] = 0;
  second_.erase(found);
  return true;
}

void LinkEvents::on(const link_event::PeerFlowGone& event, Instant) {
  if (forget_second(event.flow)) return;
  const auto found = remote_.find(event.flow);
  if (found == remote_.end()) return;
  found->second.service->on_remote_flow_gone(found->second);
  compressed_.forget(event.flow);
  part_from(event.flow);
  remote_.erase(found);
}

void LinkEvents::on(const link_event::PeerReaderMatched& event, Instant at) {
  const LinkPeer* const peer = peers_.find(event.peer);
  if (peer == nullptr) return;
  each([&](LinkService& one) { one.on_remote_reader(*peer, event.flow, at.now); });
}

void LinkEvents::on(const link_event::PeerReaderGone& event, Instant at) {
  const LinkPeer* const peer = peers_.find(event.peer);
  if (peer == nullptr) return;
  each([&](LinkService& one) { one.on_remote_reader_gone(*peer, event.flow, at.now); });
}

void LinkEvents::on(const link_event::LinkSample& sample, Instant at) {
  link_event::LinkSample event = sample;
  const auto second = second_.find(event.flow);
  if (second != second_.end()) {
    if (!second->second.first) return;
    event.flow = *second->second.first;
    event.path = 1;
  }
  const auto found = remote_.find(event.flow);
  if (found == remote_.end()) return;
  const RemoteFlow& flow = found->second;
  const LinkPeer* const peer = peers_.find(flow.peer);
  if (peer == nullptr) return;
  if (event.piece.is_whole()) return give(flow, event, at);
  const auto pieces =
      receiver_.on_piece(peer->name,
                         {flow.wire_ids[event.path], event.number, origin_of(event.sample),
                          event.piece, event.sample.content, event.sample.coding},
                         at.now);
  if (!pieces) return;
  const CarriedSample whole = link_.join(event.sample, *pieces);
  give(flow, {event.flow, event.number, whole, event.received, {}, event.path}, at);
}

void LinkEvents::give(const RemoteFlow& flow, link_event::LinkSample event, Instant at) {
  if (event.sample.coding.is_compressed) {
    const auto plain = restored(flow.id, event.sample);
    if (!plain) return;  // nobody acknowledges it, so that it is repaired, or as good as lost
    event.sample = *plain;
  }
  flow.service->on_remote(flow, event, at);
}

std::optional<CarriedSample> LinkEvents::restored(FlowId flow, const CarriedSample& sample) {
  if (const router::Sample* const known = compressed_.find(flow, sample.source, sample.sequence)) {
    return carried(*known);
  }
  const std::uint8_t before = sample.coding.base;
  std::optional<CarriedSample> base;
  if (before > 0 && before <= sample.sequence) {
    const auto* known = compressed_.find(flow, sample.source, sample.sequence - before);
    if (known != nullptr) base = carried(*known);
  }
  if (before > 0 && !base) return std::nullopt;
  auto plain = link_.restore(sample, base ? &*base : nullptr);
  if (plain) compressed_.add(flow, sample_of(*plain));
  return plain;
}

}  // namespace tocsin
