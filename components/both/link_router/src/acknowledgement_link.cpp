// SPDX-License-Identifier: Apache-2.0
#include "acknowledgement_link.hpp"

#include <utility>

#include "router_messages.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {
namespace {

Flow acknowledgement_flow() {
  Flow flow;
  flow.topic = link_acknowledgement_topic;
  flow.type = type_info<AcknowledgementMessage>().name;
  return flow;
}

}  // namespace

AcknowledgementLink::AcknowledgementLink(const LinkParts& parts, const Services& services)
    : parts_(parts),
      services_(services),
      flow_(parts.link.open(acknowledgement_flow(), TrafficClass::critical)) {}

bool AcknowledgementLink::takes(const std::string& topic) const {
  return topic == link_acknowledgement_topic;
}

void AcknowledgementLink::on_remote(const RemoteFlow& flow, const link_event::LinkSample& event,
                                    Instant at) {
  const auto content = parts_.link.unpack(type_info<AcknowledgementMessage>(), event.sample);
  const auto* message = static_cast<const AcknowledgementMessage*>(content.get());
  if (message == nullptr || message->to_instance() != parts_.link.self() || !is_sound(*message))
    return;
  const LinkPeer& from = *parts_.peers.find(flow.peer);
  for (const auto& service : services_) service->on_acknowledgement(from, *message, at.now);
}

void AcknowledgementLink::finish(Instant at) {
  while (const auto due = parts_.receiver.take_acknowledgement(at.now)) {
    auto message = std::make_shared<AcknowledgementMessage>(to_message(due->acknowledgement));
    const LinkPeer* const known = parts_.peers.find(due->peer);
    const LinkPeer to = known != nullptr ? *known : LinkPeer{due->peer, 0};
    message->from_instance(parts_.link.self());
    message->to_instance(to.instance);
    for (const auto& service : services_) service->add_to(*message, to, at.now);
    const CarriedSample packed =
        parts_.link.pack(type_info<AcknowledgementMessage>(), std::move(message));
    // One that the middleware refuses is as good as lost: the next one has the same content.
    for (PathIndex path = 0; path < parts_.link.paths(); ++path) {
      if (due->paths[path]) (void)parts_.link.send(flow_, packed, {}, path);
    }
  }
}

}  // namespace tocsin
