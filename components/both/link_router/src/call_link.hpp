// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "link_router/pending_calls.hpp"
#include "link_router/service_directory.hpp"
#include "link_service.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "tocsin_idl/link_calls.hpp"

namespace tocsin {

/// Calls of services between this host and those of the peers: between the host's clients and
/// servers, the decisions (router::ServiceDirectory, router::PendingCalls) and the link. It opens
/// nothing where no calls cross.
class CallLink final : public LinkService {
 public:
  explicit CallLink(const LinkParts& parts);

  void on_peer_gone(const LinkPeer& peer, Instant) override {
    directory_.forget_peer(peer.instance);
  }
  [[nodiscard]] bool takes(const std::string& topic) const override;
  void on_remote_flow(const RemoteFlow& flow, Instant) override { parts_.expect(flow); }
  void on_remote_flow_gone(const RemoteFlow& flow) override { parts_.forget(flow); }
  void on_remote(const RemoteFlow& flow, const link_event::LinkSample& event, Instant at) override;
  /// What has happened on the host, and what follows from that and from what the peers have said.
  void follow(Instant at) override;
  [[nodiscard]] Time deadline(Time now) const override;

 private:
  using CallMessage = tocsin_msgs::msg::LinkCall;
  using Bytes = std::vector<std::uint8_t>;
  /// The flows of one CallClass.
  struct CallFlows {
    FlowId calls = 0;
    FlowId results = 0;
  };
  using ClassKey = std::pair<Role, TrafficClass>;
  /// Who asked from another host.
  struct Caller {
    std::uint64_t instance = 0;
    std::uint64_t number = 0;
  };
  struct Request {
    Caller caller;
    Bytes message;
  };

  void on(const host_service_event::Server& event, Instant at);
  void on(const host_service_event::Client& event, Instant at);
  void on(const host_service_event::Request& event, Instant at);
  void on(const host_service_event::Reply& event, Instant at);
  void on(const host_service_event::Changed&, Instant) {}
  /// A peer has sent which services its host has and wants, or a request or a reply.
  void on_services(const LinkPeer& peer, const CarriedSample& sample);
  void on_call(const LinkPeer& peer, const CarriedSample& sample, Time now);
  FlowId open(const Flow& flow, TrafficClass traffic_class);
  void open_calls(const CallClass& calls);
  void follow_directory(Instant at);
  void take_request(const CallMessage& message, const CallRule& rule, Time now);
  void ask_waiting(Time now);
  void give_up(Time now);
  void offer(FlowId flow, CarriedSample sample, Instant at);
  void offer(const CallRule& rule, CallMessage message, Instant at);

  const LinkParts parts_;
  HostServices* const host_;  ///< null where no calls cross
  router::ServiceDirectory directory_;
  std::map<FlowId, std::uint64_t> sequences_;
  std::map<ClassKey, CallFlows> by_class_;
  FlowId services_ = 0;
  router::ServiceLists announced_;
  bool is_announced_ = false;
  std::set<std::string> known_;  ///< of the peers' services, by this host
  std::set<router::ServiceName> shown_;
  std::set<router::ServiceName> asked_;
  bool makes_endpoints_ = false;  ///< some are left for the next ticks

  std::uint64_t last_call_ = 0;
  router::PendingCalls<std::uint64_t, CallId> own_;  ///< of this host's clients, by number
  std::uint64_t last_request_ = 0;
  router::PendingCalls<std::uint64_t, Request> waiting_;  ///< for a server of this host
  using Asked = std::pair<std::string, std::int64_t>;     ///< service and number on the host
  router::PendingCalls<Asked, Caller> served_;            ///< by servers of this host, now
};

}  // namespace tocsin
