// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "link_router/backfill_batch.hpp"
#include "link_router/link_router_params.hpp"
#include "link_router/transmission.hpp"
#include "sample_log/sample_id.hpp"
#include "sample_log/sample_log.hpp"

namespace tocsin::router {

/// Decides what of the log is sent when.
///
/// Each sample of a stored stream goes to the log when it is offered; it is done with when a peer
/// has it. What did not cross live is sent in batches, oldest first and in the order of each
/// writer: a sample waits while an older one of its writer may still cross live. Batches are
/// numbered; the peer confirms them in their order, at most `window` are unconfirmed, and the first
/// of them is repeated until it is. A session is one meeting of two instances: a new one sends what
/// was not confirmed again. All within a share of the capacity; when the link has room at all,
/// LinkSender::may_backfill says. What somebody requests of a history goes the same way, behind
/// all else. Pure; `now` never decreases.
class BackfillSender {
 public:
  using SampleId = sample_log::SampleId;
  explicit BackfillSender(const LinkRouterParams& params) : params_(params) {}

  /// A sample goes to the log and is offered to the link. One that is known stays what it is.
  void offer(const SampleId& id);
  /// The log has it from an earlier instance, and nobody has confirmed it: in the order of the log.
  void recover(const SampleId& id);
  /// What the log did with one that was offered.
  void on_logged(const SampleId& id, sample_log::Logged logged);
  /// Whether the log must note that it was delivered: once for each.
  [[nodiscard]] bool on_fate(const SampleId& id, LiveFate fate);
  /// The log's bounds took it. Whether it will not be sent for that.
  bool on_retired(const SampleId& id);

  /// Somebody wants one that the log has and that nothing else sends: behind all others.
  void request(const SampleId& id);
  /// Nobody wants it any more; one that is under way stays what it is.
  void withdraw(const SampleId& id);

  /// A peer that takes batches is there. Before, batches are neither read nor sent.
  void begin_session();
  void end_session();
  /// What is to be read from the log now; each is asked for once.
  [[nodiscard]] std::vector<SampleId> take_wanted();
  /// What the log gave of those that were asked for; the others it does not have.
  void on_read(const std::vector<SampleId>& asked, std::vector<sample_log::LogEntry> read);

  /// The batch to send at `now`, if any; it must be sent. `capacity_bytes_per_s` of the link.
  [[nodiscard]] std::optional<BackfillBatch> next(Time now, double capacity_bytes_per_s);
  /// When next() has something though nothing happens; `never` when it has nothing to do. Not later
  /// than `now`: at once.
  [[nodiscard]] Time deadline(Time now, double capacity_bytes_per_s) const;
  /// Those that are done with, which the log must note.
  [[nodiscard]] std::vector<SampleId> on_progress(const BackfillProgress& progress, Time now);

  /// By stream; only those of which something was offered or recovered.
  [[nodiscard]] const std::map<std::uint64_t, StoredCounts>& counts() const { return counts_; }

 private:
  /// Rises in the order of offers; those of earlier instances are before, those that
  /// were requested behind all.
  using Order = std::uint64_t;
  static constexpr Order first_offered = Order{1} << 48U;
  static constexpr Order first_requested = Order{1} << 56U;
  enum class State : std::uint8_t {
    live,       ///< may still cross live
    waiting,    ///< is to be backfilled
    asked,      ///< the log is reading it
    ready,      ///< was read
    under_way,  ///< in a batch that is not confirmed
  };
  struct Item {
    SampleId id;
    State state = State::live;
    bool refused = false;  ///< the log does not have it
    sample_log::LogEntry content;
  };
  struct Sent {
    BackfillBatch batch;
    std::vector<Order> orders;
    Time at{};
    std::size_t wire_bytes = 0;
  };
  using Writer = std::pair<std::uint64_t, std::uint64_t>;
  [[nodiscard]] static Writer writer_of(const SampleId& id) { return {id.stream, id.source}; }
  void add(Order order, const SampleId& id, State state);
  void set(Order order, Item& item, State state);
  void erase(Order order);
  /// Whether the writer offered an older one in this life: its history comes again, and the log may
  /// be read in the middle of that.
  [[nodiscard]] bool follows_an_offered(const SampleId& id) const;
  [[nodiscard]] bool is_blocked(Order order, const SampleId& id) const;
  [[nodiscard]] Sent make_batch();
  [[nodiscard]] Time repeat_at() const;
  [[nodiscard]] double allowance(Time now, double capacity_bytes_per_s) const;
  void spend(std::size_t bytes, Time now, double capacity_bytes_per_s);

  const LinkRouterParams params_;
  std::map<Order, Item> items_;
  std::map<SampleId, Order> orders_;
  std::map<Writer, std::set<Order>> live_;
  std::set<Order> waiting_;
  std::set<Order> ready_;
  std::size_t asked_ = 0;
  Order last_recovered_ = 0;
  Order last_offered_ = first_offered;
  Order last_requested_ = first_requested;
  std::map<std::uint64_t, StoredCounts> counts_;

  bool in_session_ = false;
  std::uint32_t session_ = 0;
  std::uint32_t last_number_ = 0;
  std::deque<Sent> window_;
  Time progress_{};       ///< when something was confirmed last
  Duration trip_{0};      ///< from a batch to its confirmation, smoothed
  unsigned repeats_ = 0;  ///< since then
  double bytes_ = 0;      ///< that may be sent now: a token bucket
  Time filled_{};
};

}  // namespace tocsin::router
