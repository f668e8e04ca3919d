// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "sample_log/sample_id.hpp"

namespace tocsin::router {

/// What somebody wants of a log.
struct HistoryRange {
  std::uint64_t id = 0;
  std::string topic;
  std::int64_t from_ns = 0;  ///< since the Unix epoch, clock of the log's host; both included
  std::int64_t to_ns = 0;
};

/// One that a rule of the configuration has made. It outlives the router.
struct RuleRequest {
  HistoryRange range;
  std::string rule;  ///< its name
};

/// Requests of this host for logs of others. Each stands as long as somebody repeats it. Pure.
class StandingRequests {
 public:
  /// Beyond 16 none is taken.
  void on_request(const HistoryRange& range, Time now);
  /// What the next message to a peer contains; each peer once a second.
  [[nodiscard]] std::vector<HistoryRange> take_for(const std::string& peer, Time now);

 private:
  struct Standing {
    HistoryRange range;
    Time said{};
  };
  std::map<std::uint64_t, Standing> standing_;
  std::map<std::string, Time> sent_;  ///< by peer
};

/// How far a request is.
enum class HistoryState : std::uint8_t { searching, sending, done };
constexpr std::array<const char*, 3> words_of(HistoryState) {
  return {"searching", "sending", "done"};
}
struct HistoryProgress {
  std::uint64_t id = 0;
  std::string topic;
  HistoryState state = HistoryState::searching;
  std::uint64_t found = 0;      ///< samples that were not delivered before, so far
  std::uint64_t delivered = 0;  ///< of these, on the other side
  std::uint64_t gone = 0;       ///< of these, no longer in the log, or damaged
};

/// Requests for what this host has logged, and how far each is. A long one is looked for in parts:
/// the next when all of the last has been delivered. Pure.
class HistoryRequests {
 public:
  using SampleId = sample_log::SampleId;

  /// Stands until `until`, or longer when it is said again. Of 64 one that is done makes room;
  /// false when none is.
  bool on_request(const HistoryRange& range, Time until);
  /// The same by a rule.
  bool on_request(const RuleRequest& request, Time until);
  /// Those of rules that are not done, when they are others than at the last call.
  [[nodiscard]] std::optional<std::vector<RuleRequest>> take_rule_requests();
  /// What is to be looked for in the log, once each: ranges whose end is past.
  [[nodiscard]] std::vector<HistoryRange> take_searches(std::int64_t wall_ns);
  /// What the log has of it, all of which is to be sent; `next_ns`: from where there is more.
  void on_found(std::uint64_t id, const std::vector<SampleId>& ids,
                std::optional<std::uint64_t> next_ns);
  /// These are on the other side, or can be sent no more.
  void on_delivered(const std::vector<SampleId>& ids);
  void on_gone(const std::vector<SampleId>& ids);
  /// Forgets the requests that nobody has repeated: what of them was not delivered yet, and no
  /// other wants.
  [[nodiscard]] std::vector<SampleId> expire(Time now);
  [[nodiscard]] std::vector<HistoryProgress> progress() const;

 private:
  struct Request {
    HistoryRange range;
    std::string rule;  ///< that made it, if any
    Time until{};
    std::int64_t next_ns = 0;  ///< where to look on
    bool is_asked = false;     ///< the log is looking
    bool has_more = true;      ///< there may be some from next_ns on
    HistoryProgress progress;
    std::set<SampleId> missing;  ///< found, and not delivered yet
  };
  void settle(const std::vector<SampleId>& ids, std::uint64_t HistoryProgress::*count);
  [[nodiscard]] bool is_wanted(const SampleId& id) const;
  void update(Request& request);

  std::map<std::uint64_t, Request> requests_;
  bool rules_changed_ = false;
};

}  // namespace tocsin::router
