// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "fast_dds/graph_writer.hpp"
#include "foundation/error.hpp"
#include "graph/ros_graph.hpp"
#include "link/demand.hpp"
#include "link/expected_peers.hpp"
#include "link/fast_dds_host_services.hpp"
#include "link/flow_ends.hpp"
#include "link/flow_readers.hpp"
#include "link/flow_table.hpp"
#include "link/late_interface.hpp"
#include "link/outside_readers.hpp"
#include "rtps/writer_numbers.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/sample_codec.hpp"
#include "transport/radio_marks.hpp"
#include "transport/stop_channel.hpp"

namespace tocsin {

/// The two participants of a host's router: one on the host's domain, an ordinary peer of all that
/// is there, and the only one on the link. The one on the link is made when its interface is up.
class FastDdsLinkBus final : public LinkBus {
 public:
  /// Throws EnvironmentError when a participant cannot be created, ConfigError for an identity that
  /// nobody would accept.
  FastDdsLinkBus(const BusOptions& options, std::function<void()> on_event);

  [[nodiscard]] std::optional<LinkEvent> take() override;
  [[nodiscard]] PeerId self() const override {
    return link_ ? FlowTable::peer_of(link_->prefix()) : 0;
  }
  void want(FlowId host_flow, bool wanted) override;
  FlowId open(const Flow& flow, TrafficClass traffic_class) override;
  [[nodiscard]] std::string host() const override { return options_.host; }
  [[nodiscard]] std::vector<std::string> sites() const override { return options_.sites; }
  void set_absent(const std::set<std::string>& hosts) override;
  [[nodiscard]] PathIndex paths() const override { return options_.second_address.empty() ? 1 : 2; }
  [[nodiscard]] std::uint32_t wire_id(FlowId flow, PathIndex path) const override;
  void close(FlowId flow) override;
  [[nodiscard]] std::optional<std::uint64_t> send(FlowId flow, const CarriedSample& sample,
                                                  SamplePiece piece, PathIndex path) override;
  [[nodiscard]] std::size_t largest_piece() const override;
  [[nodiscard]] CarriedSample join(
      const CarriedSample& last,
      const std::vector<std::shared_ptr<const void>>& pieces) const override;
  [[nodiscard]] std::optional<CarriedSample> compress(const CarriedSample& sample,
                                                      const CarriedSample* base) override;
  [[nodiscard]] std::optional<CarriedSample> restore(const CarriedSample& compressed,
                                                     const CarriedSample* base) override;
  void offer(FlowId peer_flow) override;
  FlowId offer(const Flow& flow) override;
  void deliver(FlowId flow, const CarriedSample& sample) override;
  [[nodiscard]] std::vector<std::uint8_t> bytes_of(const CarriedSample& sample) const override;
  [[nodiscard]] CarriedSample sample_of(std::vector<std::uint8_t> bytes) const override;
  [[nodiscard]] CarriedSample pack(const TypeInfo& type,
                                   std::shared_ptr<const void> message) const override;
  [[nodiscard]] std::shared_ptr<const void> unpack(const TypeInfo& type,
                                                   const CarriedSample& sample) const override;
  [[nodiscard]] HostServices* services() override {
    return rules_.call_classes().empty() ? nullptr : &services_;
  }
  void say_stop(const StopValue& value) override;
  [[nodiscard]] StopNews take_stop_news() override;
  [[nodiscard]] const TrafficRules& rules() const override { return rules_; }
  [[nodiscard]] LinkPackets packets() const override { return marks_->packets(); }

 private:
  struct Sending {
    Flow flow;
    LinkPurpose purpose = LinkPurpose::samples;
    TrafficClass traffic_class;
    /// By path; null while the link is not up, and where there is no such path.
    std::array<std::unique_ptr<FlowWriter>, most_paths> writers;
  };
  void offer(FlowId id, const Flow& flow);
  [[nodiscard]] std::vector<std::string> link_addresses() const;
  [[nodiscard]] ParticipantOptions host_options();
  [[nodiscard]] ParticipantOptions link_options();
  void join_link();
  void on_link_participant(const RemoteEnds::Participant& participant, const std::string& name,
                           bool there);
  /// The name of a peer that calls itself the router of `host`; empty for one that has left.
  [[nodiscard]] std::string peer_name(const RemoteEnds::Participant& participant,
                                      const std::string& host) const;
  /// Without a writer, and with a line in the log, when Fast DDS refuses.
  void connect(FlowId id, Sending& sending);
  void log_refusal(const char* what, const std::string& topic, const EnvironmentError& error);
  [[nodiscard]] std::unique_ptr<FlowReader> make_host_reader(const ReaderKey& key);
  void listen_on_host(FlowId id, const Flow& flow);
  /// `anew`: by another reader than before.
  void listen_on_link(FlowId id, const Flow& flow, bool anew = false);
  /// Begins and ends to receive what crosses on demand.
  void follow_demand();
  /// Makes readers anew that are muted by a forged number.
  void hear_the_muted();
  [[nodiscard]] bool has_outlived_its_lifespan(const TakenSample& taken, FlowId id) const;
  void on_host_sample(const ReaderKey& key, TakenSample&& taken);
  void on_link_sample(TakenSample&& taken);

  const BusOptions options_;
  Logger log_{"link"};
  const TrafficRules rules_;
  ExpectedPeers expected_;
  OutsideReaders outside_readers_;
  FlowTable table_;
  ServiceTable service_table_;
  Demand demand_;
  SampleCodec codec_;
  const std::shared_ptr<RadioMarks> marks_ = std::make_shared<RadioMarks>();
  const std::shared_ptr<StopChannel> stop_;
  std::atomic<bool> interface_is_up_{false};
  const std::shared_ptr<WriterNumbers> numbers_;  ///< on the link
  LocalNodes nodes_;                              ///< of the host
  FastDdsParticipant host_;
  std::unique_ptr<FastDdsParticipant> link_;
  GraphWriter graph_;
  FastDdsHostServices services_;
  FlowReaders host_readers_;  // after the participants: destroyed first
  FlowReaders link_readers_;
  std::set<FlowId> wanted_;  ///< of the host, on demand
  std::map<FlowId, Sending> sending_;
  std::map<FlowId, std::unique_ptr<FlowWriter>> giving_;
  std::unique_ptr<LateInterface> late_;  // last: destroyed first, as it calls back
};

}  // namespace tocsin
