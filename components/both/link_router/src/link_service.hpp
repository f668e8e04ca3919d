// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "foundation/instant.hpp"
#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"
#include "link_tables.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// Acknowledgements between routers; on the link only.
using AcknowledgementMessage = tocsin_msgs::msg::LinkAcknowledgement;

/// What the services of a router share. All outlive them.
struct LinkParts {
  LinkBus& link;
  router::LinkSender& sender;
  router::LinkReceiver& receiver;
  LinkStreams& streams;
  const LinkPeers& peers;
  const std::map<FlowId, LocalFlow>& local;    ///< by the flow on the host
  const std::map<FlowId, RemoteFlow>& remote;  ///< by the peer's flow
  Logger& log;

  /// The peer's transmissions on a flow are acknowledged from now on, or not any more.
  void expect(const RemoteFlow& flow) const;
  void forget(const RemoteFlow& flow) const;
  /// One has come: what is to be done with it, and the peer is informed.
  router::Disposition on_arrived(const RemoteFlow& flow, const link_event::LinkSample& event,
                                 Time now) const;
};

/// One thing that a router does on the link. The component calls all of them in one order, on its
/// thread; when a flow of the host is gone, after their last `send`.
class LinkService {
 public:
  LinkService() = default;
  virtual ~LinkService() = default;
  LinkService(const LinkService&) = delete;
  LinkService& operator=(const LinkService&) = delete;

  /// A tick begins: inputs of the component itself, before what has happened at the link.
  virtual void begin(Instant) {}

  virtual void on_peer(const LinkPeer&, Instant) {}
  /// Still in LinkParts::peers.
  virtual void on_peer_gone(const LinkPeer&, Instant) {}

  /// A flow of this host that the traffic file names.
  virtual void on_local_flow(const LocalFlow&, Instant) {}
  virtual void on_local_flow_gone(const LocalFlow&, Instant) {}
  /// `is_live`: the flow has a stream, and its rate lets this sample cross.
  virtual void on_local(const LocalFlow&, const CarriedSample&, bool /*is_live*/, Instant) {}
  /// A reader of this host receives a flow of LinkBus::offer.
  virtual void on_local_reader(FlowId, Time) {}

  /// Whether a peer's flow of this topic is for this service. The last one that says so gets it.
  [[nodiscard]] virtual bool takes(const std::string& /*topic*/) const { return false; }
  virtual void on_remote_flow(const RemoteFlow&, Instant) {}
  virtual void on_remote_flow_gone(const RemoteFlow&) {}
  virtual void on_remote(const RemoteFlow&, const link_event::LinkSample&, Instant) {}
  /// A peer reads a flow of LinkBus::open.
  virtual void on_remote_reader(const LinkPeer&, FlowId, Time) {}
  /// It does not any more; of topics on demand.
  virtual void on_remote_reader_gone(const LinkPeer&, FlowId, Time) {}

  /// What a peer adds to its acknowledgements, and what this router adds to those for a peer.
  virtual void on_acknowledgement(const LinkPeer&, const AcknowledgementMessage&, Time) {}
  virtual void add_to(AcknowledgementMessage&, const LinkPeer&, Time) {}

  /// What follows from all that; called before and after `send`.
  virtual void follow(Instant) {}
  /// What there is room for.
  virtual void send(Instant) {}
  /// What is due at the end of a tick.
  virtual void finish(Instant) {}
  /// Its part of the report on the link.
  virtual void add_to(tocsin_msgs::msg::LinkState&, Time) const {}
  /// When to tick though nothing happens.
  [[nodiscard]] virtual Time deadline(Time) const { return never; }
};

}  // namespace tocsin
