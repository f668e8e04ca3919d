// SPDX-License-Identifier: Apache-2.0
#include "sim_link_bus.hpp"

#include <algorithm>
#include <utility>

#include "idl_support/encode.hpp"
#include "runtime/middleware/link_permissions.hpp"
#include "stop_bytes.hpp"

namespace tocsin::simulation {
namespace {

/// Until routers or a new flow know each other; on the real link a few exchanges of packets.
constexpr Duration meeting_takes = std::chrono::milliseconds(100);
/// A participant's announcement, with the headers of IP and UDP, and its period.
constexpr std::size_t announcement_bytes = 458 + 28;
constexpr Duration announcement_period = std::chrono::seconds(1);
constexpr std::uint8_t network_control_dscp = 48;  // CS6

/// A transmission on its way to one peer, which gets it when all its packets have come.
class Transmission final : public Cargo {
 public:
  Transmission(const Network& network, Overheard what, PeerId to, std::size_t packets)
      : network_(network),
        what_(std::move(what)),
        to_(to),
        missing_(packets, true),
        left_(packets) {}
  void arrive(std::size_t packet) override {
    if (!missing_[packet]) return;
    missing_[packet] = false;
    if (--left_ > 0) return;
    SimLinkBus* const to = network_.find_router(to_);
    if (to == nullptr) return;
    to->on_packet(what_.from, what_.stop);
    to->on_arrived(what_);
  }
  [[nodiscard]] bool waits_after(std::size_t packet) const override {
    return left_ > 1 || !missing_[packet];
  }

