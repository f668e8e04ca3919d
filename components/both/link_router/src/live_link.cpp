// SPDX-License-Identifier: Apache-2.0
#include "live_link.hpp"

#include <algorithm>
#include <utility>

#include "backfill/backfill_link.hpp"
#include "router_messages.hpp"

namespace tocsin {

LiveLink::LiveLink(Component& owner, const LinkParts& parts, Role role)
    : state_(owner), parts_(parts), role_(role) {}

void LiveLink::begin(Instant at) {
  parts_.sender.begin(at.now);
  parts_.sender.set_largest_piece(parts_.link.largest_piece());
  while (const auto state = state_.take()) {
    if (role_of(state->role()) == role_) keeper_.on_state(state->active(), at.now);
  }
  const bool open = keeper_.open(at.now);
  if (open == std::exchange(open_, open)) return;
  parts_.sender.set_paused(!open, at.now);
  parts_.link.on_gate(open);
}

void LiveLink::on_peer(const LinkPeer& peer, Instant at) {
  parts_.sender.on_peer(peer.name, peer.instance, at.now);
  parts_.receiver.on_peer(peer.name, peer.instance);
  parts_.log.info("{} is on the link", peer.name);
}

void LiveLink::on_peer_gone(const LinkPeer& peer, Instant at) {
  if (!parts_.peers.is_present(peer)) return;
  parts_.sender.forget_peer(peer.name, at.now);
  follow_demand();
  parts_.receiver.forget_peer(peer.name);
  parts_.log.warn("{} has left the link", peer.name);
}

void LiveLink::on_local_flow(const LocalFlow& flow, Instant) {
  if (flow.on_link) parts_.streams.add(*flow.on_link, flow.rule);
}

void LiveLink::on_local_flow_gone(const LocalFlow& flow, Instant) {
  if (flow.on_link) parts_.streams.remove(*flow.on_link);
}

void LiveLink::on_local(const LocalFlow& flow, const CarriedSample& sample, bool is_live,
                        Instant at) {
  if (!is_live) return;
  parts_.sender.offer(*flow.on_link, sample_of(sample), at.now);
}

void LiveLink::on_remote_flow(const RemoteFlow& flow, Instant at) {
  parts_.expect(flow);
  if (flow.what.stored) {
    backfill_->expect(at);
    held_.expect(flow.id, at.now);
  }
  parts_.link.offer(flow.id);
}

void LiveLink::on_remote_flow_gone(const RemoteFlow& flow) {
  parts_.forget(flow);
  held_.forget(flow.id);
}

void LiveLink::on_remote(const RemoteFlow& flow, const link_event::LinkSample& event, Instant at) {
  if (!held_.hold(event)) deliver(flow, event, at);
}

void LiveLink::follow(Instant at) {
  for (const link_event::LinkSample& event : held_.take(at.now)) {
    const auto flow = parts_.remote.find(event.flow);
    if (flow != parts_.remote.end()) deliver(flow->second, event, at);
  }
}

void LiveLink::deliver(const RemoteFlow& flow, const link_event::LinkSample& event, Instant at) {
  if (parts_.on_arrived(flow, event, at.now) != router::Disposition::deliver) return;
  const CarriedSample& sample = event.sample;
  const bool is_new =
      !flow.rule.stored || backfill_->on_live(*parts_.peers.find(flow.peer), flow, sample);
  if (is_new) backfill_->on_delivery(flow.what, sample, at);
  // Late readers ask for the last sample of a state, whoever has it already.
  if (is_new || flow.rule.durable) parts_.link.deliver(flow.id, sample);
}

void LiveLink::on_remote_reader(const LinkPeer& peer, FlowId flow, Time now) {
  if (!parts_.streams.has(flow)) return;
  parts_.sender.set_wanted(peer.name, flow, true, now);
  follow_demand();
}

void LiveLink::on_remote_reader_gone(const LinkPeer& peer, FlowId flow, Time now) {
  if (!parts_.streams.has(flow)) return;
  parts_.sender.set_wanted(peer.name, flow, false, now);
  follow_demand();
}

void LiveLink::follow_demand() {
  for (const auto& [id, flow] : parts_.local) {
    // What a log or a rule needs is taken always.
    if (!flow.on_link || !parts_.link.rules().waits_for_demand(flow.what.topic)) continue;
    parts_.link.want(id, parts_.sender.is_wanted(*flow.on_link));
  }
}

void LiveLink::on_acknowledgement(const LinkPeer& peer, const AcknowledgementMessage& message,
                                  Time now) {
  if (!parts_.peers.is_present(peer)) return;
  const auto acknowledgement = to_acknowledgement(
      message, [this](std::uint32_t wire_id) { return parts_.streams.find(wire_id); });
  if (acknowledgement) parts_.sender.on_acknowledgement(peer.name, *acknowledgement, now);
}

Time LiveLink::deadline(Time now) const {
  return std::min({parts_.sender.deadline(now), keeper_.deadline(now), held_.deadline()});
}

}  // namespace tocsin
