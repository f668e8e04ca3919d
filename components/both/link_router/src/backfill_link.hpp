// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "arrival_log.hpp"
#include "link_router/backfill_receiver.hpp"
#include "link_router/backfill_sender.hpp"
#include "link_router/history_requests.hpp"
#include "link_router/link_sender.hpp"
#include "link_router/reader_wait.hpp"
#include "router_store.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// A peer of now: its name and its life.
struct BackfillPeer {
  std::string name;
  PeerId life = 0;
};

/// What of stored topics does not cross at first: between the log, the decisions
/// (router::BackfillSender, router::BackfillReceiver) and the link. Batches go to one peer, the
/// first that takes them.
class BackfillLink {
 public:
  /// All outlive it.
  struct Parts {
    LinkBus& link;
    router::LinkSender& sender;
    RouterStore& store;
    RouterStore& history;  ///< of what crosses when it is asked for
    ArrivalLog& arrivals;
    Logger& log;
  };
  BackfillLink(const Parts& parts, const router::LinkRouterParams& params);

  /// The link's flow of batches; empty when the traffic file stores and logs nothing of this host.
  [[nodiscard]] std::optional<FlowId> flow() const { return flow_; }

  /// A stored flow of this host, by its number on the link.
  void add(FlowId on_link, const Flow& flow, const router::StreamRule& rule);
  /// After its stream was removed from the sender.
  void remove(FlowId on_link);
  void offer(FlowId on_link, const CarriedSample& sample, Time now, std::int64_t wall_ns);
  /// A logged flow of this host, by its number there, and on the link where it crosses live, too.
  void add_logged(FlowId on_host, std::optional<FlowId> on_link, const Flow& flow);
  void remove_logged(FlowId on_host) { logged_.erase(on_host); }
  /// Keeps it when it is of a logged flow.
  void log(FlowId on_host, const CarriedSample& sample, Time now, std::int64_t wall_ns);
  /// A wish for what this host has logged; it stands for half a minute, unless it is said again.
  void request(const router::HistoryRange& range, Time now);
  /// The peer that batches go to, whose wishes count.
  [[nodiscard]] bool fills(PeerId peer) const { return session_ && session_->life == peer; }
  /// Whether the requests of rules of earlier lives are known; before, none is to be made.
  [[nodiscard]] bool knows_requests() const { return knows_requests_; }
  /// Rules of which an earlier life has made a request whose end is still to come; once.
  [[nodiscard]] std::set<std::string> take_resumed_rules() { return std::exchange(resumed_, {}); }
  /// A wish of the configuration's, which stands until all of it has crossed, or for a day after
  /// its end, over the lives of this router. `wall_ns` of `now`. False: too many stand.
  [[nodiscard]] bool request(const router::RuleRequest& request, Time now, std::int64_t wall_ns);
  /// Whether the traffic file logs anything of this host.
  [[nodiscard]] bool logs() const;
  [[nodiscard]] bool logs(const std::string& topic) const;
  /// Those of which something was or may be logged.
  [[nodiscard]] std::set<std::string> logged_topics() const;

  /// A peer takes batches, or has gone.
  void on_listener(const BackfillPeer& peer, Time now);
  void on_lost(PeerId life);
  /// What the stores have answered, what the sender knows of stored samples, what is to be read.
  /// `wall_ns` of `now`.
  void follow(Time now, std::int64_t wall_ns);
  /// What there is room for.
  void send(Time now);
  void on_progress(PeerId from, const router::BackfillProgress& progress, Time now);
  [[nodiscard]] Time deadline(Time now) const;
  /// Adds what is stored, what is logged, and the requests for it.
  void report(tocsin_msgs::msg::LinkState& message) const;

