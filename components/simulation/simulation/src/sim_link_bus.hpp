// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "link_router/wire_cost.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/sample_codec.hpp"
#include "sim_host.hpp"

namespace tocsin::simulation {

/// What a router carries: the message itself, and who wrote it.
struct Freight {
  std::shared_ptr<const void> message;
  const TopicEnd* from = nullptr;  ///< null: a message between routers
  std::uint64_t written = 0;       ///< as in Written::sequence
  Time written_at{};
  const TypeInfo* type = nullptr;  ///< of the message
};

/// The way of a simulated host's router over the radio. Routers find each other 0.1 s after the
/// later one is made, and a new flow after as long.
///
/// A router that dies is not missed by its peers until its successor speaks: then what was known of
/// it is forgotten, as on the real link.
class SimLinkBus final : public LinkBus {
 public:
  SimLinkBus(Network& network, const SimProcess& process, SimHost& host,
             std::function<void()> on_event);
  ~SimLinkBus() override;

  [[nodiscard]] std::optional<LinkEvent> take() override;
  [[nodiscard]] PeerId self() const override { return life_; }
  [[nodiscard]] std::string host() const override { return host_.name(); }
  [[nodiscard]] std::vector<std::string> sites() const override { return host_.sites(); }
  void set_absent(const std::set<std::string>& hosts) override;
  void want(FlowId host_flow, bool wanted) override;
  FlowId open(const Flow& flow, TrafficClass traffic_class) override;
  [[nodiscard]] PathIndex paths() const override { return network_.second_link != nullptr ? 2 : 1; }
  [[nodiscard]] std::uint32_t wire_id(FlowId flow, PathIndex path) const override {
    return wire_of(flow, path);
  }
  void close(FlowId flow) override;
  [[nodiscard]] std::optional<std::uint64_t> send(FlowId flow, const CarriedSample& sample,
                                                  SamplePiece piece, PathIndex path) override;
  [[nodiscard]] std::size_t largest_piece() const override { return router::largest_piece; }
  /// A piece is the whole sample, which counts when all are there.
  [[nodiscard]] CarriedSample join(
      const CarriedSample& last,
      const std::vector<std::shared_ptr<const void>>& /*pieces*/) const override {
    return last;
  }
  /// What crosses is the message itself, in as many bytes as it would take.
  [[nodiscard]] std::optional<CarriedSample> compress(const CarriedSample& sample,
                                                      const CarriedSample* base) override;
  [[nodiscard]] std::optional<CarriedSample> restore(const CarriedSample& compressed,
                                                     const CarriedSample* base) override;
  void offer(FlowId peer_flow) override;
  FlowId offer(const Flow& flow) override;
  void deliver(FlowId flow, const CarriedSample& sample) override;
  /// A number in Network::logged, in as many bytes as the encoded message would have.
  [[nodiscard]] std::vector<std::uint8_t> bytes_of(const CarriedSample& sample) const override;
  [[nodiscard]] CarriedSample sample_of(std::vector<std::uint8_t> bytes) const override;
  [[nodiscard]] CarriedSample pack(const TypeInfo& type,
                                   std::shared_ptr<const void> message) const override;
  [[nodiscard]] std::shared_ptr<const void> unpack(const TypeInfo& type,
                                                   const CarriedSample& sample) const override;
  [[nodiscard]] const TrafficRules& rules() const override { return host_.rules(); }
  void say_stop(const StopValue& value) override;
  [[nodiscard]] StopNews take_stop_news() override { return std::exchange(stop_news_, {}); }
  [[nodiscard]] LinkPackets packets() const override { return packets_; }
  void on_gate(bool open) override;

  /// A component of this host has begun to write, or has written.
  void on_writer(const SimProcess::Topic& topic);
  void on_writer_gone(const SimProcess::Topic& topic);
  void on_written(const SimProcess::Topic& topic, const Sample& sample);
  /// A component of this host has begun or ended to read: what crosses on demand may follow.
  void on_readers(const std::string& topic);
  /// A transmission of a peer has come.
  void on_arrived(const Overheard& what);
  /// A packet of that life of a peer has come; null: nothing rode in it.
  void on_packet(PeerId peer, const std::shared_ptr<const StopValue>& rider);

