// SPDX-License-Identifier: Apache-2.0
#include "router_radio.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "link_router/wire_cost.hpp"

namespace tocsin::bench {
namespace {

constexpr const char* peer = "peer";
constexpr std::size_t origin_bytes = 32;  // as in wire_cost()
constexpr std::size_t echo_bytes = 92;
/// An acknowledgement as CDR with 32 bits for numbers and 16 for ages.
constexpr std::size_t empty_acknowledgement_bytes = 28;
constexpr std::size_t stream_acknowledgement_bytes = 18;

/// What the receiver knows a stream by on a path, and back.
constexpr router::StreamId second_path = 1U << 20U;
router::StreamId wire_of(router::StreamId stream, PathIndex path) {
  return path == 0 ? stream : stream + second_path;
}
router::LinkAcknowledgement by_stream(router::LinkAcknowledgement acknowledgement) {
  for (router::StreamAcknowledgement& one : acknowledgement.streams) one.stream %= second_path;
  return acknowledgement;
}

}  // namespace

radio::ChannelParams lossy_channel(double loss, double delay_s) {
  radio::ChannelParams params;
  params.mode = "bernoulli";
  params.loss = loss;
  params.delay_s = delay_s;
  return params;
}

router::StreamRule stream_rule(const char* name, TrafficClass traffic_class) {
  router::StreamRule rule;
  rule.name = name;
  rule.traffic_class = traffic_class;
  rule.repaired = policy_of(traffic_class).repaired;
  return rule;
}

RouterRadio::RouterRadio(radio::RadioChannel& channel, const Setup& setup, Time start)
    : channels_{&channel}, dscp_(setup.dscp), vehicle_(setup.vehicle) {
  if (setup.second != nullptr) channels_.push_back(setup.second);
  for (std::size_t side = 0; side < 2; ++side) {
    senders_[side] = std::make_unique<router::LinkSender>(setup.params);
    receivers_[side] = std::make_unique<router::LinkReceiver>();
    const router::InstanceId instance = 101 * vehicle_ + 2 - side;
    senders_[side]->on_peer(peer, instance, start);
    receivers_[side]->on_peer(peer, instance);
    if (setup.second != nullptr) senders_[side]->add_path();
  }
}

void RouterRadio::add_stream(std::size_t side, router::StreamId stream,
                             const router::StreamRule& rule, Time now) {
  senders_[side]->add_stream(stream, rule);
  senders_[side]->set_wanted(peer, stream, true, now);
  for (PathIndex path = 0; path < paths(); ++path) {
    receivers_[1 - side]->on_stream(peer, wire_of(stream, path), rule, path);
  }
  classes_[stream] = rule.traffic_class;
}

void RouterRadio::send_echo(Time now) {
  send({Echo{true}, 1, TrafficClass::low, 1}, {echo_bytes}, now);
}

void RouterRadio::send(Cargo cargo, const std::vector<std::size_t>& packets, Time now) {
  const auto direction = cargo.to == 1 ? radio::Direction::uplink : radio::Direction::downlink;
  const auto category = radio::access_category_of_dscp(dscp_.of(cargo.traffic_class));
  const auto shared = std::make_shared<Cargo>(std::move(cargo));
  for (const std::size_t bytes : packets) {
    const radio::Packet packet{static_cast<int>(bytes), false, category, vehicle_};
    under_way_[shared->path][channels_[shared->path]->push(direction, packet, now)] = shared;
  }
}

void RouterRadio::send(std::size_t side, const router::Transmission& one, Time now) {
  const auto packets = router::packets_of(one.sample.bytes, one.piece);
  if (one.repair) ++repairs_;
  packets_[one.stream] += packets.size();
  bytes_[one.stream] += std::accumulate(packets.begin(), packets.end(), std::size_t{0});
  const router::TransmissionNumber number = ++numbers_[side][wire_of(one.stream, one.path)];
  senders_[side]->on_written(one, number);
  send({one, 1 - side, classes_.at(one.stream), packets.size(), number, one.path}, packets, now);
}

void RouterRadio::send(std::size_t side, const router::LinkAcknowledgement& acknowledgement,
                       PathIndex path, Time now) {
  const std::size_t bytes =
      empty_acknowledgement_bytes + stream_acknowledgement_bytes * acknowledgement.streams.size();
  ++acknowledgements_;
  const std::size_t packet = router::packet_without_origin(bytes);
  acknowledgement_bytes_ += static_cast<double>(packet);
  send({acknowledgement, 1 - side, TrafficClass::critical, 1, 0, path}, {packet}, now);
}

void RouterRadio::serve(Time now) {
  for (std::size_t side = 0; side < 2; ++side) {
    receivers_[side]->set_acknowledgement_period(senders_[side]->acknowledgement_period());
    while (const auto one = senders_[side]->next(now)) send(side, *one, now);
    while (const auto acknowledgement = receivers_[side]->take_acknowledgement(now)) {
      for (PathIndex path = 0; path < paths(); ++path) {
        if (!acknowledgement->paths[path]) continue;
        send(side, by_stream(acknowledgement->acknowledgement), path, now);
      }
    }
  }
}

Time RouterRadio::next_event(Time now) const {
  Time next = never;
  for (const auto* channel : channels_) next = std::min(next, channel->next_event());
  for (std::size_t side = 0; side < 2; ++side) {
    next = std::min({next, senders_[side]->deadline(now), receivers_[side]->deadline()});
  }
  return next;
}

void RouterRadio::advance(Time now, const Deliver& deliver) {
  for (PathIndex path = 0; path < paths(); ++path) advance(path, now, deliver);
}

void RouterRadio::advance(PathIndex path, Time now, const Deliver& deliver) {
  radio::RadioChannel& channel = *channels_[path];
  channel.advance(now);
  while (const auto outcome = channel.take()) end(path, *outcome, deliver);
}

void RouterRadio::end(PathIndex path, const radio::Outcome& outcome, const Deliver& deliver) {
  const auto found = under_way_[path].find(outcome.id);
  const std::shared_ptr<Cargo> cargo = found->second;
  under_way_[path].erase(found);
  if (outcome.fate != radio::Fate::delivered || --cargo->missing > 0) return;
  arrive(*cargo, outcome.at, deliver);
}

void RouterRadio::arrive(const Cargo& cargo, Time now, const Deliver& deliver) {
  if (const auto* acknowledgement = std::get_if<router::LinkAcknowledgement>(&cargo.what)) {
    return senders_[cargo.to]->on_acknowledgement(peer, *acknowledgement, now);
  }
  if (const auto* echo = std::get_if<Echo>(&cargo.what)) {
    if (echo->is_request) send({Echo{false}, 0, TrafficClass::low, 1}, {echo_bytes}, now);
    return;
  }
  const auto& one = std::get<router::Transmission>(cargo.what);
  router::LinkReceiver& receiver = *receivers_[cargo.to];
  const router::Arrived arrived{wire_of(one.stream, one.path),
                                cargo.number,
                                one.sample.origin,
                                one.piece,
                                nullptr,
                                one.sample.coding};
  if (!receiver.on_piece(peer, arrived, now) || !usable_(one)) return;
  if (receiver.on_arrived(peer, arrived, now) == router::Disposition::deliver) {
    deliver(cargo.to, one.stream, one.sample.origin, now);
  }
}

}  // namespace tocsin::bench
