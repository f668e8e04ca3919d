// SPDX-License-Identifier: Apache-2.0
#include "link/fast_dds_link_bus.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "graph/ros_graph.hpp"
#include "idl_support/decode.hpp"
#include "idl_support/encode.hpp"
#include "keystore/participant.hpp"
#include "link/encoded_piece.hpp"
#include "link/flow_qos.hpp"
#include "link/router_name.hpp"
#include "link/sound_identity.hpp"
#include "rtps/origin.hpp"
#include "rtps/this_host.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/link_limits.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {
namespace {

/// [B] What Fast DDS sends whole in a packet (link_router/wire_cost.hpp), less the header of a
/// piece.
constexpr std::size_t largest_plain_piece = 1188;
/// The same where payloads are encrypted and submessages signed, for up to three peers.
constexpr std::size_t largest_sealed_piece = 1000;

Time steady_now() { return std::chrono::steady_clock::now(); }

const std::vector<std::uint8_t> none;

CarriedSample with_content(CarriedSample sample, std::vector<std::uint8_t> bytes) {
  sample.bytes = static_cast<std::uint32_t>(bytes.size());
  sample.content = std::make_shared<EncodedMessage>(EncodedMessage{std::move(bytes)});
  return sample;
}

StopChannel::Options stop_options(const BusOptions& options, std::function<void()> on_news) {
  auto peers = ipv4_addresses(options.link_peers);
  const auto by_second = ipv4_addresses(options.second_peers);
  peers.insert(peers.end(), by_second.begin(), by_second.end());
  return {std::move(peers), options.enclave, radio_message_bytes, std::move(on_news)};
}

}  // namespace

FastDdsLinkBus::FastDdsLinkBus(const BusOptions& options, std::function<void()> on_event)
    : options_(with_sound_identity(options)),
      rules_(options.traffic_file, options.role, options.chain),
      expected_(options.peer_names),
      table_(options.ros_namespace, rules_, std::move(on_event)),
      service_table_(options.ros_namespace, [this] { table_.wake(); }),
      stop_(std::make_shared<StopChannel>(stop_options(options_, [this] { table_.wake(); }))),
      numbers_(std::make_shared<WriterNumbers>([this] { table_.wake(); })),
      nodes_(options.ros_namespace),
      host_(host_options()),
      graph_(host_, options_.gid_size),
      services_({host_, options_.ros_namespace, service_table_, nodes_, log_}),
      host_readers_([this](const ReaderKey& key) { return make_host_reader(key); }),
      link_readers_([this](const ReaderKey& key) {
        return std::make_unique<FlowReader>(
            *link_, key, [this](TakenSample&& taken) { on_link_sample(std::move(taken)); });
      }) {
  const auto addresses = link_addresses();
  if (LateInterface::any_runs(addresses)) {
    join_link();
    return;
  }
  log_.warn("no interface with {} is up; link topics wait for it", joined(addresses, " or "));
  late_ = std::make_unique<LateInterface>(addresses, [this] {
    interface_is_up_ = true;
    table_.wake();
    return true;
  });
}

std::vector<std::string> FastDdsLinkBus::link_addresses() const {
  std::vector<std::string> addresses{options_.link_address};
  if (!options_.second_address.empty()) addresses.push_back(options_.second_address);
  return addresses;
}

ParticipantOptions FastDdsLinkBus::host_options() {
  ParticipantOptions host;
  host.name = options_.name + "_router";
  host.domain = options_.host_domain;
  host.user_data = participant_data_for(options_.vehicle);
  host.on_end = [this](const auto& guid, const AnnouncedEnd& end, bool there) {
    table_.on_host_end(guid, end, there);
    service_table_.on_end(guid, end, there);
    if (end.topic != discovery_topic) return;
    nodes_.note_listener();
    table_.wake();
  };
  return host;
}

ParticipantOptions FastDdsLinkBus::link_options() {
  ParticipantOptions link{options_.host + router_suffix, options_.link_domain,
                          options_.link_address, options_.link_peers};
  link.second_address = options_.second_address;
  link.second_peers = options_.second_peers;
  link.marks = marks_;
  link.stop = stop_;
  link.enclave = options_.enclave;
  // On a secured link a forged number is thrown away with its signature.
  if (options_.enclave.empty()) link.numbers = numbers_;
  link.on_end = [this](const auto& guid, const AnnouncedEnd& end, bool there) {
    if (!expected_.is_refused(guid.guidPrefix)) table_.on_link_end(guid, end, there);
  };
  link.on_participant = [this](const auto& prefix, const std::string& name, bool there) {
    on_link_participant(prefix, name, there);
  };
  return link;
}

