// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"

namespace tocsin::router {

inline constexpr Time t0{std::chrono::hours(1)};
inline constexpr Duration ms = std::chrono::milliseconds(1);
/// The station's clock shows another time.
inline constexpr Duration clock_difference = std::chrono::hours(77);

inline StreamRule rule_of(TrafficClass traffic_class) {
  StreamRule rule;
  rule.name = "topic";
  rule.traffic_class = traffic_class;
  rule.repaired = policy_of(traffic_class).repaired;
  return rule;
}

/// The router of a vehicle as sender and that of a station as receiver, with a link between them
/// that a test can compute in its head: everything arrives 2 ms later, in order; bulk takes 1 ms a
/// packet on top. Time goes on in steps of 1 ms.
class LinkPair {
 public:
  explicit LinkPair(const LinkRouterParams& params = {}) : sender(params) {
    sender.on_peer("station", 2, now);
    receiver.on_peer("vehicle", 1);
  }

  /// A second path, which is as the first.
  void add_path() { sender.add_path(); }

  void add(StreamId stream, StreamRule rule) {
    rule.name += std::to_string(stream);
    sender.add_stream(stream, rule);
    receiver.on_stream("vehicle", stream, rule);
    receiver.on_stream("vehicle", stream + second_wire, rule, 1);
    sender.set_wanted("station", stream, true, now);
  }

  void offer(StreamId stream, std::uint64_t sequence, std::size_t bytes = 200) {
    sender.offer(stream, {{7, sequence, now}, bytes, nullptr}, now);
  }

  /// Calls `each` before every step.
  void run(
      Duration length, const std::function<void()>& each = [] {}) {
    for (const Time end = now + length; now < end; now += ms) {
      each();
      sender.begin(now);
      send();
      arrive();
      while (const auto acknowledgement = receiver.take_acknowledgement(now + clock_difference)) {
        ++acknowledgements;
        if (acknowledgements_lost || dead || !comes_back(acknowledgement->paths)) continue;
        sender.on_acknowledgement("station", by_stream(acknowledgement->acknowledgement), now);
      }
    }
  }

  /// The sender's process stands still; what it has begun to send leaves afterwards.
  void freeze(Duration length) { now += length; }

  [[nodiscard]] ClassCounts counts(TrafficClass traffic_class) const {
    return sender.state(now).classes[index_of(traffic_class)];
  }
  [[nodiscard]] std::size_t count_sent(StreamId stream) const {
    std::size_t count = 0;
    for (const Transmission& one : sent) count += one.stream == stream ? 1 : 0;
    return count;
  }

  Time now = t0;
  LinkSender sender;
  LinkReceiver receiver;
  bool dead = false;                          ///< nothing crosses
  std::array<bool, most_paths> dead_paths{};  ///< nothing crosses by it
  std::array<Duration, most_paths> delays{2 * ms, 2 * ms};
  /// Of what is sent, what the radio loses.
  std::function<bool(const Transmission&)> loses = [](const Transmission&) { return false; };
  bool acknowledgements_lost = false;  ///< of the way back only
  std::vector<Transmission> sent;
  std::map<StreamId, std::vector<std::uint64_t>> delivered;  ///< sequences
  int acknowledgements = 0;

 private:
  /// Wire ids of the second path are those of the first and so much.
  static constexpr StreamId second_wire = 1000;
  struct OnAir {
    Time arrives;
    Transmission what;
    TransmissionNumber number;
  };
  [[nodiscard]] bool comes_back(const std::array<bool, most_paths>& paths) const {
    return (paths[0] && !dead_paths[0]) || (paths[1] && !dead_paths[1]);
  }
  static LinkAcknowledgement by_stream(LinkAcknowledgement acknowledgement) {
    for (StreamAcknowledgement& one : acknowledgement.streams) one.stream %= second_wire;
    return acknowledgement;
  }
  void send() {
    while (const auto one = sender.next(now)) {
      sent.push_back(*one);
      const TransmissionNumber number = ++numbers_[{one->stream, one->path}];
      sender.on_written(*one, number);
      const std::size_t packets = wire_cost(one->sample.bytes, one->piece).packets;
      const bool is_bulk = packets > 1 || !one->piece.is_whole();
      drained_ = std::max(drained_, now) + (is_bulk ? static_cast<int>(packets) * ms : 0 * ms);
      if (dead || dead_paths[one->path] || loses(*one)) continue;
      air_[one->path].push_back({drained_ + delays[one->path], *one, number});
    }
    if (sender.deadline(now) <= now) ADD_FAILURE() << "wants to be called without end";
  }
  void arrive() {
    for (auto& air : air_) arrive(air);
  }
  void arrive(std::deque<OnAir>& air) {
    while (!air.empty() && air.front().arrives <= now) {
      const auto& [arrives, one, number] = air.front();
      const StreamId wire = one.stream + (one.path == 0 ? 0 : second_wire);
      const Arrived arrived{wire, number, one.sample.origin, one.piece, nullptr};
      if (receiver.on_piece("vehicle", arrived, now + clock_difference)) {
        give(arrived);
      }
      air.pop_front();
    }
  }
  void give(const Arrived& arrived) {
    const Disposition disposition = receiver.on_arrived("vehicle", arrived, now + clock_difference);
    if (disposition != Disposition::deliver) return;
    delivered[arrived.stream % second_wire].push_back(arrived.origin.sequence);
  }
  std::map<std::pair<StreamId, PathIndex>, TransmissionNumber> numbers_;
  std::array<std::deque<OnAir>, most_paths> air_;
  Time drained_{};
};

inline constexpr std::size_t picture_bytes = 40000;

/// So that the capacity is known: pictures for 3 s, and something small.
inline void learn_capacity(LinkPair& link, StreamId camera) {
  std::uint64_t sequence = 1;
  link.add(90, rule_of(TrafficClass::normal));
  link.offer(90, 1);
  link.run(100 * ms);
  for (int i = 0; i < 20; ++i) {
    link.offer(camera, sequence++, picture_bytes);
    link.run(150 * ms);
  }
}

}  // namespace tocsin::router