 private:
  const Network& network_;
  const Overheard what_;
  const PeerId to_;
  std::vector<bool> missing_;
  std::size_t left_;
};

const Freight& freight(const CarriedSample& sample) {
  return *static_cast<const Freight*>(sample.content.get());
}

std::string key_of(const Flow& flow) { return flow.topic + "|" + flow.user_data; }

}  // namespace

SimLinkBus::SimLinkBus(Network& network, const SimProcess& process, SimHost& host,
                       std::function<void()> on_event)
    : network_(network),
      process_(process),
      host_(host),
      on_event_(std::move(on_event)),
      life_(++network.router_lives) {
  const auto others = network_.routers;
  network_.routers[host_.name()] = this;
  for (const auto& entry : others) {
    if (entry.first == host_.name() || !is_peer(*entry.second)) continue;
    network_.core.events.at(network_.core.now + meeting_takes,
                            [&network, own = life_, other = entry.second->life_] {
                              SimLinkBus* const one = network.find_router(own);
                              SimLinkBus* const two = network.find_router(other);
                              if (one == nullptr || two == nullptr) return;
                              one->meet(*two);
                              two->meet(*one);
                              one->learn_all(*two);
                              two->learn_all(*one);
                            });
  }
  host_.set_router(this);
  announce();
  repeat_stop();
}

SimLinkBus::~SimLinkBus() {
  const auto found = network_.routers.find(host_.name());
  if (found == network_.routers.end() || found->second != this) return;
  network_.routers.erase(found);
  host_.set_router(nullptr);
  tell_observer(GateEvent::gone);
}

void SimLinkBus::on_gate(bool open) { tell_observer(open ? GateEvent::opened : GateEvent::closed); }

void SimLinkBus::tell_observer(GateEvent event) const {
  if (network_.observer() == nullptr) return;
  network_.observer()->on_gate({host_.name(), network_.core.now, event});
}

void SimLinkBus::announce() {
  if (!peers_.empty() && !process_.is_frozen()) {
    for (PathIndex path = 0; path < paths(); ++path) {
      radio(path).send({host_.direction(), network_control_dscp, network_.vehicle},
                       announcement_bytes, [] {});
      packets_.add_discovery(announcement_bytes);
      note_bytes(path, announcement_bytes);
    }
  }
  network_.core.events.at(network_.core.now + announcement_period,
                          [&network = network_, own = life_] {
                            if (SimLinkBus* const self = network.find_router(own)) self->announce();
                          });
}

void SimLinkBus::push(LinkEvent event) {
  events_.push_back(std::move(event));
  on_event_();
}

std::optional<LinkEvent> SimLinkBus::take() {
  if (events_.empty()) return std::nullopt;
  LinkEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

void SimLinkBus::meet(SimLinkBus& peer) {
  const auto before = peers_.find(peer.host_.name());
  const PeerId old = before == peers_.end() ? 0 : before->second;
  peers_[peer.host_.name()] = peer.life_;
  if (is_absent(peer.life_)) return;
  push(link_event::PeerFound{peer.life_, peer.host_.name()});
  if (old != 0) forget(old);
}

bool SimLinkBus::is_absent(PeerId peer) const {
  return std::any_of(peers_.begin(), peers_.end(), [&](const auto& one) {
    return one.second == peer && absent_.count(one.first) != 0;
  });
}

void SimLinkBus::set_absent(const std::set<std::string>& hosts) {
  const std::set<std::string> before = std::exchange(absent_, hosts);
  for (const auto& [host, life] : std::map(peers_)) {
    const bool is_absent = hosts.count(host) != 0;
    if (is_absent == (before.count(host) != 0)) continue;
    if (is_absent) {
      forget(life);
    } else if (SimLinkBus* const peer = network_.find_router(life)) {
      find_again(*peer);
    }
  }
}

void SimLinkBus::find_again(SimLinkBus& peer) {
  push(link_event::PeerFound{peer.life_, peer.host_.name()});
  learn_all(peer);
  for (const auto& [from, flow] : peer.read_) {
    if (from == life_) push(link_event::PeerReaderMatched{flow, peer.life_});
  }
}

void SimLinkBus::learn_all(SimLinkBus& peer) {
  for (const auto& entry : peer.sending_) learn(peer, entry.first);
}

void SimLinkBus::forget(PeerId peer) {
  for (auto it = peer_flows_.begin(); it != peer_flows_.end();) {
    if (it->first.first != peer) {
      ++it;
      continue;
    }
    known_.erase(it->second);
    read_.erase(it->first);
    push(link_event::PeerFlowGone{it->second});
    it = peer_flows_.erase(it);
  }
  push(link_event::PeerLost{peer});
}

void SimLinkBus::learn(SimLinkBus& peer, FlowId flow) {
  const auto found = peer.sending_.find(flow);
  if (found == peer.sending_.end() || peer_flows_.count({peer.life_, flow}) != 0) return;
  if (is_absent(peer.life_)) return;
  const std::string& topic = found->second.flow.topic;
  if (!rules().takes(topic) && !is_of_routers(rules(), topic)) return;
  for (PathIndex path = 0; path < paths(); ++path) learn(peer, flow, path);
  tell_reading(peer.life_, flow, topic);
}

void SimLinkBus::learn(SimLinkBus& peer, FlowId flow, PathIndex path) {
  const FlowId wire = wire_of(flow, path);
  const FlowId id = ++last_flow_;
  Flow what = peer.sending_.at(flow).flow;
  what.path = path;
  peer_flows_[{peer.life_, wire}] = id;
  known_[id] = what;
  push(link_event::PeerFlow{id, peer.life_, wire, what});
}

void SimLinkBus::tell_reading(PeerId peer, FlowId flow, const std::string& topic) {
  SimLinkBus* const other = network_.find_router(peer);
  const bool reads = !rules().takes_on_demand(topic) || host_.reads(topic);
  const bool did_read = read_.count({peer, flow}) != 0;
  if (other == nullptr || reads == did_read) return;
  if (reads) {
    read_.insert({peer, flow});
    other->push(link_event::PeerReaderMatched{flow, life_});
  } else {
    read_.erase({peer, flow});
    other->push(link_event::PeerReaderGone{flow, life_});
  }
}

void SimLinkBus::on_readers(const std::string& topic) {
  if (!rules().takes_on_demand(topic)) return;
  for (const auto& [from, id] : peer_flows_) {
    const Flow& flow = known_.at(id);
    if (flow.topic == topic && flow.path == 0) tell_reading(from.first, from.second, topic);
  }
}

void SimLinkBus::want(FlowId host_flow, bool wanted) {
  const auto found = std::find_if(host_flows_.begin(), host_flows_.end(),
                                  [&](const auto& entry) { return entry.second.id == host_flow; });
  if (found == host_flows_.end()) return;
  if (!wanted) return (void)idle_.insert(host_flow);
  if (idle_.erase(host_flow) == 0) return;  // they are taken already
  for (const SimProcess::Topic* writer : found->second.writers) {
    if (const Sample* const last = SimHost::last_of(*writer)) on_written(*writer, *last);
  }
}

FlowId SimLinkBus::open(const Flow& flow, TrafficClass traffic_class) {
  const FlowId id = ++last_flow_;
  sending_[id] = {flow, traffic_class, purpose_of(flow.topic), {}};
  for (const auto& peer : peers_) {
    network_.core.events.at(network_.core.now + meeting_takes,
                            [&network = network_, own = life_, other = peer.second, id] {
                              SimLinkBus* const one = network.find_router(own);
                              SimLinkBus* const two = network.find_router(other);
                              if (one != nullptr && two != nullptr) two->learn(*one, id);
                            });
  }
  return id;
}

void SimLinkBus::close(FlowId flow) {
  sending_.erase(flow);
  for (const auto& peer : peers_) {
    SimLinkBus* const other = network_.find_router(peer.second);
    if (other == nullptr) continue;
    for (PathIndex path = 0; path < paths(); ++path) other->unlearn(life_, wire_of(flow, path));
  }
}

void SimLinkBus::unlearn(PeerId peer, FlowId wire) {
  const auto found = peer_flows_.find({peer, wire});
  if (found == peer_flows_.end()) return;
  known_.erase(found->second);
  read_.erase(found->first);
  push(link_event::PeerFlowGone{found->second});
  peer_flows_.erase(found);
}

void SimLinkBus::note_bytes(PathIndex path, std::size_t bytes) {
  if (path != 0) packets_.second_bytes += bytes;
}

std::vector<std::size_t> SimLinkBus::packets_of(const Sending& sending, const CarriedSample& sample,
                                                SamplePiece piece) {
  if (sending.purpose != LinkPurpose::acknowledgements)
    return router::packets_of(sample.bytes, piece);
  return {router::packet_without_origin(sample.bytes)};
}

std::optional<std::uint64_t> SimLinkBus::send(FlowId flow, const CarriedSample& sample,
                                              SamplePiece piece, PathIndex path) {
  const auto found = sending_.find(flow);
  if (found == sending_.end()) return std::nullopt;
  Sending& sending = found->second;
  const std::uint64_t number = ++sending.last[path];
  const Freight& cargo = freight(sample);
  const std::size_t bytes_sent = piece.size(sample.bytes);
  if (network_.observer() != nullptr && cargo.from != nullptr) {
    network_.observer()->on_sent(
        {*cargo.from, network_.core.now, number, cargo.written, bytes_sent});
  }
  const auto packets = packets_of(sending, sample, piece);
  const auto stop = packets.size() == 1 ? rider() : nullptr;
  if (stop) stop_sent_[path] = network_.core.now;
  const Overheard what{life_, wire_of(flow, path), number, sample, piece, stop};
  if (network_.on_air) network_.on_air(what);
  for (const auto& peer : peers_) {
    if (absent_.count(peer.first) == 0) send(sending, what, packets, peer.second, path);
  }
  return number;
}

void SimLinkBus::send(const Sending& sending, const Overheard& what,
                      const std::vector<std::size_t>& packets, PeerId to, PathIndex path) {
  const auto transmission = std::make_shared<Transmission>(network_, what, to, packets.size());
  const std::uint8_t dscp = host_.rules().dscp(sending.traffic_class);
  const std::size_t riding = what.stop ? stop_bytes(*what.stop) : 0;
  for (std::size_t i = 0; i < packets.size(); ++i) {
    radio(path).send({host_.direction(), dscp, network_.vehicle}, packets[i] + riding, transmission,
                     i);
    packets_.add(sending.traffic_class, sending.purpose, packets[i]);
    note_bytes(path, packets[i] + riding);
    if (what.stop) packets_.add_stop(riding, false);
  }
}

void SimLinkBus::on_arrived(const Overheard& what) {
  const auto found = peer_flows_.find({what.from, what.flow});
  if (found == peer_flows_.end() || process_.is_frozen()) return;
  push(link_event::LinkSample{found->second, what.number, what.sample, network_.core.now,
                              what.piece});
}

std::optional<CarriedSample> SimLinkBus::compress(const CarriedSample& sample,
                                                  const CarriedSample* base) {
  const auto coding = coding_of(sample, base);
  if (!coding) return std::nullopt;
  const auto encoded = [](const CarriedSample& one) {
    return encode(*freight(one).type, freight(one).message.get());
  };
  CarriedSample compressed = sample;
  compressed.bytes = static_cast<std::uint32_t>(
      codec_.compress(encoded(sample), base != nullptr ? encoded(*base) : SampleCodec::Bytes{})
          .size());
  compressed.coding = *coding;
  return compressed;
}

std::optional<CarriedSample> SimLinkBus::restore(const CarriedSample& compressed,
                                                 const CarriedSample* /*base*/) {
  CarriedSample plain = compressed;
  const Freight& cargo = freight(compressed);
  plain.bytes = static_cast<std::uint32_t>(cargo.type->serialized_size(cargo.message.get()));
  plain.coding = {};
  return plain;
}

void SimLinkBus::offer(FlowId peer_flow) { push(link_event::HostReaderMatched{peer_flow}); }

FlowId SimLinkBus::offer(const Flow& flow) {
  const FlowId id = ++last_flow_;
  known_[id] = flow;
  push(link_event::HostReaderMatched{id});
  return id;
}

void SimLinkBus::deliver(FlowId flow, const CarriedSample& sample) {
  const auto found = known_.find(flow);
  if (found != known_.end()) host_.deliver_carried(found->second, sample, freight(sample));
}

CarriedSample SimLinkBus::pack(const TypeInfo& type, std::shared_ptr<const void> message) const {
  CarriedSample sample;
  sample.bytes = static_cast<std::uint32_t>(type.serialized_size(message.get()));
  sample.content = std::make_shared<Freight>(Freight{std::move(message), nullptr, 0, {}, &type});
  return sample;
}

std::shared_ptr<const void> SimLinkBus::unpack(const TypeInfo&, const CarriedSample& sample) const {
  return freight(sample).message;
}

Flow SimLinkBus::flow_of(const SimProcess::Topic& topic) {
  Flow flow;
  flow.topic = topic.endpoint.topic.name;
  flow.type = topic.endpoint.type->name;
  flow.reliable = topic.qos.reliable();
  flow.transient_local = topic.qos.keeps_last();
  flow.depth = topic.qos.depth;
  flow.lifespan_s = topic.qos.lifespan_s;
  flow.user_data = topic.end.user_data;
  return flow;
}

void SimLinkBus::on_writer(const SimProcess::Topic& topic) {
  const Flow flow = flow_of(topic);
  if (host_.rules().find(flow.topic) == nullptr) return;
  HostFlow& known = host_flows_[key_of(flow)];
  known.writers.push_back(&topic);
  if (known.writers.size() == 1) {
    known.id = ++last_flow_;
    if (rules().waits_for_demand(flow.topic)) idle_.insert(known.id);
  }
  flow_by_writer_[&topic] = known.id;
  if (known.writers.size() > 1) return;
  push(link_event::HostFlow{known.id, flow});
}

void SimLinkBus::on_writer_gone(const SimProcess::Topic& topic) {
  const auto found = host_flows_.find(key_of(flow_of(topic)));
  if (found == host_flows_.end()) return;
  auto& writers = found->second.writers;
  writers.erase(std::remove(writers.begin(), writers.end(), &topic), writers.end());
  flow_by_writer_.erase(&topic);
  if (!writers.empty()) return;
  push(link_event::HostFlowGone{found->second.id});
  idle_.erase(found->second.id);
  host_flows_.erase(found);
}

void SimLinkBus::on_written(const SimProcess::Topic& topic, const Sample& sample) {
  const auto found = flow_by_writer_.find(&topic);
  if (found == flow_by_writer_.end() || idle_.count(found->second) != 0) return;
  CarriedSample carried;
  carried.bytes =
      static_cast<std::uint32_t>(topic.endpoint.type->serialized_size(sample.message.get()));
  carried.content = std::make_shared<Freight>(
      Freight{sample.message, &topic.end, sample.sequence, sample.received, topic.endpoint.type});
  carried.source = sample.source;
  carried.sequence = sample.sequence;
  carried.sent_wall_ns = sample.sent_wall_ns;
  push(link_event::HostSample{found->second, std::move(carried), network_.core.now});
}

}  // namespace tocsin::simulation