void FastDdsLinkBus::on_link_participant(const RemoteEnds::Participant& participant,
                                         const std::string& name, bool there) {
  const std::string peer = peer_name(participant, host_in(name));
  if (!there) {
    outside_readers_.on_gone(participant);
    if (expected_.forget(participant)) return;
  } else {
    const auto judgement = expected_.judge(participant, peer);
    if (judgement == ExpectedPeers::Judgement::refused) {
      log_.warn("'{}' has come on the link to {}; nothing of it is taken", printable(peer),
                joined(expected_.names()));
    }
    if (judgement != ExpectedPeers::Judgement::expected) return;
    if (host_in(name) != name) outside_readers_.on_router(participant);
  }
  table_.on_peer(participant, peer, there, steady_now());
}

StopNews FastDdsLinkBus::take_stop_news() {
  StopNews news = stop_->take_news();
  const auto of_another = [this](const ReceivedStop& one) {
    return !one.identity.empty() && !expected_.takes_subject(one.identity);
  };
  auto& values = news.values;
  values.erase(std::remove_if(values.begin(), values.end(), of_another), values.end());
  return news;
}

std::string FastDdsLinkBus::peer_name(const RemoteEnds::Participant& participant,
                                      const std::string& host) const {
  if (options_.enclave.empty() || host.empty()) return host;
  keystore::GuidStart identity{};
  std::copy_n(participant.value, identity.size(), identity.begin());
  // uxv12 is not uxv1 where vehicles are known by their names.
  return expected_.names().empty() ? keystore::proven_name(host, identity)
                                   : keystore::exact_name(host, identity);
}

void FastDdsLinkBus::join_link() {
  link_ = std::make_unique<FastDdsParticipant>(link_options());
  for (auto& entry : sending_) connect(entry.first, entry.second);
}

void FastDdsLinkBus::connect(FlowId id, Sending& sending) {
  const std::string topic = link_names().on_wire(sending.flow.topic);
  const TrafficRule* const rule = rules_.find(sending.flow.topic);
  const bool on_demand = rule != nullptr && rule->on_demand;
  for (PathIndex path = 0; path < paths(); ++path) {
    const auto on_reader = [this, id, on_demand, path](const auto& peer, bool there) {
      if (there && peer != link_->prefix()) outside_readers_.on_reader(peer);
      // Who reads it reads it on each path.
      if (path == 0 && (there || on_demand)) table_.on_peer_listens(peer, id, there);
    };
    Flow flow = sending.flow;
    flow.path = path;
    auto& writer = sending.writers[path];
    try {
      writer =
          std::make_unique<FlowWriter>(*link_, topic, flow.type, offered_on_link(flow), on_reader);
    } catch (const EnvironmentError& error) {
      return log_refusal("send", topic, error);
    }
    marks_->set(writer->entity(),
                {rules_.dscp(sending.traffic_class), sending.traffic_class, sending.purpose, path});
  }
}

std::optional<LinkEvent> FastDdsLinkBus::take() {
  if (interface_is_up_.exchange(false)) {
    join_link();
    log_.info("an interface with {} is up; link topics cross it", joined(link_addresses(), " or "));
  }
  auto event = table_.pop();
  if (!event) {
    follow_demand();
    hear_the_muted();
    for (const auto& former : table_.take_superseded()) link_->supersede(former);
    graph_.follow(nodes_);
    return event;
  }
  const auto* host = std::get_if<link_event::HostFlow>(&*event);
  if (host != nullptr && !rules_.waits_for_demand(host->what.topic)) {
    listen_on_host(host->flow, host->what);
  }
  if (const auto* gone = std::get_if<link_event::HostFlowGone>(&*event)) {
    wanted_.erase(gone->flow) != 0 ? host_readers_.drop(gone->flow)
                                   : host_readers_.remove(gone->flow);
  }
  const auto* peer = std::get_if<link_event::PeerFlow>(&*event);
  if (peer != nullptr && !rules_.takes_on_demand(peer->what.topic)) {
    listen_on_link(peer->flow, peer->what);
  }
  if (const auto* gone = std::get_if<link_event::PeerFlowGone>(&*event)) {
    giving_.erase(gone->flow);
    // A reader that stays for who is restarted would ask for what nobody reads.
    demand_.forget(gone->flow) ? link_readers_.drop(gone->flow) : link_readers_.remove(gone->flow);
  }
  return event;
}

std::unique_ptr<FlowReader> FastDdsLinkBus::make_host_reader(const ReaderKey& key) {
  auto reader = std::make_unique<FlowReader>(
      host_, key, [this, key](TakenSample&& taken) { on_host_sample(key, std::move(taken)); });
  reader->belong(nodes_, router_node);
  return reader;
}

