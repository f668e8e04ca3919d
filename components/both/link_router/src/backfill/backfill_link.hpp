// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "backfill/arrival_log.hpp"
#include "backfill/backfill_incoming.hpp"
#include "backfill/backfill_outgoing.hpp"
#include "backfill/fetch_trigger.hpp"
#include "backfill/log_history.hpp"
#include "backfill/router_store.hpp"
#include "link_router/history_requests.hpp"
#include "link_service.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Stored, logged and kept topics: what of them crosses later than live, both ways.
class BackfillLink final : public LinkService {
 public:
  struct Params {
    StorePlace store;
    StorePlace history;
    router::LinkRouterParams link;
  };
  /// All outlive it.
  BackfillLink(Component& owner, const LinkParts& parts, const Computer& computer,
               const Params& params);

  void begin(Instant at) override;
  void on_peer_gone(const LinkPeer& peer, Instant at) override;
  void on_local_flow(const LocalFlow& flow, Instant at) override;
  void on_local_flow_gone(const LocalFlow& flow, Instant at) override;
  void on_local(const LocalFlow& flow, const CarriedSample& sample, bool is_live,
                Instant at) override;
  void on_local_reader(FlowId flow, Time now) override { incoming_.on_local_reader(flow, now); }
  [[nodiscard]] bool takes(const std::string& topic) const override;
  void on_remote_flow(const RemoteFlow& flow, Instant) override { parts_.expect(flow); }
  void on_remote_flow_gone(const RemoteFlow& flow) override { parts_.forget(flow); }
  void on_remote(const RemoteFlow& flow, const link_event::LinkSample& event, Instant at) override;
  void on_remote_reader(const LinkPeer& peer, FlowId flow, Time now) override;
  void on_acknowledgement(const LinkPeer& peer, const AcknowledgementMessage& message,
                          Time now) override;
  void add_to(AcknowledgementMessage& message, const LinkPeer& peer, Time now) override;
  void follow(Instant at) override;
  void send(Instant at) override { outgoing_.send(at.now); }
  void add_to(tocsin_msgs::msg::LinkState& message, Time now) const override;
  [[nodiscard]] Time deadline(Time now) const override;

  /// Samples of a peer's stored flow will follow.
  void expect(Instant at) { store_.open(at); }
  /// A sample of a stored flow was received live. Whether it is the first time.
  [[nodiscard]] bool on_live(const LinkPeer& peer, const RemoteFlow& flow,
                             const CarriedSample& sample);
  /// The host is delivered a sample of a peer's flow for the first time.
  void on_delivery(const Flow& what, const CarriedSample& sample, Instant at);

 private:
  void keep_stores(Instant at);
  void fetch_around(const FetchTrigger& trigger, Time event, Instant at);
  void take_answers(Instant at);

  OptionalInput<topic::LogRequest> requests_;
  Component& owner_;
  const LinkParts parts_;
  RouterStore store_;          ///< of stored topics
  RouterStore history_store_;  ///< of logged and kept ones
  ArrivalLog arrivals_;
  StreamFlows flows_;
  router::BackfillSender sender_;
  LogHistory history_;
  BackfillOutgoing outgoing_;
  BackfillIncoming incoming_;
  router::StandingRequests standing_;  ///< of this host, for logs of peers
  std::vector<std::unique_ptr<FetchTrigger>> triggers_;
  Time next_keep_{};
};

}  // namespace tocsin
