// SPDX-License-Identifier: Apache-2.0
#include "link_service.hpp"

#include "router_messages.hpp"

namespace tocsin {

void LinkParts::expect(const RemoteFlow& flow) const {
  receiver.on_stream(peers.find(flow.peer)->name, flow.wire_ids[0], flow.rule);
}

void LinkParts::forget(const RemoteFlow& flow) const {
  const LinkPeer* const peer = peers.find(flow.peer);
  if (peer != nullptr) receiver.forget_stream(peer->name, flow.wire_ids[0]);
}

router::Disposition LinkParts::on_arrived(const RemoteFlow& flow,
                                          const link_event::LinkSample& event, Time now) const {
  const LinkPeer* const peer = peers.find(flow.peer);
  if (peer == nullptr) return router::Disposition::unknown_stream;
  return receiver.on_arrived(
      peer->name, {flow.wire_ids[event.path], event.number, origin_of(event.sample)}, now);
}

}  // namespace tocsin
