// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "link_router/link_sender.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/thinning.hpp"

namespace tocsin {

/// One instance of a peer's router.
struct LinkPeer {
  std::string name;  ///< of its host
  PeerId instance = 0;
};

/// The instances of peers that are there. Of two of one name the newer is the present one.
class LinkPeers {
 public:
  void add(const LinkPeer& peer);
  void remove(PeerId instance);
  /// Null when it is not there.
  [[nodiscard]] const LinkPeer* find(PeerId instance) const;
  /// The present instance of a name; null when there is none.
  [[nodiscard]] const LinkPeer* find(const std::string& name) const;
  [[nodiscard]] bool is_present(const LinkPeer& peer) const;

 private:
  std::map<PeerId, LinkPeer> all_;
  std::map<std::string, PeerId> present_;
};

/// A flow of this host that the traffic file names.
struct LocalFlow {
  FlowId on_host = 0;
  Flow what;                      ///< as its writers offer it
  bool is_stored = false;         ///< what does not cross is backfilled
  bool is_logged = false;         ///< it has a history
  std::optional<FlowId> on_link;  ///< empty: it does not cross live
  router::StreamRule rule{};      ///< on the link
};

/// `max_rate_hz` of a flow: thins the samples of each writer.
class WriterLimits {
 public:
  explicit WriterLimits(Duration interval) : interval_(interval) {}
  [[nodiscard]] bool pass(std::uint64_t writer, Time now) {
    return limits_.try_emplace(writer, interval_).first->second.pass(now);
  }

 private:
  Duration interval_;
  std::map<std::uint64_t, RateLimit> limits_;
};

class LinkService;
/// A flow of a peer.
struct RemoteFlow {
  FlowId id = 0;
  PeerId peer = 0;
  std::array<std::uint32_t, most_paths> wire_ids{};  ///< of its writer on each path
  Flow what;
  router::StreamRule rule;
  LinkService* service = nullptr;  ///< that takes it
};

/// [B] What was sent of a stream, serialised.
struct SentBytes {
  std::uint64_t bytes = 0;  ///< as it was sent
  std::uint64_t plain = 0;  ///< had nothing been compressed
};

struct StreamPath {
  router::StreamId stream = 0;
  PathIndex path = 0;
};

/// The streams of this router's sender, by their flow on the link.
class LinkStreams {
 public:
  /// Both outlive it.
  LinkStreams(LinkBus& link, router::LinkSender& sender);
  void add(FlowId flow, const router::StreamRule& rule);
  /// The one that backfills go by.
  void add_backfill(FlowId flow);
  void remove(FlowId flow);
  [[nodiscard]] bool has(FlowId flow) const { return sent_bytes_.count(flow) != 0; }
  /// The stream of a wire id, and its path; empty when there is none.
  [[nodiscard]] std::optional<StreamPath> find(std::uint32_t wire_id) const;
  /// Sends what is due.
  void send(Time now);
  [[nodiscard]] SentBytes sent_bytes(FlowId flow) const { return sent_bytes_.at(flow); }

 private:
  LinkBus& link_;
  router::LinkSender& sender_;
  std::map<FlowId, SentBytes> sent_bytes_;
};

}  // namespace tocsin