void FastDdsLinkBus::listen_on_host(FlowId id, const Flow& flow) {
  host_readers_.add(
      id, {table_.names().on_wire(flow.topic), flow.type, flow.reliable, flow.transient_local});
}

void FastDdsLinkBus::listen_on_link(FlowId id, const Flow& flow, bool anew) {
  const ReaderKey key{link_names().on_wire(flow.topic), flow.type};
  try {
    anew ? link_readers_.renew(id) : link_readers_.add(id, key);
  } catch (const EnvironmentError& error) {
    log_refusal("receive", key.topic, error);
  }
}

void FastDdsLinkBus::follow_demand() {
  for (const auto& [id, is_read] : demand_.take_changed()) {
    if (!is_read) link_readers_.drop(id);
    const auto flow = is_read ? table_.find(id) : std::nullopt;
    if (flow) listen_on_link(id, *flow);
  }
}

void FastDdsLinkBus::hear_the_muted() {
  for (const auto& writer : numbers_->take_muted()) {
    const auto id = table_.flow_of(writer);
    const auto flow = id ? table_.find(*id) : std::nullopt;
    if (!flow) continue;
    log_.warn("a forged number muted {}; it is received again", flow->topic);
    listen_on_link(*id, *flow, true);
  }
}

void FastDdsLinkBus::log_refusal(const char* what, const std::string& topic,
                                 const EnvironmentError& error) {
  if (options_.enclave.empty()) return log_.error("{}", error.what());
  log_.error("the identity in {} may not {} {}; `tocsin keystore permit` allows it",
             options_.enclave, what, topic);
}

/// While this process was stopped.
bool FastDdsLinkBus::has_outlived_its_lifespan(const TakenSample& taken, FlowId id) const {
  constexpr Duration at_once = std::chrono::milliseconds(50);  // spares the look at the flow
  if (taken.waited <= at_once) return false;
  const auto flow = table_.find(id);
  return flow && taken.waited > seconds(flow->lifespan_s);
}

/// A best-effort reader also hears writers that offer more, which have a reader of their own.
void FastDdsLinkBus::on_host_sample(const ReaderKey& key, TakenSample&& taken) {
  const auto id = table_.flow_of(taken.writer, key.reliable, key.transient_local);
  if (!id || has_outlived_its_lifespan(taken, *id)) return;
  taken.sample.coding = {};  // whoever says otherwise: on a host nothing is compressed
  table_.push(link_event::HostSample{*id, std::move(taken.sample), steady_now() - taken.waited});
}

void FastDdsLinkBus::on_link_sample(TakenSample&& taken) {
  if (!table_.on_received(taken.writer, steady_now())) return;
  const auto id = table_.flow_of(taken.writer);
  if (!id || has_outlived_its_lifespan(taken, *id)) return;
  table_.push(link_event::LinkSample{*id, taken.number, std::move(taken.sample),
                                     steady_now() - taken.waited, taken.piece});
}

void FastDdsLinkBus::want(FlowId host_flow, bool wanted) {
  const auto flow = wanted ? table_.find(host_flow) : std::nullopt;
  if (!flow) {
    wanted_.erase(host_flow);
    return host_readers_.drop(host_flow);
  }
  wanted_.insert(host_flow);
  listen_on_host(host_flow, *flow);
}

/// Who has no sites has one peer, whatever that is called.
void FastDdsLinkBus::set_absent(const std::set<std::string>& hosts) {
  table_.set_absent(hosts);
  std::set<std::uint32_t> muted;
  const auto mute = [&](const std::vector<std::string>& peers) {
    const auto addresses = ipv4_addresses(peers);
    for (std::size_t i = 0; i < addresses.size(); ++i) {
      const bool is_named = i < options_.sites.size();
      if (is_named ? hosts.count(options_.sites[i]) != 0 : !hosts.empty()) {
        muted.insert(addresses[i]);
      }
    }
  };
  mute(options_.link_peers);
  mute(options_.second_peers);
  marks_->mute(std::move(muted));
}

FlowId FastDdsLinkBus::open(const Flow& flow, TrafficClass traffic_class) {
  const FlowId id = table_.fresh_id();
  Sending& sending = sending_[id];
  sending.flow = flow;
  sending.traffic_class = traffic_class;
  sending.purpose = purpose_of(flow.topic);
  if (link_) connect(id, sending);
  return id;
}

std::uint32_t FastDdsLinkBus::wire_id(FlowId flow, PathIndex path) const {
  const auto found = sending_.find(flow);
  const bool known = found != sending_.end() && found->second.writers[path];
  return known ? wire_id_of(found->second.writers[path]->entity()) : 0;
}