  /// A sample of a stored flow that crossed live. Whether the host was not given it yet.
  [[nodiscard]] bool on_live(const std::string& peer, const router::StreamRule& rule,
                             const CarriedSample& sample);
  void on_batch(const BackfillPeer& peer, const CarriedSample& sample, Time now);
  /// A reader of this host hears what is given there.
  void on_host_listens(FlowId on_host, Time now);
  /// What this life of a peer may be told: it was given, and that is safe.
  [[nodiscard]] router::BackfillProgress progress(const BackfillPeer& peer) const;
  /// Peers whose progress has changed since the last call.
  [[nodiscard]] std::set<std::string> take_progressed();

 private:
  struct Described {
    Flow what;                                  ///< topic, type and user data
    std::optional<FlowId> on_host;              ///< where its filled-in samples are given
    std::optional<router::ReaderWait> readers;  ///< with on_host
  };
  struct Arrived {
    BackfillPeer peer;
    std::shared_ptr<const tocsin_msgs::msg::Backfill> message;
  };
  struct Batched {
    BackfillPeer peer;
    router::BackfillProgress progress;
  };
  void on(store_answer::Opened& answer);
  void on(store_answer::Appended& answer);
  void on(store_answer::Read& answer);
  void on(store_answer::Retired& answer);
  void on(store_answer::Saved& answer);
  void on(store_answer::Problem& answer);
  void follow_fates();
  void follow_history(Time now, std::int64_t wall_ns);
  void resume_requests(Time now, std::int64_t wall_ns);
  void on_history(store_answer::Opened& answer);
  void on_history(store_answer::Read& answer);
  void on_history(store_answer::Retired& answer);
  void on_history(store_answer::Found& answer);
  void on_history(store_answer::Contents& answer) { contents_ = std::move(answer.spans); }
  void on_history(store_answer::Problem& answer) { on(answer); }
  void on_history(store_answer::Appended&) {}  // what is refused is told as a problem
  void on_history(store_answer::Saved&) {}
  void on(store_answer::Found&) {}
  void on(store_answer::Contents&) {}
  /// Of a stream that is in the history.
  [[nodiscard]] bool is_logged(const sample_log::SampleId& id) const {
    return logged_streams_.count(id.stream) != 0;
  }
  /// Tells the log and the requests which of these are on the other side.
  void confirm(const std::vector<sample_log::SampleId>& ids);
  void add_fetches(tocsin_msgs::msg::LinkState& message) const;
  void begin_session();
  [[nodiscard]] CarriedSample packed(const router::BackfillBatch& batch);
  [[nodiscard]] static std::uint64_t key_of(const Arrived& batch);
  void take(const Arrived& batch, Time now);
  void take_early(Time now);
  void give(const router::BackfillBatch& batch, Time now);

  Parts parts_;
  const std::optional<FlowId> flow_;
  router::BackfillSender sender_;
  std::map<FlowId, std::uint64_t> keys_;     ///< streams of this host, by flow on the link
  std::map<std::uint64_t, Described> sent_;  ///< by the stream's key
  std::map<PeerId, BackfillPeer> listeners_;
  std::optional<BackfillPeer> session_;
  std::uint64_t batches_ = 0;

  std::map<FlowId, std::uint64_t> logged_;       ///< streams by flow on the host
  std::map<FlowId, std::uint64_t> logged_live_;  ///< those that cross live, by flow on the link
  std::set<std::uint64_t> logged_streams_;       ///< also those that earlier lives have logged
  router::HistoryRequests requests_;
  std::string earlier_requests_;  ///< until they are resumed
  bool knows_requests_ = false;
  std::set<std::string> resumed_;
  std::vector<sample_log::LoggedSpan> contents_;

  router::BackfillReceiver receiver_;
  std::map<std::uint64_t, Described> given_;  ///< by the key of the peer's stream
  std::vector<Arrived> early_;                ///< came before the readers of this host were there
  std::vector<sample_log::SampleId> live_;    ///< given, and not noted yet
  std::map<std::uint64_t, Batched> saving_;   ///< by token
  std::uint64_t last_token_ = 0;
  std::map<std::string, Batched> saved_;  ///< by the peer's name
  std::set<std::string> progressed_;
};

}  // namespace tocsin
