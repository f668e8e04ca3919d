// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "backfill/arrival_log.hpp"
#include "backfill/router_store.hpp"
#include "foundation/instant.hpp"
#include "link_router/backfill_receiver.hpp"
#include "link_router/link_receiver.hpp"
#include "link_router/reader_wait.hpp"
#include "link_tables.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// What peers backfill, and what of it the host is delivered: between the link, the decision
/// (router::BackfillReceiver) and the ledger of the store.
class BackfillIncoming {
 public:
  /// All outlive it.
  struct Parts {
    LinkBus& link;
    router::LinkReceiver& link_receiver;
    RouterStore& store;
    ArrivalLog& arrivals;
    Logger& log;
  };
  explicit BackfillIncoming(const Parts& parts) : parts_(parts) {}

  /// What earlier instances have delivered.
  void recover(const sample_log::SampleSet& delivered) { receiver_.recover(delivered); }
  /// A sample of a stored flow was received live. Whether it is the first time.
  [[nodiscard]] bool on_live(const LinkPeer& peer, const router::StreamRule& rule,
                             const CarriedSample& sample);
  void on_batch(const LinkPeer& peer, const CarriedSample& sample, Instant at);
  /// A reader of this host receives a flow that is offered there.
  void on_local_reader(FlowId flow, Time now);
  void on_peer_gone(const LinkPeer& peer);
  /// What was delivered up to this token is safe: the peer is informed.
  void on_saved(std::uint64_t token, Time now);
  void follow(Instant at);
  /// Up to where this instance of a peer may know that its batches were delivered.
  [[nodiscard]] router::BackfillProgress progress(const LinkPeer& peer) const;
  [[nodiscard]] Time deadline() const;

 private:
  /// Where the samples of a peer's stream go on this host.
  struct Stream {
    Flow what;  ///< topic, type and user data
    FlowId on_host = 0;
    router::ReaderWait readers;
  };
  struct Batch {
    LinkPeer peer;
    std::shared_ptr<const tocsin_msgs::msg::Backfill> message;
    std::uint64_t key = 0;  ///< of the peer's stream
  };
  struct Saving {
    LinkPeer peer;
    router::BackfillProgress progress;
  };
  [[nodiscard]] Stream& stream_of(const Batch& batch, Time now);
  void take(const Batch& batch, Instant at);
  void deliver(const router::BackfillBatch& batch, Instant at);

  const Parts parts_;
  router::BackfillReceiver receiver_;
  std::map<std::uint64_t, Stream> streams_;  ///< by the key of the peer's stream
  std::vector<Batch> early_;                ///< received before the readers of this host were there
  std::vector<sample_log::SampleId> live_;  ///< delivered, and not noted yet
  std::map<std::uint64_t, Saving> saving_;  ///< by token
  std::uint64_t last_token_ = 0;
  std::map<std::string, Saving> saved_;  ///< by the peer's name
};

}  // namespace tocsin