void FastDdsLinkBus::close(FlowId flow) {
  const auto found = sending_.find(flow);
  if (found == sending_.end()) return;
  for (const auto& writer : found->second.writers) {
    if (writer) marks_->forget(writer->entity());
  }
  sending_.erase(found);
}

std::optional<std::uint64_t> FastDdsLinkBus::send(FlowId flow, const CarriedSample& sample,
                                                  SamplePiece piece, PathIndex path) {
  const auto found = sending_.find(flow);
  if (found == sending_.end() || !found->second.writers[path]) return std::nullopt;
  FlowWriter& writer = *found->second.writers[path];
  const bool is_own = found->second.purpose == LinkPurpose::acknowledgements;
  return is_own ? writer.write_own(sample) : writer.write(sample, piece);
}

std::size_t FastDdsLinkBus::largest_piece() const {
  if (outside_readers_.any()) return 0;
  return options_.enclave.empty() ? largest_plain_piece : largest_sealed_piece;
}

CarriedSample FastDdsLinkBus::join(const CarriedSample& last,
                                   const std::vector<std::shared_ptr<const void>>& pieces) const {
  return with_content(last, put_together(pieces).bytes);
}

std::optional<CarriedSample> FastDdsLinkBus::compress(const CarriedSample& sample,
                                                      const CarriedSample* base) {
  const auto coding = coding_of(sample, base);
  if (!coding) return std::nullopt;
  auto bytes =
      codec_.compress(content_of(sample).bytes, base != nullptr ? content_of(*base).bytes : none);
  CarriedSample compressed = with_content(sample, std::move(bytes));
  compressed.coding = *coding;
  return compressed;
}

std::optional<CarriedSample> FastDdsLinkBus::restore(const CarriedSample& compressed,
                                                     const CarriedSample* base) {
  auto bytes = codec_.restore(content_of(compressed).bytes,
                              base != nullptr ? content_of(*base).bytes : none);
  if (!bytes) return std::nullopt;
  CarriedSample plain = with_content(compressed, std::move(*bytes));
  plain.coding = {};
  return plain;
}

void FastDdsLinkBus::say_stop(const StopValue& value) {
  StopValue named = value;
  named.host = options_.host;
  stop_->say(named, std::chrono::steady_clock::now());
}

void FastDdsLinkBus::offer(FlowId id, const Flow& flow) {
  const std::string topic = table_.names().on_wire(flow.topic);
  const auto on_reader = [this, id, on_demand = rules_.takes_on_demand(flow.topic)](
                             const auto& reader, bool there) {
    if (reader == host_.prefix()) return;
    if (on_demand) demand_.count(id, there);
    there ? table_.push(link_event::HostReaderMatched{id}) : table_.wake();
  };
  try {
    auto& writer = giving_[id];
    writer = std::make_unique<FlowWriter>(host_, topic, flow.type, offered(flow), on_reader);
    writer->belong(nodes_, router_node);
  } catch (const EnvironmentError& error) {
    log_.error("{}", error.what());
  }
}

void FastDdsLinkBus::offer(FlowId peer_flow) {
  const auto flow = table_.find(peer_flow);
  if (flow) offer(peer_flow, *flow);  // else it has left meanwhile
}

FlowId FastDdsLinkBus::offer(const Flow& flow) {
  const FlowId id = table_.fresh_id();
  offer(id, flow);
  return id;
}

void FastDdsLinkBus::deliver(FlowId flow, const CarriedSample& sample) {
  const auto found = giving_.find(flow);
  if (found != giving_.end()) (void)found->second->write(sample);
}

std::vector<std::uint8_t> FastDdsLinkBus::bytes_of(const CarriedSample& sample) const {
  return content_of(sample).bytes;
}

CarriedSample FastDdsLinkBus::sample_of(std::vector<std::uint8_t> bytes) const {
  return with_content({}, std::move(bytes));
}

CarriedSample FastDdsLinkBus::pack(const TypeInfo& type,
                                   std::shared_ptr<const void> message) const {
  return sample_of(encode(type, message.get()));
}

std::shared_ptr<const void> FastDdsLinkBus::unpack(const TypeInfo& type,
                                                   const CarriedSample& sample) const {
  return decode(type, content_of(sample).bytes);
}

std::unique_ptr<LinkBus> make_fast_dds_link_bus(const BusOptions& options,
                                                std::function<void()> on_event) {
  return std::make_unique<FastDdsLinkBus>(options, std::move(on_event));
}

}  // namespace tocsin
