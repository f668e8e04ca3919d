// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "held_arrivals.hpp"
#include "link_router/gate_keeper.hpp"
#include "link_service.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

class BackfillLink;

/// Live samples, both ways: what the host writes goes to the sender and onto the link, what peers
/// send goes to the host once. While the transmission state of its role is passive, the sender is
/// paused; when that state falls silent (GateKeeper), it is not.
class LiveLink final : public LinkService {
 public:
  /// `role` of the host. All outlive it.
  LiveLink(Component& owner, const LinkParts& parts, Role role);
  /// Once, before anything happens at the link: it notes what is delivered, so that nothing is
  /// delivered twice.
  void set_backfill(BackfillLink& backfill) { backfill_ = &backfill; }

  void begin(Instant at) override;
  void on_peer(const LinkPeer& peer, Instant at) override;
  void on_peer_gone(const LinkPeer& peer, Instant at) override;
  void on_local_flow(const LocalFlow& flow, Instant at) override;
  void on_local_flow_gone(const LocalFlow& flow, Instant at) override;
  void on_local(const LocalFlow& flow, const CarriedSample& sample, bool is_live,
                Instant at) override;
  void on_local_reader(FlowId flow, Time now) override { held_.on_reader(flow, now); }
  /// Whatever no other service takes.
  [[nodiscard]] bool takes(const std::string&) const override { return true; }
  void on_remote_flow(const RemoteFlow& flow, Instant at) override;
  void on_remote_flow_gone(const RemoteFlow& flow) override;
  void on_remote(const RemoteFlow& flow, const link_event::LinkSample& event, Instant at) override;
  void on_remote_reader(const LinkPeer& peer, FlowId flow, Time now) override;
  void on_remote_reader_gone(const LinkPeer& peer, FlowId flow, Time now) override;
  void on_acknowledgement(const LinkPeer& peer, const AcknowledgementMessage& message,
                          Time now) override;
  void follow(Instant at) override;
  void send(Instant at) override { parts_.streams.send(at.now); }
  [[nodiscard]] Time deadline(Time now) const override;

 private:
  /// Takes from the host what is wanted of topics on demand.
  void follow_demand();
  void deliver(const RemoteFlow& flow, const link_event::LinkSample& event, Instant at);

  OptionalInput<topic::TransmissionState> state_;
  const LinkParts parts_;
  BackfillLink* backfill_ = nullptr;
  const Role role_;
  router::GateKeeper keeper_;
  HeldArrivals held_;
  bool open_ = true;
};

}  // namespace tocsin