 private:
  struct Sending {
    Flow flow;
    TrafficClass traffic_class = TrafficClass::low;
    LinkPurpose purpose = LinkPurpose::samples;
    std::array<std::uint64_t, most_paths> last{};
  };
  struct HostFlow {
    FlowId id;
    std::vector<const SimProcess::Topic*> writers;
  };
  [[nodiscard]] static std::vector<std::size_t> packets_of(const Sending& sending,
                                                           const CarriedSample& sample,
                                                           SamplePiece piece);
  /// What rides in a packet with room; null when nothing fresh was said.
  [[nodiscard]] std::shared_ptr<const StopValue> rider() const;
  /// By which peers know a flow on a path.
  [[nodiscard]] static FlowId wire_of(FlowId flow, PathIndex path) {
    constexpr FlowId second = 1U << 31U;
    return path == 0 ? flow : flow | second;
  }
  [[nodiscard]] RadioLink& radio(PathIndex path) const {
    return path == 0 ? network_.link : *network_.second_link;
  }
  void learn(SimLinkBus& peer, FlowId flow, PathIndex path);
  void unlearn(PeerId peer, FlowId wire);
  void note_bytes(PathIndex path, std::size_t bytes);
  /// Sends the stop's value alone, unless it rode in a packet since `period`.
  void send_stop(Duration period);
  void send_stop(PathIndex path, const std::shared_ptr<const StopValue>& stop);
  void repeat_stop();
  void send(const Sending& sending, const Overheard& what, const std::vector<std::size_t>& packets,
            PeerId to, PathIndex path);
  /// Whether it is on the other side of the radio.
  [[nodiscard]] bool is_peer(const SimLinkBus& other) const {
    return other.host_.direction() != host_.direction();
  }
  [[nodiscard]] bool is_absent(PeerId peer) const;
  /// A peer is absent no more.
  void find_again(SimLinkBus& peer);
  void push(LinkEvent event);
  void tell_observer(GateEvent event) const;
  void meet(SimLinkBus& peer);
  void learn(SimLinkBus& peer, FlowId flow);
  void learn_all(SimLinkBus& peer);
  /// Tells a peer that this host reads its flow, or, of a topic on demand, that it does not.
  void tell_reading(PeerId peer, FlowId flow, const std::string& topic);
  void announce();
  void forget(PeerId peer);
  [[nodiscard]] static Flow flow_of(const SimProcess::Topic& topic);

  Network& network_;
  const SimProcess& process_;
  SimHost& host_;
  const std::function<void()> on_event_;
  const PeerId life_;
  FlowId last_flow_ = 0;
  std::deque<LinkEvent> events_;
  std::map<FlowId, Sending> sending_;
  std::map<std::string, HostFlow> host_flows_;                 ///< by topic and user data
  std::map<const SimProcess::Topic*, FlowId> flow_by_writer_;  ///< of host_flows_, looked up only
  std::set<FlowId> idle_;                                   ///< of them, on demand and not wanted
  std::map<std::string, PeerId> peers_;                     ///< by the name of the host
  std::set<std::string> absent_;                            ///< of them
  std::map<std::pair<PeerId, FlowId>, FlowId> peer_flows_;  ///< by the peer's number
  std::set<std::pair<PeerId, FlowId>> read_;                ///< of them, what the peer was told
  std::map<FlowId, Flow> known_;  ///< flows of peers, and those of offer()
  LinkPackets packets_;
  SampleCodec codec_;
  std::shared_ptr<const StopValue> stop_;  ///< as it was said last
  Time stop_said_{};
  std::array<Time, most_paths> stop_sent_{};
  StopNews stop_news_;
  std::map<PeerId, std::uint64_t> stop_numbers_;  ///< last received
};

}  // namespace tocsin::simulation
