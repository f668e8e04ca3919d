// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"
#include "radio_channel/radio_channel.hpp"

namespace tocsin::router {

inline constexpr Time radio_start{std::chrono::hours(1)};

/// A vehicle that sends and a station that receives, over the model of a Wi-Fi radio with one
/// queue.
class RadioPair {
 public:
  RadioPair(const radio::ChannelParams& channel, const LinkRouterParams& params, std::uint64_t seed)
      : radio(channel, {}, seed, radio_start), sender(params) {
    sender.on_peer("station", 2, now);
    receiver.on_peer("vehicle", 1);
  }

  /// Offers a sample of `bytes` every `period`, first after `phase`.
  void add(StreamRule rule, std::size_t bytes, Duration period, Duration phase) {
    const auto stream = static_cast<StreamId>(streams_.size());
    rule.name = "topic" + std::to_string(stream);
    sender.add_stream(stream, rule);
    receiver.on_stream("vehicle", stream, rule);
    sender.set_wanted("station", stream, true, now);
    streams_.push_back({bytes, period, now + phase, 0, {}});
  }

  void run(Duration length) {
    for (const Time end = now + length; now < end;) {
      offer();
      while (const auto one = sender.next(now)) put(*one);
      while (const auto acknowledgement = receiver.take_acknowledgement(now))
        put(acknowledgement->acknowledgement);
      Time next = std::min({end, sender.deadline(now), receiver.deadline(), radio.next_event()});
      for (const Stream& stream : streams_) next = std::min(next, stream.next);
      ASSERT_GT(sender.deadline(now), now) << "called without end";
      now = next;
      radio.advance(now);
      while (const auto outcome = radio.take()) end_packet(*outcome);
    }
  }

  /// Share of a stream's samples that were not delivered within `limit`; those of the last second
  /// do not count.
  [[nodiscard]] double late_share(StreamId stream, Duration limit) const {
    double late = 0;
    double all = 0;
    for (const auto& [offered, delivered] : streams_[stream].samples) {
      if (offered > now - std::chrono::seconds(1)) continue;
      ++all;
      late += delivered == never || delivered - offered > limit ? 1 : 0;
    }
    return all > 0 ? late / all : 0;
  }
  /// The first arrival of a sample that was offered after `time`; `never` without one.
  [[nodiscard]] Time first_arrival(StreamId stream, Time time) const {
    Time first = never;
    for (const auto& [offered, delivered] : streams_[stream].samples) {
      if (offered >= time) first = std::min(first, delivered);
    }
    return first;
  }

  Time now = radio_start;
  radio::RadioChannel radio;
  LinkSender sender;
  LinkReceiver receiver;

 private:
  struct Stream {
    std::size_t bytes;
    Duration period;
    Time next;
    TransmissionNumber written = 0;
    std::vector<std::pair<Time, Time>> samples;  ///< when each was offered and delivered
  };
  struct Cargo {
    std::function<void(Time)> arrive;
    std::size_t missing;
  };

  void offer() {
    for (StreamId id = 0; id < streams_.size(); ++id) {
      Stream& stream = streams_[id];
      if (stream.next > now) continue;
      stream.next += stream.period;
      stream.samples.emplace_back(now, never);
      sender.offer(id, {{7, stream.samples.size(), now}, stream.bytes, nullptr}, now);
    }
  }
  void put(const Transmission& one) {
    const TransmissionNumber number = ++streams_[one.stream].written;
    sender.on_written(one, number);
    const WireCost cost = wire_cost(one.sample.bytes, one.piece);
    const Arrived arrived{one.stream, number, one.sample.origin, one.piece, nullptr};
    push(radio::Direction::uplink, cost, [this, arrived](Time at) {
      if (receiver.on_piece("vehicle", arrived, at)) give(arrived, at);
    });
  }
  void give(const Arrived& arrived, Time at) {
    if (receiver.on_arrived("vehicle", arrived, at) != Disposition::deliver) return;
    streams_[arrived.stream].samples[arrived.origin.sequence - 1].second = at;
  }
  void put(const LinkAcknowledgement& acknowledgement) {
    push(radio::Direction::downlink, wire_cost(28 + 18 * acknowledgement.streams.size()),
         [this, acknowledgement](Time at) {
           sender.on_acknowledgement("station", acknowledgement, at);
         });
  }
  void push(radio::Direction direction, const WireCost& cost, std::function<void(Time)> arrive) {
    const auto cargo = std::make_shared<Cargo>(Cargo{std::move(arrive), cost.packets});
    for (std::size_t i = 0; i < cost.packets; ++i) {
      const auto bytes = static_cast<int>(cost.bytes / cost.packets);
      under_way_[radio.push(direction, {bytes, false, radio::AccessCategory::best_effort}, now)] =
          cargo;
    }
  }
  void end_packet(const radio::Outcome& outcome) {
    const auto found = under_way_.find(outcome.id);
    const std::shared_ptr<Cargo> cargo = found->second;
    under_way_.erase(found);
    if (outcome.fate == radio::Fate::delivered && --cargo->missing == 0) cargo->arrive(outcome.at);
  }

  std::vector<Stream> streams_;
  std::map<radio::FrameId, std::shared_ptr<Cargo>> under_way_;
};

}  // namespace tocsin::router
