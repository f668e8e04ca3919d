// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "backfill/router_store.hpp"
#include "foundation/instant.hpp"
#include "link_router/backfill_sender.hpp"
#include "link_router/history_requests.hpp"
#include "link_tables.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// Topic, type and user data of stored and logged streams of this host, by the stream's key.
using StreamFlows = std::map<std::uint64_t, Flow>;

/// What this host logs, and what of it is wanted: by somebody, or by a rule of the configuration.
class LogHistory {
 public:
  using SampleId = sample_log::SampleId;
  /// All outlive it.
  struct Parts {
    LinkBus& link;
    RouterStore& store;
    router::BackfillSender& sender;
    StreamFlows& flows;
    Logger& log;
  };
  explicit LogHistory(const Parts& parts) : parts_(parts) {}

  /// Whether the traffic file logs anything of this host.
  [[nodiscard]] bool logs_any() const;
  /// Topics of which something was or may be logged.
  [[nodiscard]] std::set<std::string> topics() const;
  /// A logged flow.
  void add(const LocalFlow& flow);
  void remove(const LocalFlow& flow);
  /// Keeps it when it is of a logged flow.
  void log(const LocalFlow& flow, const CarriedSample& sample, Instant at);
  /// The stream of a logged flow that crosses live, too.
  [[nodiscard]] std::optional<std::uint64_t> live_key(FlowId on_link) const;
  [[nodiscard]] bool has(std::uint64_t stream) const { return streams_.count(stream) != 0; }
  /// Those of logged streams, and the others.
  [[nodiscard]] std::pair<std::vector<SampleId>, std::vector<SampleId>> split(
      const std::vector<SampleId>& ids) const;
  /// These are at the peer.
  void confirm(std::vector<SampleId> ids);
  void read(std::vector<SampleId> ids) { parts_.store.read(std::move(ids)); }

  /// Stands for half a minute, unless it is repeated.
  void request(const router::HistoryRange& range, Time now);
  /// Of a rule: stands until all of it was delivered, or for a day after its end, over the
  /// instances of this router. False: too many stand.
  [[nodiscard]] bool request(const router::RuleRequest& request, Instant at);
  /// Whether the requests of rules of earlier instances are known; before, none is to be made.
  [[nodiscard]] bool knows_requests() const { return knows_requests_; }
  /// Rules of which an earlier instance has made a request whose end is in the future; once.
  [[nodiscard]] std::set<std::string> take_resumed_rules() { return std::exchange(resumed_, {}); }

  void follow(Instant at);
  void add_to(tocsin_msgs::msg::LinkState& message) const;

 private:
  [[nodiscard]] bool logs(const std::string& topic) const;
  void take_answers();
  void on_opened(store_answer::Opened& opened);
  void on_read(store_answer::Read& read);
  void on_retired(const store_answer::Retired& retired);
  void resume_requests(Instant at);

  const Parts parts_;
  std::map<FlowId, std::uint64_t> keys_;       ///< by flow on the host
  std::map<FlowId, std::uint64_t> live_keys_;  ///< of those that cross live, by flow on the link
  std::set<std::uint64_t> streams_;            ///< also those that earlier instances have logged
  router::HistoryRequests requests_;
  std::string earlier_requests_;  ///< until they are resumed
  bool knows_requests_ = false;
  std::set<std::string> resumed_;
  std::vector<sample_log::LoggedSpan> contents_;
};

}  // namespace tocsin
