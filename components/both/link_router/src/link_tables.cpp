// SPDX-License-Identifier: Apache-2.0
#include "link_tables.hpp"

#include "router_messages.hpp"

namespace tocsin {

void LinkPeers::add(const LinkPeer& peer) {
  all_[peer.instance] = peer;
  present_[peer.name] = peer.instance;
}

void LinkPeers::remove(PeerId instance) {
  const auto found = all_.find(instance);
  if (found == all_.end()) return;
  if (is_present(found->second)) present_.erase(found->second.name);
  all_.erase(found);
}

const LinkPeer* LinkPeers::find(PeerId instance) const {
  const auto found = all_.find(instance);
  return found == all_.end() ? nullptr : &found->second;
}

const LinkPeer* LinkPeers::find(const std::string& name) const {
  const auto found = present_.find(name);
  return found == present_.end() ? nullptr : find(found->second);
}

bool LinkPeers::is_present(const LinkPeer& peer) const {
  const auto found = present_.find(peer.name);
  return found != present_.end() && found->second == peer.instance;
}

LinkStreams::LinkStreams(LinkBus& link, router::LinkSender& sender) : link_(link), sender_(sender) {
  sender_.set_compress([this](const router::Sample& plain,
                              const router::Sample* base) -> std::optional<router::Sample> {
    std::optional<CarriedSample> known;
    if (base != nullptr) known = carried(*base);
    const auto compressed = link_.compress(carried(plain), known ? &*known : nullptr);
    if (!compressed) return std::nullopt;
    return sample_of(*compressed);
  });
}

void LinkStreams::add(FlowId flow, const router::StreamRule& rule) {
  sent_bytes_[flow] = {};
  sender_.add_stream(flow, rule);
}

void LinkStreams::add_backfill(FlowId flow) {
  sent_bytes_[flow] = {};
  sender_.add_backfill_stream(flow);
}

void LinkStreams::remove(FlowId flow) {
  sent_bytes_.erase(flow);
  sender_.remove_stream(flow);
}

std::optional<StreamPath> LinkStreams::find(std::uint32_t wire_id) const {
  for (const auto& entry : sent_bytes_) {
    for (PathIndex path = 0; path < link_.paths(); ++path) {
      if (link_.wire_id(entry.first, path) == wire_id) return StreamPath{entry.first, path};
    }
  }
  return std::nullopt;
}

void LinkStreams::send(Time now) {
  while (const auto transmission = sender_.next(now)) {
    const router::Sample& sample = transmission->sample;
    const auto number =
        link_.send(transmission->stream, carried(sample), transmission->piece, transmission->path);
    if (!number) continue;
    sender_.on_written(*transmission, *number);
    SentBytes& sent = sent_bytes_.at(transmission->stream);
    sent.bytes += transmission->piece.size(sample.bytes);
    sent.plain += transmission->plain_bytes;
  }
}

}  // namespace tocsin
