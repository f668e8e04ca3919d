// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"
#include "radio_channel/radio_channel.hpp"

namespace tocsin::bench {

/// A link without MAC that loses each packet by itself, both ways.
[[nodiscard]] radio::ChannelParams lossy_channel(double loss, double delay_s);

/// Of a stream that is repaired as its class is.
[[nodiscard]] router::StreamRule stream_rule(const char* name, TrafficClass traffic_class);

/// Two routers, side 0 of the vehicle and side 1 of the station, with the radio between them, or
/// two. The sides know each other as "peer".
class RouterRadio {
 public:
  /// A sample that the router of a side gives to its host.
  using Deliver = std::function<void(std::size_t side, router::StreamId stream,
                                     const router::Origin& origin, Time now)>;
  /// Whether the receiver of a sample can use what came of it; what it cannot is not acknowledged.
  using Usable = std::function<bool(const router::Transmission& one)>;
  struct Setup {
    router::LinkRouterParams params;
    DscpOfClass dscp;
    radio::RadioChannel* second = nullptr;  ///< of a second path; null: there is one
    std::size_t vehicle = 0;                ///< of the channel, on side 0
  };
  RouterRadio(radio::RadioChannel& channel, const Setup& setup, Time start);

  void add_stream(std::size_t side, router::StreamId stream, const router::StreamRule& rule,
                  Time now);
  /// Both sides are told how many share the air.
  void set_vehicles(unsigned vehicles) {
    for (const auto& sender : senders_) sender->set_vehicles(vehicles);
  }
  void set_usable(Usable usable) { usable_ = std::move(usable); }
  /// An echo request of the vehicle, which the station answers.
  void send_echo(Time now);
  /// Puts on the radio what the routers want to send.
  void serve(Time now);
  /// What arrives up to `now`.
  void advance(Time now, const Deliver& deliver);
  /// A packet of this vehicle has ended: where several share a channel, in place of advance().
  void end(PathIndex path, const radio::Outcome& outcome, const Deliver& deliver);
  [[nodiscard]] Time next_event(Time now) const;

  [[nodiscard]] router::LinkSender& sender(std::size_t side) { return *senders_[side]; }
  [[nodiscard]] double acknowledgements() const { return acknowledgements_; }
  /// [B] on the radio.
  [[nodiscard]] double acknowledgement_bytes() const { return acknowledgement_bytes_; }
  [[nodiscard]] double repairs() const { return repairs_; }
  /// [B] on the radio, with all headers from IP on.
  [[nodiscard]] std::size_t bytes_of(router::StreamId stream) const {
    const auto found = bytes_.find(stream);
    return found == bytes_.end() ? 0 : found->second;
  }
  /// That were sent of it.
  [[nodiscard]] std::size_t packets_of(router::StreamId stream) const {
    const auto found = packets_.find(stream);
    return found == packets_.end() ? 0 : found->second;
  }

 private:
  struct Echo {
    bool is_request;
  };
  /// What crosses the radio as one or more packets.
  struct Cargo {
    std::variant<router::Transmission, router::LinkAcknowledgement, Echo> what;
    std::size_t to = 0;  ///< side
    TrafficClass traffic_class = TrafficClass::critical;
    std::size_t missing = 0;  ///< packets
    router::TransmissionNumber number = 0;
    PathIndex path = 0;
  };
  [[nodiscard]] PathIndex paths() const { return static_cast<PathIndex>(channels_.size()); }
  void advance(PathIndex path, Time now, const Deliver& deliver);
  void send(Cargo cargo, const std::vector<std::size_t>& packets, Time now);
  void send(std::size_t side, const router::Transmission& one, Time now);
  void send(std::size_t side, const router::LinkAcknowledgement& acknowledgement, PathIndex path,
            Time now);
  void arrive(const Cargo& cargo, Time now, const Deliver& deliver);

  std::vector<radio::RadioChannel*> channels_;  ///< by path
  DscpOfClass dscp_;
  std::size_t vehicle_;
  std::array<std::unique_ptr<router::LinkSender>, 2> senders_;
  std::array<std::unique_ptr<router::LinkReceiver>, 2> receivers_;
  std::unordered_map<router::StreamId, TrafficClass> classes_;
  /// By the stream's number on its path.
  std::array<std::unordered_map<router::StreamId, router::TransmissionNumber>, 2> numbers_;
  std::array<std::unordered_map<radio::FrameId, std::shared_ptr<Cargo>>, most_paths> under_way_;
  std::unordered_map<router::StreamId, std::size_t> packets_;
  std::unordered_map<router::StreamId, std::size_t> bytes_;
  Usable usable_ = [](const router::Transmission&) { return true; };
  double acknowledgements_ = 0;
  double acknowledgement_bytes_ = 0;
  double repairs_ = 0;
};

}  // namespace tocsin::bench
