// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "link_router/compressed_samples.hpp"
#include "link_service.hpp"
#include "transform_merger.hpp"

namespace tocsin {

/// Tells the services what happens at the link, and keeps the tables of peers and flows: a flow of
/// the host goes to all, a flow of a peer to the service that takes it. Puts samples together that
/// come in pieces, and restores those that come compressed.
class LinkEvents {
 public:
  using Services = std::vector<std::unique_ptr<LinkService>>;
  /// All outlive it.
  LinkEvents(LinkBus& link, router::LinkReceiver& receiver, const Services& services)
      : link_(link), receiver_(receiver), services_(services) {}
  /// All that has happened since the last call, and what has been held back and is due.
  void take(Instant at);
  /// When to call take() though nothing happens.
  [[nodiscard]] Time deadline() const;

  [[nodiscard]] const LinkPeers& peers() const { return peers_; }
  [[nodiscard]] const std::map<FlowId, LocalFlow>& local() const { return local_; }
  [[nodiscard]] const std::map<FlowId, RemoteFlow>& remote() const { return remote_; }

 private:
  template <class Call>
  void each(const Call& call);
  void limit(const LocalFlow& flow, const TrafficRule& rule, Instant at);
  /// A sample of a flow that is merged waits.
  void merge(FlowId flow, const CarriedSample& sample);
  void send_merged(Instant at);
  void on(const link_event::HostFlow& event, Instant at);
  void on(const link_event::HostFlowGone& event, Instant at);
  void on(const link_event::HostSample& event, Instant at);
  void on(const link_event::HostReaderMatched& event, Instant at);
  void on(const link_event::PeerFound& event, Instant at);
  void on(const link_event::PeerLost& event, Instant at);
  void on(const link_event::PeerFlow& event, Instant at);
  void on(const link_event::PeerFlowGone& event, Instant at);
  void on(const link_event::PeerReaderMatched& event, Instant at);
  void on(const link_event::PeerReaderGone& event, Instant at);
  void on(const link_event::LinkSample& sample, Instant at);
  /// Flows of the second path belong to those of the first that they are equal to.
  void join_paths();
  void part_from(FlowId first);
  /// Whether it was one of the second path.
  bool forget_second(FlowId flow);
  void give(const RemoteFlow& flow, link_event::LinkSample event, Instant at);
  /// Nothing when its base is not here, or is another.
  [[nodiscard]] std::optional<CarriedSample> restored(FlowId flow, const CarriedSample& sample);

  LinkBus& link_;
  router::LinkReceiver& receiver_;
  const Services& services_;
  LinkPeers peers_;
  router::CompressedSamples compressed_;
  std::map<FlowId, LocalFlow> local_;
  std::map<FlowId, RemoteFlow> remote_;
  /// A peer's flow on the second path.
  struct SecondFlow {
    link_event::PeerFlow event;
    std::optional<FlowId> first;  ///< the flow that it belongs to, once that is known
  };
  std::map<FlowId, SecondFlow> second_;
  std::map<FlowId, WriterLimits> limits_;  ///< of flows of the host with `max_rate_hz`
  /// The transforms of a flow with `max_rate_hz`, as one source.
  struct Merging {
    TransformMerger merger;
    std::uint64_t source;
    std::uint64_t sequence = 0;
  };
  std::map<FlowId, Merging> merging_;
};

}  // namespace tocsin
