// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "backfill/log_history.hpp"
#include "backfill/router_store.hpp"
#include "link_router/backfill_sender.hpp"
#include "link_router/link_sender.hpp"
#include "link_tables.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// What of this host's stored and logged topics goes to a peer in batches: between the stores, the
/// decision (router::BackfillSender) and the link. Batches go to one peer, the first that reads
/// them.
class BackfillOutgoing {
 public:
  /// All outlive it.
  struct Parts {
    LinkBus& link;
    LinkStreams& streams;
    router::LinkSender& link_sender;
    RouterStore& store;
    router::BackfillSender& sender;
    LogHistory& history;
    StreamFlows& flows;
    Logger& log;
  };
  explicit BackfillOutgoing(const Parts& parts);

  /// The link's flow of batches; empty when the traffic file stores and logs nothing of this host.
  [[nodiscard]] std::optional<FlowId> flow() const { return flow_; }
  /// A stored flow that crosses live.
  void add(const LocalFlow& flow);
  /// After its stream was removed from the link's sender.
  void remove(const LocalFlow& flow);
  void offer(const LocalFlow& flow, const CarriedSample& sample, Instant at);

  /// What earlier instances left.
  void on_opened(const store_answer::Opened& opened);
  /// A peer reads batches, or has gone.
  void on_reader(const LinkPeer& peer, Time now);
  void on_peer_gone(const LinkPeer& peer);
  /// Whether batches go to it: its wishes count.
  [[nodiscard]] bool is_for(const LinkPeer& peer) const {
    return session_ && session_->instance == peer.instance;
  }
  void on_progress(const router::BackfillProgress& progress, Time now) {
    confirm(parts_.sender.on_progress(progress, now));
  }
  /// What the link's sender knows of stored samples.
  void follow_fates();
  /// Asks the stores for what is sent next.
  void read_ahead();
  /// What there is room for.
  void send(Time now);
  [[nodiscard]] Time deadline(Time now) const;
  void add_to(tocsin_msgs::msg::LinkState& message) const;

 private:
  void begin_session();
  /// These are at the peer.
  void confirm(const std::vector<sample_log::SampleId>& ids);
  [[nodiscard]] CarriedSample packed(const router::BackfillBatch& batch);

  const Parts parts_;
  const std::optional<FlowId> flow_;
  std::map<FlowId, std::uint64_t> keys_;  ///< of stored streams, by flow on the link
  std::map<PeerId, LinkPeer> readers_;
  std::optional<LinkPeer> session_;
};

}  // namespace tocsin
