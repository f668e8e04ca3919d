// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "link_router/link_sender.hpp"
#include "link_router/pending_calls.hpp"
#include "link_router/service_directory.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "tocsin_idl/link_calls.hpp"

namespace tocsin {

/// Calls of services between this host and those of the peers: between the host's clients and
/// servers, the decisions (router::ServiceDirectory, router::PendingCalls) and the link.
class CallLink {
 public:
  /// All outlive it.
  struct Parts {
    LinkBus& link;
    router::LinkSender& sender;
    Logger& log;
    std::function<std::int64_t(Time)> wall_ns;  ///< [ns] since the Unix epoch
  };
  explicit CallLink(Parts parts);

  /// Its flows on the link, which are streams of the sender; none where no calls cross.
  [[nodiscard]] const std::map<FlowId, router::StreamRule>& flows() const { return flows_; }

  /// Whether a topic of the link carries calls.
  [[nodiscard]] static bool carries(const std::string& topic);

  /// What has happened on the host, and what follows from that and from what the peers have said.
  void follow(Time now);
  /// A life of a peer has sent which services its host has and wants. `name`: of its host.
  void on_services(PeerId peer, const std::string& name, const CarriedSample& sample);
  /// A peer has sent a request or a reply.
  void on_call(const std::string& name, const CarriedSample& sample, Time now);
  void on_lost(PeerId peer) { directory_.forget_peer(peer); }
  [[nodiscard]] Time deadline(Time now) const;

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
    std::uint64_t life = 0;
    std::uint64_t number = 0;
  };
  struct Request {
    Caller caller;
    Bytes message;
  };

  void on(const host_service_event::Server& event, Time now);
  void on(const host_service_event::Client& event, Time now);
  void on(const host_service_event::Request& event, Time now);
  void on(const host_service_event::Reply& event, Time now);
  void on(const host_service_event::Changed& event, Time now);
  FlowId open(const Flow& flow, TrafficClass traffic_class);
  void open_calls(const CallClass& calls);
  void follow_directory(Time now);
  void take_request(const CallMessage& message, const CallRule& rule, Time now);
  void ask_waiting(Time now);
  void give_up(Time now);
  void offer(FlowId flow, CarriedSample sample, Time now);
  void offer(const CallRule& rule, CallMessage message, Time now);

  Parts parts_;
  HostServices* const host_;  ///< null where no calls cross
  router::ServiceDirectory directory_;
  std::map<FlowId, router::StreamRule> flows_;
  std::map<FlowId, std::uint64_t> sequences_;
  std::map<ClassKey, CallFlows> by_class_;
  FlowId services_ = 0;
  router::ServiceLists told_;
  std::set<std::string> known_;  ///< of the peers' services, by this host
  std::set<router::ServiceName> shown_;
  std::set<router::ServiceName> asked_;
  bool makes_ends_ = false;  ///< some are left for the next ticks

  std::uint64_t last_call_ = 0;
  router::PendingCalls<std::uint64_t, CallId> own_;  ///< of this host's clients, by number
  std::uint64_t last_request_ = 0;
  router::PendingCalls<std::uint64_t, Request> waiting_;  ///< for a server of this host
  using Asked = std::pair<std::string, std::int64_t>;     ///< service and number on the host
  router::PendingCalls<Asked, Caller> served_;            ///< by servers of this host, now
};

}  // namespace tocsin
