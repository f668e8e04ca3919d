// SPDX-License-Identifier: Apache-2.0
// What a LinkRouterComponent does when peers, and what they write and read, come and go.
#include "backfill_link.hpp"
#include "call_link.hpp"
#include "held_arrivals.hpp"
#include "link_router/link_router_component.hpp"
#include "router_messages.hpp"
#include "router_store.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {

void LinkRouterComponent::on(const link_event::PeerFound& event, Time now) {
  peers_[event.peer] = event.name;
  lives_[event.name] = event.peer;
  sender_.on_peer(event.name, event.peer, now);
  receiver_.on_peer(event.name, event.peer);
  log().info("{} is on the link", event.name);
}

void LinkRouterComponent::on(const link_event::PeerLost& event, Time now) {
  const auto found = peers_.find(event.peer);
  if (found == peers_.end()) return;
  if (lives_[found->second] == event.peer) {
    sender_.forget_peer(found->second, now);
    receiver_.forget_peer(found->second);
    lives_.erase(found->second);
    log().warn("{} has left the link", found->second);
  }
  peers_.erase(found);
  backfills_->on_lost(event.peer);
  calls_->on_lost(event.peer);
}

LinkRouterComponent::Incoming::Kind LinkRouterComponent::kind_of(const std::string& topic) {
  if (topic == link_acknowledgement_topic) return Incoming::Kind::acknowledgements;
  if (topic == backfill_topic) return Incoming::Kind::backfills;
  if (topic == link_services_topic) return Incoming::Kind::services;
  return CallLink::carries(topic) ? Incoming::Kind::calls : Incoming::Kind::samples;
}

void LinkRouterComponent::on(const link_event::PeerFlow& event, Time now) {
  const auto peer = peers_.find(event.peer);
  if (peer == peers_.end()) return;
  Incoming& flow = incoming_[event.flow];
  flow = {event.peer, event.wire_id, kind_of(event.what.topic), stream_rule(event.what, {}),
          event.what};
  if (flow.kind == Incoming::Kind::acknowledgements) return;
  receiver_.on_stream(peer->second, event.wire_id, flow.rule);
  if (flow.kind != Incoming::Kind::samples) return;
  if (event.what.stored) {
    store_->open(now, bus().wall_ns(now));
    held_->expect(event.flow, now);
  }
  link_->offer(event.flow);
}

void LinkRouterComponent::on(const link_event::PeerFlowGone& event, Time) {
  const auto found = incoming_.find(event.flow);
  if (found == incoming_.end()) return;
  const auto peer = peers_.find(found->second.peer);
  if (peer != peers_.end()) receiver_.forget_stream(peer->second, found->second.wire_id);
  held_->forget(event.flow);
  incoming_.erase(found);
}

void LinkRouterComponent::on(const link_event::PeerListens& event, Time now) {
  const auto peer = peers_.find(event.peer);
  if (peer == peers_.end()) return;
  if (event.flow == backfills_->flow()) backfills_->on_listener({peer->second, event.peer}, now);
  const bool is_stream = by_link_.count(event.flow) != 0;
  if (is_stream) sender_.set_wanted(peer->second, event.flow, true, now);
}

}  // namespace tocsin
